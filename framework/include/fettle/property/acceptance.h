#pragma once
// A function of a script that accepts or rejects instances. It is an argument of a method whose
// last parameter is called `accept`, as in world:raycast(a, b, nil, nil, function(shape) return
// shape ~= mine end). It is called in the middle of a search, so it may read everything and must
// not change anything (`Inquiry`).

#include <cstdint>
#include <exception>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/export.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

class Tree;

/// A function of a script or of the host that decides what a search may find.
class Acceptance {
  public:
    /// Name of the parameter. Its value is true if there is a function.
    static constexpr std::string_view parameter_name = "accept";

    /// It is in use on this thread while the object lives. `method`: name of the method, for
    /// messages.
    Acceptance(Tree& tree, std::string method, std::function<bool(Handle)> accepts);
    ~Acceptance();
    Acceptance(const Acceptance&) = delete;
    Acceptance& operator=(const Acceptance&) = delete;

    /// The answer of the function in use; true if there is none. Never throws, because a search
    /// cannot be interrupted: after an exception, the function is not called any more and all
    /// answers are false.
    static bool is_accepted(Handle instance) noexcept;
    /// Call it after the method has returned: throws the exception of the function, if there was
    /// one.
    void finish() const;
    /// The answers of the function in use so far; empty if there is none. A replay of the call
    /// gives the same answers.
    static std::vector<std::uint8_t> answers();

  private:
    Tree& tree_;
    std::string method_;
    std::function<bool(Handle)> accepts_;
    Acceptance* outer_;
    std::exception_ptr thrown_;
    std::vector<std::uint8_t> answers_;
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
