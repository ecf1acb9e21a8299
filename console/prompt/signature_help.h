#pragma once
// Which call the cursor is in, and which of its parameters, so that the signature can be shown
// while the arguments are typed. A constructor is a call, too: `Body { mass = 2 }`.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/script/runtime.h>

namespace fettle::console {

/// The innermost call that is open at the cursor.
struct OpenCall {
    std::string_view callee;   // "world.ball:apply_impulse"
    std::size_t argument = 0;  // from 0
    std::string_view key{};    // of the value in a table that is the argument; "" if it has none
};
std::optional<OpenCall> open_call(std::string_view text, std::size_t cursor);

/// The bytes of a parameter in a signature such as "f(a: number, b?: vec2): text"; an empty range
/// if it has no such parameter. The last one counts for all that follow if it is "...".
struct ParameterRange {
    std::size_t begin = 0, end = 0;
};
ParameterRange parameter_of(std::string_view signature, std::size_t index);
/// The same for a property in the text of a constructor such as "Body { type, position, … }".
ParameterRange property_in(std::string_view constructor, std::string_view name);

/// Remembers the signature of the call that was requested last.
class SignatureHelp {
  public:
    using Complete =
        std::function<std::vector<script::Completion>(std::string_view input, std::size_t cursor)>;
    explicit SignatureHelp(Complete complete) : complete_(std::move(complete)) {}

    struct Shown {
        std::string text;  // "apply_impulse(impulse: vec2, point?: vec2)"
        ParameterRange parameter;
        std::string doc{};  // the first sentence of the documentation
    };
    /// None outside of a call, and for a function that is not known.
    std::optional<Shown> at(std::string_view text, std::size_t cursor);

  private:
    Complete complete_;
    std::string callee_, signature_, doc_;
};

}  // namespace fettle::console
