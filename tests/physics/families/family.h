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

/// The number of seeds that FETTLE_SEEDS asks for, else `usual`.
inline unsigned seeds_or(unsigned usual) {
    const char* const wanted = std::getenv("FETTLE_SEEDS");
    return wanted == nullptr ? usual : unsigned(std::stoul(wanted));
}

}  // namespace families
