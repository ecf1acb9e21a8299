#pragma once
// Stops a call into the game's scripts that does not return: an endless loop in a callback, a
// handler, main.lua. A hook that counts instructions would make all scripts 2.4 times slower, so
// none is set in normal operation. A thread checks ten times a second whether the host is still in
// the same call; if that takes too long, it sends the host's thread a signal, whose handler sets
// the hook, and the next instruction of Lua asks whether the call may go on. A signal, because a
// running state of Lua can be used only on its own thread. The thread starts with the first call.

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

    /// Decides whether a long call may go on; the thread is in that call.
    using Question = std::function<bool(lua_State*, double seconds)>;
    /// As `Runtime::limit_calls`.
    void limit(double seconds, Question go_on);

    /// A call of the host; one inside of another belongs to it.
    class Call {
      public:
        explicit Call(Watchdog& watchdog) : watchdog_(watchdog) { watchdog_.begin(); }
        ~Call() { watchdog_.end(); }
        Call(const Call&) = delete;

      private:
        Watchdog& watchdog_;
    };

    /// Whether the last call was stopped.
    bool stopped() const { return stopped_; }
    /// Asks about the call if it is due; stops it when it may not go on. Cheap when it is not.
    void look(lua_State* L) {
        if (due_.load(std::memory_order_relaxed)) [[unlikely]]
            ask(L);
    }

  private:
    struct Thread;

    void begin() {
        if (depth_++ > 0) return;
        stopped_ = false;
        if (patience_ > 0) begin_outermost();
    }
    void end() {
        if (--depth_ == 0 && watched_) end_outermost();
    }
    void start();
    void begin_outermost();
    void end_outermost();
    void ask(lua_State* L);
    void count_call() {  // no other thread writes it
        serial_.store(serial_.load(std::memory_order_relaxed) + 1, std::memory_order_release);
    }

    Machine& machine_;
    double patience_ = 0;       // s; 0: calls last as long as they like
    Machine* outer_ = nullptr;  // in whose call on this thread this one began
    int depth_ = 0;
    bool watched_ = false;  // the outermost call
    bool asking_ = false;
    bool stopped_ = false;
    std::atomic<std::uint64_t> serial_{0};  // odd while a call is under way
    std::atomic<pthread_t> host_{};         // the thread of the latest call
    std::atomic<bool> due_{false};
    std::atomic<double> seconds_{0};  // that the call has lasted
    Question go_on_;
    std::unique_ptr<Thread> thread_;
};

}  // namespace fettle::script
