#pragma once
// A function of a script that says which instances count: handed to a method whose last parameter
// is called `accept`, as in world:raycast(a, b, nil, nil, function(shape) return shape ~= mine
// end).

#include <functional>
#include <string_view>

#include <fettle/property/export.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

class Acceptance {
  public:
    /// What the parameter is called. Its value is true when a function was given.
    static constexpr std::string_view parameter = "accept";

    /// In force on this thread while it lives.
    explicit Acceptance(std::function<bool(Handle)> accepts);
    ~Acceptance();
    Acceptance(const Acceptance&) = delete;
    Acceptance& operator=(const Acceptance&) = delete;

    /// What the function of the method that is being called says; true where there is none.
    static bool accepts(Handle instance);

  private:
    std::function<bool(Handle)> accepts_;
    const Acceptance* before_;
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
