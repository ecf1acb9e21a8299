#pragma once
// A function of a script that says which instances count: handed to a method whose last parameter
// is called `accept`, as in world:raycast(a, b, nil, nil, function(shape) return shape ~= mine
// end). It is asked in the middle of a search, so it may read everything and change nothing
// (`Inquiry`).

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

class Acceptance {
  public:
    /// What the parameter is called. Its value is true when a function was given.
    static constexpr std::string_view parameter = "accept";

    /// In force on this thread while it lives. `method`: what it was handed to, for messages.
    Acceptance(Tree& tree, std::string method, std::function<bool(Handle)> accepts);
    ~Acceptance();
    Acceptance(const Acceptance&) = delete;
    Acceptance& operator=(const Acceptance&) = delete;

    /// What the function of the method that is being called says; true where there is none. Throws
    /// nothing, since no search is made to be left in its middle: once the function has thrown, it
    /// is asked no more and accepts nothing.
    static bool accepts(Handle instance) noexcept;
    /// To be called when the method has returned: throws what the function has thrown.
    void finish() const;
    /// What the function in force has said so far; nothing where there is none. Who calls the
    /// method again gives the same answers.
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
