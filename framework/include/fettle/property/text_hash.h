#pragma once
// A short hash of a text.

#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

#include <fettle/property/export.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// FNV-1a: the same on every machine, in every run and in every version.
constexpr std::uint32_t text_hash(std::string_view text) {
    std::uint32_t hash = 2166136261u;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    return hash;
}

/// The hash as eight hexadecimal digits.
inline std::string text_hash_digits(std::string_view text) {
    char digits[9];
    std::snprintf(digits, sizeof digits, "%08x", static_cast<unsigned>(text_hash(text)));
    return digits;
}

}  // namespace fettle::property

FETTLE_PROPERTY_END
