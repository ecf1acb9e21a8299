#pragma once
// The name `it`, the selected instance, in the text of a formula or of an observed expression.

#include <string>
#include <string_view>

namespace fettle::script {

/// Whether the text reads the global `it`: not a field `x.it`, a key `{ it = 1 }`, a variable or a
/// parameter of that name, or a word in a string or a comment.
bool mentions_it(std::string_view source);
/// The text with `path` in place of each such `it`.
std::string with_it_named(std::string_view source, std::string_view path);

}  // namespace fettle::script
