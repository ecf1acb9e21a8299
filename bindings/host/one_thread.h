#pragma once

#include <atomic>

namespace fettle::host {

/// Its address tells threads apart. Reading a property by handle costs some nanoseconds, and a
/// thread_local of the usual kind would cost a third of that.
extern constinit thread_local char thread_mark __attribute__((tls_model("initial-exec")));

/// Only one thread may use the games of a process: the one that created the first of them, until
/// all are destroyed.
class OneThread {
  public:
    /// Registers a game of this thread. Throws Failure(FETTLE_LOCKED) if another thread has games.
    OneThread();
    ~OneThread();
    OneThread(const OneThread&) = delete;
    OneThread& operator=(const OneThread&) = delete;

    /// True in the thread of the games, and where there are none.
    static bool is_here() noexcept {
        const char* const holder = holder_.load(std::memory_order_relaxed);
        return holder == &thread_mark || holder == nullptr;
    }
    /// Throws Failure(FETTLE_LOCKED) unless `is_here`.
    static void require();

  private:
    static std::atomic<const char*> holder_;  ///< the mark of the thread of the games
    static int games_;                        ///< only the thread of the games uses it
};

}  // namespace fettle::host
