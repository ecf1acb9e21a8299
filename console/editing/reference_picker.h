#pragma once
// A list for choosing an instance: all valid values of a reference property, filtered by typing.
// The arrow keys move a mark, Enter chooses.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <fettle/property/tree.h>

namespace fettle::console {

class ReferencePicker {
  public:
    explicit ReferencePicker(const property::Tree& tree) : tree_(tree) {}

    /// Draws a small button that opens the list. Returns the chosen instance; a null handle means
    /// nil, which is offered if the property accepts it.
    std::optional<property::Handle> draw(const property::Property& property,
                                         property::Handle current);

  private:
    void take_candidates(const property::Property& property);
    bool move_mark();

    const property::Tree& tree_;
    std::string search_, taken_for_;
    std::vector<property::Handle> candidates_;  // the best first; a null handle for nil
    std::size_t marked_ = 0;                    // what Enter chooses
    bool stale_ = true;
};

}  // namespace fettle::console
