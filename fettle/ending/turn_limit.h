#pragma once
// A time limit for games that are not trusted. Budgets stop scripts only between instructions, not
// in Lua's garbage collector or in a step of physics.

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

namespace fettle::program {

/// Ends the process with a message and an error status if the time between two calls of `turn_ends`
/// is longer than the limit. A separate thread counts the time, so time in which the process is
/// stopped does not count.
class TurnLimit {
  public:
    /// 0: no limit.
    explicit TurnLimit(double seconds);
    ~TurnLimit();
    TurnLimit(const TurnLimit&) = delete;

    /// `steps`: number of steps that the game has made.
    void turn_ends(std::uint64_t steps);

  private:
    void watch();

    const double seconds_;
    std::mutex mutex_;
    std::condition_variable wake_;
    double lasted_ = 0;        // of this turn, s
    std::uint64_t steps_ = 0;  // before this turn
    bool ends_ = false;
    std::thread thread_;
};

}  // namespace fettle::program
