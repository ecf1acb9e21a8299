#pragma once
// What other engines call the things that have another name here: `pos` for `position`, `r` for
// `radius`, the key "return" for "enter". Words only; whether a class has what is meant, its
// descriptor tells.

#include <string>
#include <string_view>
#include <vector>

namespace fettle::script {

/// Names of properties, or of keys of a keyboard, that the user may mean by `name`; the likeliest
/// first. A part after a blank says how to write it: "position = vec(x, y)".
std::vector<std::string_view> property_synonyms(std::string_view name);
/// Callbacks and events that a function called `name` may be meant for.
std::vector<std::string_view> callback_synonyms(std::string_view name);

}  // namespace fettle::script
