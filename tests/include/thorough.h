#pragma once
// Long lists of cases: a quick run takes some of them, a thorough one all.

#include <cstddef>
#include <cstdlib>

/// FETTLE_THOROUGH is set: `./check --sanitize` and `./check --full` do that.
inline bool thorough() {
    static const bool all = std::getenv("FETTLE_THOROUGH") != nullptr;
    return all;
}

/// Whether case number `i` is tried: every `n`-th, and each in a thorough run.
inline bool taken(std::size_t i, std::size_t n) {
    return thorough() || i % n == 0;
}
