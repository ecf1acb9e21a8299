#pragma once
// Trying something in a copy of the process, so that whatever happens there does no harm here.

#include <chrono>
#include <functional>
#include <string>

namespace fettle::module {

/// Runs `body` in a forked copy of this process, which ends with it. `body` names what it is about
/// to do through its argument, so that a crash can be told where it happened, and throws when it
/// fails. Returns "" when it came to its end, else what went wrong: the message of the exception,
/// "crashed (Segmentation fault) in its own test", "ended the process with status 0 while it was
/// opened", or that it took longer than `limit`.
std::string tried(const std::function<void(const std::function<void(std::string_view)>& now)>& body,
                  std::chrono::milliseconds limit = std::chrono::seconds(10));

}  // namespace fettle::module
