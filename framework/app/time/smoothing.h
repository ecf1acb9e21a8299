#pragma once

#include <cmath>

namespace fettle::app {

/// Exponential moving average with a time constant of half a second.
inline void smooth(double& average, double sample, double seconds) {
    average += (sample - average) * (1 - std::exp(-seconds / 0.5));
}

}  // namespace fettle::app
