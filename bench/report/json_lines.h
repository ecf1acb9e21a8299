#pragma once
// Results for programs: one JSON object per line.

#include <initializer_list>
#include <string>
#include <utility>
#include <variant>

namespace fettle::bench {

/// A monostate is printed as null.
using JsonField = std::variant<std::monostate, std::string, double, long long>;

/// {"scene":"smash","ms":1.5}, with the fields in the given order. Infinity and NaN become null.
std::string json_line(std::initializer_list<std::pair<const char*, JsonField>> fields);

}  // namespace fettle::bench
