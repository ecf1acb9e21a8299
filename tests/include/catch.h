#pragma once
// Catch2 2 and 3 keep their headers in different places and call some things differently; tests
// include this one.

#include <string>

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
/// Matches a text that has `part` in it.
inline auto contains(const std::string& part) {
    return Catch::Matchers::ContainsSubstring(part);
}
#else
#include <catch2/catch.hpp>
inline auto contains(const std::string& part) {
    return Catch::Matchers::Contains(part);
}
#endif
