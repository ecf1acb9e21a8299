#pragma once
// Results for programs: one JSON object a line.

#include <initializer_list>
#include <string>
#include <utility>
#include <variant>

namespace fettle::bench {

/// nil prints as null.
using JsonField = std::variant<std::monostate, std::string, double, long long>;

/// {"scene":"smash","ms":1.5}, fields in the order given. Numbers that are not finite become null.
std::string json_line(std::initializer_list<std::pair<const char*, JsonField>> fields);

}  // namespace fettle::bench
