#pragma once
// A native module may call exit(), which would end a command as if it had succeeded.

#include <string>

namespace fettle::program {

/// While it exists, exit() ends the process with `script_error` and a message that begins with
/// `what`. Guards may be nested; the last one made is the one that reports.
class ExitGuard {
  public:
    explicit ExitGuard(std::string what);
    ~ExitGuard();
    ExitGuard(const ExitGuard&) = delete;
    ExitGuard& operator=(const ExitGuard&) = delete;
};

/// `what` of the last guard; null without one. May be called in a signal handler.
const char* guarded_work() noexcept;

}  // namespace fettle::program
