#pragma once
// Clocks, and the statistics that make sense of a noisy one.

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace fettle::bench {

/// Milliseconds of wall time.
class WallClock {
  public:
    double elapsed_ms() const {
        return std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
    }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

/// Milliseconds this thread spent on a processor: what others do to the machine counts less.
class ThreadClock {
  public:
    ThreadClock() : start_(now_ms()) {}
    double elapsed_ms() const { return now_ms() - start_; }

  private:
    static double now_ms();
    double start_;
};

/// Of an even number of values, the mean of the middle two. `values` must not be empty.
double median(std::vector<double> values);

struct Interval {
    double low = 0;
    double high = 0;
};

/// A confidence interval of at least 95 % for the median, from order statistics: needs no
/// assumption about how the values are distributed (W. J. Conover, Practical Nonparametric
/// Statistics, section 3.2). With fewer than six values there is none, and the extremes are
/// returned.
Interval median_interval(std::vector<double> values);

}  // namespace fettle::bench
