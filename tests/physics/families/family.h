#pragma once
// Seeds of families of tests: random numbers that are equal on every machine, and how many worlds.

#include <cstdlib>
#include <random>
#include <string>

namespace families {

struct Random {
    std::mt19937 engine;
    float operator()(float low, float high) {
        return low + (high - low) * float(engine()) / 4294967296.0f;
    }
};

/// The number of seeds of a test: FETTLE_SEEDS if that is set; else `usual`, FETTLE_SOAK times.
inline unsigned seeds_or(unsigned usual) {
    if (const char* const seeds = std::getenv("FETTLE_SEEDS")) return unsigned(std::stoul(seeds));
    const char* const factor = std::getenv("FETTLE_SOAK");
    return factor == nullptr ? usual : usual * unsigned(std::stoul(factor));
}

}  // namespace families
