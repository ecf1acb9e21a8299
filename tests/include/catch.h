#pragma once
// Catch2 2 and 3 have their headers in different places and some different names; tests include
// this header.

#include <string>

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
/// Matches a text that contains `part`.
inline auto contains(const std::string& part) {
    return Catch::Matchers::ContainsSubstring(part);
}
#else
#include <catch2/catch.hpp>
inline auto contains(const std::string& part) {
    return Catch::Matchers::Contains(part);
}
#endif

#include "checks.h"
