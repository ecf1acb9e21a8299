#pragma once
// Whether the selected instances have different values of a property. A row compares a few of them
// in each frame, so thousands of selected instances cost no more than a few.

#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include <fettle/property/tree.h>

namespace fettle::console {

class MixedValues {
  public:
    /// The other selected instances are these from now on. `revision`: a number that changes
    /// whenever they do.
    void compare_with(const std::vector<property::Handle>& others, std::uint64_t revision);
    const std::vector<property::Handle>& others() const { return others_; }
    /// The property of another selected instance with that name and type; null if it has none.
    static const property::Property* same(const property::Tree& tree, property::Handle other,
                                          const property::Property& property);
    /// "" if the values are equal, as far as they were compared; otherwise the text to show, such
    /// as "mixed: 1 to 5 kg".
    std::string text(const property::Tree& tree, const property::Property& property,
                     const property::Value& value);

  private:
    struct Comparison {
        std::size_t next = 0;                   // index of the instance that is compared next
        bool differ = false, differed = false;  // in this round; in the last complete one
        const property::Class* of = nullptr;    // of the last one, if it declares the property
        const property::Property* found = nullptr;
        // Of this round, and of the last complete one. The y of numbers is 0.
        property::Vec2 low{}, high{}, lowest{}, highest{};
    };
    static std::string range_text(const Comparison& row, bool vector);

    std::vector<property::Handle> others_;
    std::uint64_t revision_ = 0;
    std::unordered_map<const property::Property*, Comparison> rows_;
};

}  // namespace fettle::console
