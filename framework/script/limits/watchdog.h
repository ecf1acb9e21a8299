#pragma once
// Stops a call into the game's scripts that does not return: an endless loop in a callback, a
// handler, main.lua. A hook that counts instructions would make all scripts 2.4 times slower, so
// none is set in normal operation. A thread checks ten times a second whether the host is still in
// the same call; if that takes too long, it sends the host's thread a signal, whose handler sets
// the hook, which runs before the next instruction of Lua and ends the call or lets it continue. A
// signal is necessary because a running Lua state can be used only on its own thread. The thread
// starts with the first call.

#include <pthread.h>
#include <atomic>
#include <functional>
#include <memory>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

class Watchdog {
  public:
    explicit Watchdog(Machine& machine);
    ~Watchdog();
    Watchdog(const Watchdog&) = delete;

    /// Returns whether a call that takes long may continue. The Lua thread is that of the call.
    using GoOn = std::function<bool(lua_State*, double seconds)>;
    /// See `Runtime::limit_calls`.
    void limit(double seconds, GoOn go_on);

    /// A call of the host; nested calls belong to it.
    class Call {
      public:
        explicit Call(Watchdog& watchdog) : watchdog_(watchdog) { watchdog_.begin(); }
        ~Call() { watchdog_.end(); }
        Call(const Call&) = delete;

      private:
        Watchdog& watchdog_;
    };

    bool limited() const { return limit_ > 0; }
    double limit_seconds() const { return limit_; }  // s
    /// Whether the running call was not made by another one.
    bool outermost() const { return depth_ == 1; }
    /// Whether the last call was stopped.
    bool stopped() const { return stopped_; }
    /// If the call has taken too long, calls `go_on_` and stops the call if that returns false.
    /// Cheap otherwise.
    void check_if_due(lua_State* L) {
        if (due_.load(std::memory_order_relaxed)) [[unlikely]]
            check(L);
    }

  private:
    struct Thread;

    void begin() {
        if (depth_++ > 0) return;
        stopped_ = false;
        if (limit_ > 0) begin_outermost();
    }
    void end() {
        if (--depth_ == 0) end_call();
    }
    void start();
    void end_call();
    void begin_outermost();
    void end_outermost();
    void check(lua_State* L);
    void count_call() {  // no other thread writes it
        serial_.store(serial_.load(std::memory_order_relaxed) + 1, std::memory_order_release);
    }

    Machine& machine_;
    double limit_ = 0;          // s, the longest duration of a call; 0: calls are not limited
    Machine* outer_ = nullptr;  // machine of the outer call on this thread
    int depth_ = 0;
    bool watched_ = false;  // whether the outermost call is limited
    bool in_go_on_ = false;
    bool stopped_ = false;
    std::atomic<std::uint64_t> serial_{0};  // odd during a call
    std::atomic<pthread_t> host_{};         // the thread of the latest call
    std::atomic<bool> due_{false};
    std::atomic<double> seconds_{0};  // duration of the call, s
    GoOn go_on_;
    std::unique_ptr<Thread> thread_;
};

}  // namespace fettle::script
