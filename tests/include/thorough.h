#pragma once
// Long lists of cases: a quick run tests some of them, a thorough run all.

#include <cstddef>
#include <cstdlib>

/// True if FETTLE_THOROUGH is set, as `./check --sanitize` and `./check --full` do.
inline bool thorough() {
    static const bool all = std::getenv("FETTLE_THOROUGH") != nullptr;
    return all;
}

/// Whether case number `i` is tested: every `n`-th, and all in a thorough run.
inline bool is_tested(std::size_t i, std::size_t n) {
    return thorough() || i % n == 0;
}
