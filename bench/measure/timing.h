#pragma once
// Clocks, and statistics of noisy times.

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

/// Milliseconds that this thread spent on a processor. It is less sensitive to other load than wall
/// time.
class ThreadClock {
  public:
    ThreadClock() : start_(now_ms()) {}
    double elapsed_ms() const { return now_ms() - start_; }

  private:
    static double now_ms();
    double start_;
};

/// For an even number of values, the mean of the middle two. `values` must not be empty.
double median(std::vector<double> values);

struct Interval {
    double low = 0;
    double high = 0;
};

/// A confidence interval of at least 95 % for the median, from order statistics. It assumes nothing
/// about the distribution of the values (W. J. Conover, Practical Nonparametric Statistics, section
/// 3.2). For fewer than six values no such interval exists, and the extremes are returned.
Interval median_interval(std::vector<double> values);

}  // namespace fettle::bench
