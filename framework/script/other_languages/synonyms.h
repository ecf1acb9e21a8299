#pragma once
// Names from other engines for properties, methods, keys and callbacks: `pos` for `position`, `r`
// for `radius`, the key "return" for "enter". The caller must check whether a class has the
// returned name.

#include <string>
#include <string_view>
#include <vector>

#include <fettle/script/synonyms.h>

namespace fettle::script {

/// `linear_velocity` for `getLinearVelocity` and `set_linear_velocity`; "" for any other name.
std::string without_get_or_set(std::string_view name);
/// `angular_velocity` for `angularVelocity`.
std::string snake_case(std::string_view name);
/// ` (did you mean position = vec(x, y)?)`: how to write what is meant.
std::string hint_of(std::string_view meant);
/// Callbacks and events that a function named `name` may be meant for.
std::vector<std::string_view> callback_synonyms(std::string_view name);

}  // namespace fettle::script
