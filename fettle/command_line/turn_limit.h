#pragma once
// The last resort against a game that is not trusted. Budgets stop scripts at an instruction; the
// garbage collector of Lua and a step of the physics have none.

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

namespace fettle::program {

/// Ends the process with a message and the status of an error, if two calls of `turn_ends` are
/// further apart than a number of seconds. Only its own thread measures time, so time during which
/// the process did not run does not count.
class TurnLimit {
  public:
    /// 0: no limit.
    explicit TurnLimit(double seconds);
    ~TurnLimit();
    TurnLimit(const TurnLimit&) = delete;

    /// `steps`: how many the game has made.
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
