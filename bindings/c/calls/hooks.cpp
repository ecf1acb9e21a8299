#include <fettle/physics_c/hooks.h>

#include <fettle/physics/hooks.h>

#include <mutex>

#include <calls/calls.h>

namespace fettle::physics_c {
namespace {

/// The functions in C of the process. The library gets functions of its own types, which call them.
struct Hooks {
    std::mutex mutex;
    fettle_log_function log = nullptr;
    void* log_user = nullptr;
    fettle_failure_function failure = nullptr;
    void* failure_user = nullptr;
};

Hooks& hooks() {
    static Hooks all;
    return all;
}

void write_log(void*, physics::LogLevel level, const char* text) {
    fettle_log_function function;
    void* user;
    {
        const std::lock_guard lock(hooks().mutex);
        function = hooks().log;
        user = hooks().log_user;
    }
    if (function != nullptr) function(user, int32_t(level), text);
}

void report_failure(void*, const physics::World&, const char* what) {
    fettle_failure_function function;
    void* user;
    {
        const std::lock_guard lock(hooks().mutex);
        function = hooks().failure;
        user = hooks().failure_user;
    }
    if (function != nullptr) function(user, what);
}

}  // namespace
}  // namespace fettle::physics_c

using namespace fettle::physics_c;

fettle_code fettle_set_log(fettle_log_function function, void* user) {
    return guarded(__func__, [&] {
        const std::lock_guard lock(hooks().mutex);
        hooks().log = function;
        hooks().log_user = user;
        fettle::physics::set_log(function != nullptr ? write_log : nullptr, nullptr);
    });
}

fettle_code fettle_set_failure_function(fettle_failure_function function, void* user) {
    return guarded(__func__, [&] {
        const std::lock_guard lock(hooks().mutex);
        hooks().failure = function;
        hooks().failure_user = user;
        fettle::physics::set_failure_function(function != nullptr ? report_failure : nullptr,
                                              nullptr);
    });
}
