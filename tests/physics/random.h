#pragma once

#include <random>

namespace scenes {

/// Random numbers that are equal on every machine. Arguments of a function are computed in another
/// order by each compiler, so no two of them should be random.
struct Random {
    std::mt19937 engine;
    float operator()(float low, float high) {
        return low + (high - low) * float(engine()) / 4294967296.0f;
    }
};

/// Steps in a second for a seed: 30, 60 and 144 by turns.
inline float rate_of(unsigned seed) {
    constexpr float rates[] = {30, 60, 144};
    return rates[seed % 3];
}

}  // namespace scenes
