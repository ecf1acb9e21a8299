#pragma once

#include <fettle/physics/hooks.h>

#include <string>

namespace fettle::physics::detail {

/// Passes the text to the log of the host, if there is one.
void log(LogLevel level, const std::string& text) noexcept;
/// True if there is a log. If not, callers need not build the text.
bool is_logged() noexcept;

/// The function for faults of worlds, and its argument.
struct FailureHook {
    FailureFunction function = nullptr;
    void* user = nullptr;
};
FailureHook failure_hook() noexcept;
/// True if there is one. Cheaper than `failure_hook`.
bool are_steps_checked() noexcept;

}  // namespace fettle::physics::detail
