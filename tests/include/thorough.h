#pragma once
// Long lists of cases: a quick run takes some of them, a thorough one all.

#include <cstddef>
#include <cstdlib>

/// Whether case number `i` is tried: every `n`-th, and each where FETTLE_THOROUGH is set, which
/// `./check --full` does.
inline bool taken(std::size_t i, std::size_t n) {
    static const bool all = std::getenv("FETTLE_THOROUGH") != nullptr;
    return all || i % n == 0;
}
