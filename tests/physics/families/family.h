#pragma once
// Seeds of families of tests: random numbers that are equal on every machine, and how many worlds.

#include <fettle/physics/types.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "random.h"
#include "thorough.h"

namespace families {

using scenes::Random;

/// The unit vector in that direction.
inline fettle::physics::Vec2 turned(float angle) {
    return {std::cos(angle), std::sin(angle)};
}

/// The number of seeds of a test: FETTLE_SEEDS if that is set; if FETTLE_SOAK is, that many times
/// `usual`, but no more than 5 000; else `usual` in a thorough run and an eighth of it in a quick
/// one.
inline unsigned seeds_or(unsigned usual) {
    if (const char* const seeds = std::getenv("FETTLE_SEEDS")) return unsigned(std::stoul(seeds));
    if (const char* const factor = std::getenv("FETTLE_SOAK"))
        return std::max(usual, std::min(5000u, usual * unsigned(std::stoul(factor))));
    return thorough() ? usual : (usual + 7) / 8;
}

}  // namespace families
