#include <checks/hooks.h>

#include <atomic>
#include <mutex>

namespace fettle::physics {

namespace detail {
namespace {

/// A function of the host with its pointer. They are read together, because another thread may set
/// them.
template <class Function>
struct Hook {
    std::mutex mutex;
    Function function = nullptr;
    void* user = nullptr;
    std::atomic<bool> is_set = false;

    void set(Function wanted, void* pointer) {
        const std::lock_guard lock(mutex);
        function = wanted;
        user = pointer;
        is_set.store(wanted != nullptr, std::memory_order_relaxed);
    }
};

Hook<LogFunction> the_log;
Hook<FailureFunction> the_failure;

}  // namespace

bool is_logged() noexcept {
    return the_log.is_set.load(std::memory_order_relaxed);
}

void log(LogLevel level, const std::string& text) noexcept {
    if (!is_logged()) return;
    LogFunction function;
    void* user;
    {
        const std::lock_guard lock(the_log.mutex);
        function = the_log.function;
        user = the_log.user;
    }
    if (function == nullptr) return;
    try {
        function(user, level, text.c_str());  // without the lock: it may set another log
    } catch (...) {
        // Where the library logs, it cannot stop.
    }
}

bool are_steps_checked() noexcept {
    return the_failure.is_set.load(std::memory_order_relaxed);
}

FailureHook failure_hook() noexcept {
    const std::lock_guard lock(the_failure.mutex);
    return {the_failure.function, the_failure.user};
}

}  // namespace detail

void set_log(LogFunction function, void* user) noexcept {
    detail::the_log.set(function, user);
}

void set_failure_function(FailureFunction function, void* user) noexcept {
    detail::the_failure.set(function, user);
}

}  // namespace fettle::physics
