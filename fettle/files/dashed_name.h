#pragma once

#include <string>
#include <string_view>

namespace fettle::program {

/// The name for files and ids: its letters and digits in ASCII, in lower case, with one dash for
/// all other characters between two of them. It may be empty.
inline std::string dashed_name(std::string_view name) {
    std::string dashed;
    for (const char c : name) {
        const char lower = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        const bool plain = (lower >= 'a' && lower <= 'z') || (lower >= '0' && lower <= '9');
        if (plain || (!dashed.empty() && dashed.back() != '-')) dashed += plain ? lower : '-';
    }
    while (!dashed.empty() && dashed.back() == '-') dashed.pop_back();
    return dashed;
}

}  // namespace fettle::program
