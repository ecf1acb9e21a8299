#include <ending/exit_guard.h>

#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <deque>
#include <new>
#include <utility>

#include <ending/exit_status.h>
#include <terminal/terminal.h>

namespace fettle::program {

namespace {

/// A deque, whose elements stay where they are.
std::deque<std::string>& guarded() {
    static std::deque<std::string> what;
    return what;
}

std::atomic<const char*> last_work{nullptr};

void note_last_work() {
    last_work = guarded().empty() ? nullptr : guarded().back().c_str();
}

void report_exit() {
    if (guarded().empty()) return;
    print_error(guarded().back() +
                ": the process was ended: a native module or a library called exit()");
    (void)all_printed();
    ::_exit(script_error);
}

}  // namespace

ExitGuard::ExitGuard(std::string what) {
    guarded().push_back(std::move(what));  // made before the handler, so it still exists in it
    note_last_work();
    static const bool registered = std::atexit(report_exit) == 0;
    if (!registered) throw std::bad_alloc();
}

ExitGuard::~ExitGuard() {
    last_work = nullptr;
    guarded().pop_back();
    note_last_work();
}

const char* guarded_work() noexcept {
    return last_work;
}

}  // namespace fettle::program
