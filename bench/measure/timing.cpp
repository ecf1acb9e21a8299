#include "measure/timing.h"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fettle::bench {

double ThreadClock::now_ms() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

Interval median_interval(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const auto n = static_cast<int>(values.size());
    // Excludes the k smallest and the k largest values. k is the largest number such that at most k
    // of n fair coins show heads with a probability of at most 2.5 %.
    double probability = std::pow(0.5, n);
    double cumulative = probability;
    int k = 0;
    while (k < n / 2) {
        if (cumulative > 0.025) break;
        ++k;
        probability *= static_cast<double>(n - k + 1) / k;
        cumulative += probability;
    }
    const int left_out = std::max(0, k - 1);
    return {values[static_cast<std::size_t>(left_out)],
            values[static_cast<std::size_t>(n - 1 - left_out)]};
}

}  // namespace fettle::bench
