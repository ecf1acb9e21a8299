#pragma once
// Runs a function in a forked copy of the process, so that a crash does no harm to the program.

#include <functional>
#include <string>

namespace fettle::module {

/// Runs `body` in a forked copy of this process, which then ends. `body` reports each phase through
/// its argument, so that a crash can be assigned to a phase; it throws if it fails. Returns "" on
/// success. Otherwise returns what went wrong: the message of the exception, "crashed (Segmentation
/// fault) in its own test", "ended the process with status 0 while it was opened", or that it took
/// longer than ten seconds.
std::string run_trial(
    const std::function<void(const std::function<void(std::string_view)>& now)>& body);

}  // namespace fettle::module
