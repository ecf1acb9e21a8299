#pragma once
// Numbers with a fixed number of decimals, for people.

#include <charconv>
#include <string>

#include <fettle/property/export.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// The number with so many decimals, and with a point in every locale of the program: "2.50".
inline std::string fixed_text(double number, int decimals) {
    char text[400];
    const auto [end, error] =
        std::to_chars(text, text + sizeof text, number, std::chars_format::fixed, decimals);
    return error == std::errc() ? std::string(text, end) : std::string("?");
}

}  // namespace fettle::property

FETTLE_PROPERTY_END
