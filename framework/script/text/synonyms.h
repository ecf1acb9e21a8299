#pragma once
// What other engines call the things that have another name here: `pos` for `position`, `r` for
// `radius`, the key "return" for "enter". Words only; whether a class has what is meant, its
// descriptor tells.

#include <string>
#include <string_view>
#include <vector>

namespace fettle::script {

/// Names that a property, or a key of a keyboard, may have that somebody calls `name`; the
/// likeliest first. A part behind a blank tells how it is written: "position = vec(x, y)".
std::vector<std::string_view> property_synonyms(std::string_view name);
/// Callbacks and events that a function called `name` may be meant for.
std::vector<std::string_view> callback_synonyms(std::string_view name);

}  // namespace fettle::script
