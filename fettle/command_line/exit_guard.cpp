#include <command_line/exit_guard.h>

#include <unistd.h>

#include <cstdlib>
#include <new>
#include <utility>
#include <vector>

#include <command_line/exit_status.h>
#include <command_line/terminal.h>

namespace fettle::program {

namespace {

std::vector<std::string>& guarded() {
    static std::vector<std::string> what;
    return what;
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
    static const bool registered = std::atexit(report_exit) == 0;
    if (!registered) throw std::bad_alloc();
}

ExitGuard::~ExitGuard() {
    guarded().pop_back();
}

}  // namespace fettle::program
