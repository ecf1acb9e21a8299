#include "trial.h"

#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <thread>

#include <fettle/property/exception_text.h>

namespace fettle::module {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds limit(10);  // for a trial

void write_all(int to, std::string_view text) {
    while (!text.empty()) {
        const ssize_t n = ::write(to, text.data(), text.size());
        if (n < 0 && errno != EINTR) return;
        if (n > 0) text.remove_prefix(static_cast<std::size_t>(n));
    }
}

/// The copy writes this last on success. Status 0 alone is not a proof, since a module may call
/// `exit(0)`.
constexpr std::string_view success_line = "=\n";

/// Runs `body` in the copy and writes to `to`: a line for each phase, "@in its own test", and
/// finally "!" with an error message, or `success_line`.
[[noreturn]] void run_copy(
    int to, const std::function<void(const std::function<void(std::string_view)>&)>& body) {
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);  // a crash is reported as text, so no core file is needed
    // The program's crash handlers must not run in the copy.
    for (const int number :
         {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGINT, SIGTERM, SIGHUP, SIGALRM})
        signal(number, SIG_DFL);
    alarm(2 * unsigned(limit.count()));  // ends it also where the program has ended meanwhile
    try {
        body([&](std::string_view phase) { write_all(to, "@" + std::string(phase) + "\n"); });
        write_all(to, success_line);
    } catch (...) {
        write_all(to, "!" + property::exception_text());
    }
    _exit(0);  // no destructor or exit handler of the program may run here
}

/// Reads until the other end is closed; false if that takes longer than the deadline.
bool read_until(int from, Clock::time_point deadline, std::string& text) {
    for (;;) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
        pollfd waiting{from, POLLIN, 0};
        const int ready = left <= 0 ? 0 : poll(&waiting, 1, static_cast<int>(left));
        if (ready == 0) return false;
        if (ready < 0) {
            if (errno == EINTR) continue;
            return true;
        }
        char buffer[4096];
        const ssize_t n = ::read(from, buffer, sizeof buffer);
        if (n == 0) return true;
        if (n > 0) text.append(buffer, static_cast<std::size_t>(n));
    }
}

/// Waits for the copy and gets its status. Kills it and returns false after the deadline.
bool wait_until_end(pid_t copy, Clock::time_point deadline, int& status) {
    for (;;) {
        const pid_t found = waitpid(copy, &status, WNOHANG);
        if (found == copy || (found < 0 && errno != EINTR)) return true;
        if (Clock::now() >= deadline) break;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    kill(copy, SIGKILL);
    while (waitpid(copy, &status, 0) < 0 && errno == EINTR) {
    }
    return false;
}

}  // namespace

std::string run_trial(
    const std::function<void(const std::function<void(std::string_view)>&)>& body) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error(std::string("no pipe: ") + strerror(errno));
    const pid_t copy = fork();
    if (copy == 0) {
        close(ends[0]);
        run_copy(ends[1], body);
    }
    close(ends[1]);
    if (copy < 0) {
        const int reason = errno;
        close(ends[0]);
        throw std::runtime_error(std::string("no copy of the process: ") + strerror(reason));
    }
    std::string said;
    const Clock::time_point deadline = Clock::now() + limit;
    const bool all_said = read_until(ends[0], deadline, said);
    close(ends[0]);
    int status = 0;
    // The pipe may close before the copy ends, because a module can close any file descriptor.
    const bool in_time =
        wait_until_end(copy, all_said ? deadline : Clock::now(), status) && all_said;
    if (in_time && said.ends_with(success_line) && WIFEXITED(status) && WEXITSTATUS(status) == 0)
        return "";
    if (const std::size_t error = said.rfind("\n!"); error != std::string::npos)
        return said.substr(error + 2);
    if (said.starts_with('!')) return said.substr(1);
    const std::size_t last = said.rfind('@');
    std::string phase = last == std::string::npos ? "" : said.substr(last + 1);
    while (!phase.empty() && phase.back() == '\n') phase.pop_back();
    if (!in_time)
        return "did not come to an end " + phase + " within " + std::to_string(limit.count()) +
               " s";
    if (WIFSIGNALED(status))
        return std::string("crashed (") + strsignal(WTERMSIG(status)) + ") " + phase;
    return "ended the process with status " + std::to_string(WEXITSTATUS(status)) + " " + phase;
}

}  // namespace fettle::module
