#pragma once

#include <atomic>
#include <thread>

namespace fettle::host {

/// The games of a process belong to the thread that created the first of them, until all are
/// destroyed.
class OneThread {
  public:
    /// A game belongs to this thread. Throws Failure(FETTLE_LOCKED) if there are games of another.
    OneThread();
    ~OneThread();
    OneThread(const OneThread&) = delete;
    OneThread& operator=(const OneThread&) = delete;

    /// True in the thread of the games, and where there are none.
    static bool is_here() noexcept {
        const std::thread::id holder = holder_.load(std::memory_order_relaxed);
        return holder == std::this_thread::get_id() || holder == std::thread::id();
    }
    /// Throws Failure(FETTLE_LOCKED) unless `is_here`.
    static void require();

  private:
    static std::atomic<std::thread::id> holder_;
    static int games_;  ///< only the thread of the games uses it
};

}  // namespace fettle::host
