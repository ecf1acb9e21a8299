#pragma once
// A function of a script that says which instances count: handed to a method whose last parameter
// is called `accept`, as in world:raycast(a, b, nil, nil, function(shape) return shape ~= mine
// end). It is asked in the middle of a query, so it reads the tree and writes nothing.

#include <functional>
#include <string>
#include <string_view>

#include <fettle/property/export.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

class Tree;

class Acceptance {
  public:
    /// What the parameter is called. Its value is true when a function was given.
    static constexpr std::string_view parameter = "accept";

    /// In force on this thread while it lives; nothing of the tree can be written meanwhile.
    /// `asker`: the method, as errors name it.
    Acceptance(Tree& tree, std::string asker, std::function<bool(Handle)> accepts);
    ~Acceptance();
    Acceptance(const Acceptance&) = delete;
    Acceptance& operator=(const Acceptance&) = delete;

    /// What the function of the method that is being called says; true where there is none.
    static bool accepts(Handle instance);
    /// The one in force on this thread; null where there is none.
    static const Acceptance* current();
    const std::string& asker() const { return asker_; }

  private:
    void put_in_force(const Acceptance* which);

    Tree& tree_;
    std::string asker_;
    std::function<bool(Handle)> accepts_;
    const Acceptance* before_;
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
