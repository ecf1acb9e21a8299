#include <pthread.h>
#include <signal.h>
#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <system_error>
#include <thread>

#include <limits/limiters.h>
#include <limits/watchdog.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <lua/runtime_lifetime.h>

namespace fettle::script {

namespace {

/// The interval at which calls are looked at, s: a call is stopped at most about a quarter of its
/// limit late, and the thread that looks needs little time.
double tick_for(double limit) {
    return std::clamp(0.25 * limit, 0.001, 0.1);
}

// This signal is ignored by default, and few programs use it.
constexpr int signal_number = SIGURG;

// The machine that this thread is calling, for the signal handler.
thread_local Machine* volatile in_call = nullptr;

void on_signal(int) {
    Machine* const machine = in_call;
    if (machine == nullptr) return;
    Budget::arm(machine->lua.running);
}

}  // namespace

/// The thread that reads the watchdog's counters.
struct Watchdog::Thread {
    explicit Thread(Watchdog& of)
        : watchdog(of), limit(of.limit_), tick(tick_for(limit)), runner([this] { run(); }) {}
    ~Thread() {
        {
            const std::lock_guard lock(mutex);
            ends = true;
        }
        wake.notify_one();
        runner.join();
    }

    // Counts ticks and not clock time, so that time in which this thread did not run (the computer
    // slept, a debugger stopped it) does not count.
    void run() {
        std::uint64_t seen = 0;
        double seconds = 0;
        std::unique_lock lock(mutex);
        while (!wake.wait_for(lock, tick, [this] { return ends; })) {
            const std::uint64_t now = watchdog.serial_.load(std::memory_order_acquire);
            seconds = now == seen && now % 2 == 1 ? seconds + tick.count() : 0;
            seen = now;
            if (seconds < limit || now % 2 == 0) continue;
            watchdog.seconds_.store(seconds, std::memory_order_relaxed);
            watchdog.due_.store(true, std::memory_order_relaxed);
            pthread_kill(watchdog.host_.load(std::memory_order_relaxed), signal_number);
        }
    }

    Watchdog& watchdog;
    const double limit;  // s
    const std::chrono::duration<double> tick;
    std::mutex mutex;
    std::condition_variable wake;
    bool ends = false;
    std::thread runner;  // must be last, because it uses the other members
};

Watchdog::Watchdog(Machine& machine) : machine_(machine) {}

Watchdog::~Watchdog() = default;

void Watchdog::limit(double seconds, GoOn go_on) {
    thread_.reset();
    due_.store(false, std::memory_order_relaxed);
    go_on_ = std::move(go_on);
    limit_ = seconds > 0 ? seconds : 0;
    if (watched_ && limit_ > 0) start();
}

void Watchdog::start() {
    struct sigaction action {};
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    sigaction(signal_number, &action, nullptr);
    try {
        thread_ = std::make_unique<Thread>(*this);
    } catch (const std::system_error&) {
        limit_ = 0;  // the system cannot create a thread, so calls are not limited
    }
}

void Watchdog::begin_outermost() {
    if (thread_ == nullptr && limit_ > 0) [[unlikely]]
        start();
    host_.store(pthread_self(), std::memory_order_relaxed);
    count_call();
    watched_ = true;
    outer_ = in_call;
    in_call = &machine_;
}

void Watchdog::end_outermost() {
    watched_ = false;
    count_call();
    in_call = outer_;
    due_.store(false, std::memory_order_relaxed);
}

void Watchdog::end_call() {
    if (watched_) end_outermost();
    machine_.limiters.budget.call_ended();
}

// The function may run Lua as well (in a console). It does so on another Lua thread, because hooks
// are off in a thread that is inside a hook.
void Watchdog::check(lua_State* L) {
    due_.store(false, std::memory_order_relaxed);
    if (in_go_on_ || depth_ == 0 || thread_ == nullptr || machine_.limiters.budget.counting() ||
        machine_.limiters.budget.stopping())
        return;
    const double seconds = seconds_.load(std::memory_order_relaxed);
    bool goes_on = false;
    if (go_on_) {
        in_go_on_ = true;
        struct Aside {
            Machine& machine;
            Watchdog& watchdog;
            lua_State* const main;
            lua_State* const running;
            int reference;
            Aside(Machine& m, Watchdog& w, lua_State* at)
                : machine(m), watchdog(w), main(m.lua.main), running(m.lua.running) {
                machine.lua.main = machine.lua.running = lua_newthread(at);
                lua_sethook(machine.lua.main, nullptr, 0, 0);
                reference = luaL_ref(at, LUA_REGISTRYINDEX);
            }
            ~Aside() {
                machine.lua.main = main;
                machine.lua.running = running;
                luaL_unref(main, LUA_REGISTRYINDEX, reference);
                watchdog.in_go_on_ = false;
            }
        } aside(machine_, *this, L);
        const auto go_on = go_on_;  // a copy, because the call may replace it
        goes_on = go_on(L, seconds);
    }
    // If the runtime was destroyed meanwhile, the call could not be ended later.
    if (goes_on && machine_.life.orphan == nullptr) return;
    char text[80];
    std::snprintf(text, sizeof text, "stopped: it ran for %.1f seconds and did not come back",
                  seconds);
    stopped_ = true;
    machine_.limiters.budget.stop(L, text);
}

}  // namespace fettle::script
