#include "trial.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <utility>

#include <fettle/module/plugin.h>
#include <fettle/module/trial_program.h>

extern char** environ;

namespace fettle::module {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds limit(trial_seconds);

[[noreturn]] void fail(const std::string& what, int reason) {
    throw std::runtime_error(what + ": " + std::strerror(reason));
}

class Descriptor {
  public:
    Descriptor() = default;
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    int get() const { return number_; }
    /// The number; the caller closes it.
    int release() { return std::exchange(number_, -1); }
    void close() {
        if (number_ >= 0) ::close(release());  // NOLINT: it always has a value
    }

  private:
    int number_ = -1;
};

/// A copy of the descriptor with a number that the standard streams and `trial_stream` do not have.
Descriptor moved_up(int from) {
    const Descriptor old(from);
    Descriptor fresh(fcntl(from, F_DUPFD_CLOEXEC, trial_stream + 1));
    if (fresh.get() < 0) fail("no file descriptor", errno);
    return fresh;
}

/// Two connected ends.
std::pair<Descriptor, Descriptor> stream() {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0) fail("no socket", errno);
    Descriptor second(ends[1]);
    Descriptor ours = moved_up(ends[0]);
    fcntl(ours.get(), F_SETFL, O_NONBLOCK);
    return {std::move(ours), moved_up(second.release())};
}

fs::path found_program(const fs::path& module) {
    const std::vector<fs::path> places = trial_program_places();
    for (const fs::path& place : places)
        if (::access(place.c_str(), X_OK) == 0 && !fs::is_directory(place)) return place;
    std::string all;
    for (const fs::path& place : places) all += (all.empty() ? "" : ", ") + place.string();
    throw LoadError(module,
                    "a module is tried out before it is loaded, and the program for that, "
                    "fettle-trial, is not there: expected it at " +
                        all +
                        "; the environment variable FETTLE_TRIAL or "
                        "fettle::module::set_trial_program names another place");
}

/// Starts the program with `theirs` as its `trial_stream`. What a module prints in its trial is not
/// shown.
pid_t started(const fs::path& program, const Descriptor& theirs) {
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&files, theirs.get(), trial_stream);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &all);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    std::string name = program.filename().string();
    char* arguments[] = {name.data(), nullptr};
    pid_t process = 0;
    const int problem =
        posix_spawn(&process, program.c_str(), &files, &attributes, arguments, environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    if (problem != 0) fail(program.string() + " cannot be started", problem);
    return process;
}

/// Sends the trial and reads until the other end is closed; false if that takes longer than the
/// deadline. The other end may stop reading at any time.
bool exchange(Descriptor& ours, std::span<const std::byte> trial, Clock::time_point deadline,
              std::string& output) {
    bool sending = true;
    for (;;) {
        if (sending && trial.empty()) {
            shutdown(ours.get(), SHUT_WR);
            sending = false;
        }
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
        pollfd waiting{ours.get(), static_cast<short>(sending ? POLLIN | POLLOUT : POLLIN), 0};
        const int ready = left <= 0 ? 0 : poll(&waiting, 1, static_cast<int>(left));
        if (ready == 0) return false;
        if (ready < 0) {
            if (errno == EINTR) continue;
            return true;
        }
        if (sending && (waiting.revents & POLLOUT) != 0) {
            const ssize_t n = send(ours.get(), trial.data(), trial.size(), MSG_NOSIGNAL);
            if (n > 0) trial = trial.subspan(static_cast<std::size_t>(n));
            if (n < 0 && errno != EAGAIN && errno != EINTR) sending = false;
        }
        if ((waiting.revents & (POLLIN | POLLHUP | POLLERR)) == 0) continue;
        char buffer[4096];
        const ssize_t n = ::read(ours.get(), buffer, sizeof buffer);
        if (n == 0 || (n < 0 && errno != EAGAIN && errno != EINTR)) return true;
        if (n > 0) output.append(buffer, static_cast<std::size_t>(n));
    }
}

/// Waits for the process and gets its status. Kills it and returns false after the deadline.
bool wait_until_end(pid_t process, Clock::time_point deadline, int& status) {
    for (;;) {
        const pid_t found = waitpid(process, &status, WNOHANG);
        if (found == process || (found < 0 && errno != EINTR)) return true;
        if (Clock::now() >= deadline) break;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    kill(process, SIGKILL);
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    return false;
}

std::vector<fs::path> listed_libraries(const std::string& output) {
    std::vector<fs::path> all;
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with('+')) all.emplace_back(line.substr(1));
    return all;
}

}  // namespace

std::string run_trial(const Trial& trial, std::vector<fs::path>* libraries) {
    const fs::path program = found_program(trial.file);
    const std::vector<std::byte> bytes = to_bytes(trial);
    auto [ours, theirs] = stream();
    const pid_t process = started(program, theirs);
    theirs.close();
    std::string output;
    const Clock::time_point deadline = Clock::now() + limit;
    const bool is_complete = exchange(ours, bytes, deadline, output);
    ours.close();
    int status = 0;
    // The stream may close before the process ends, because a module can close any file descriptor.
    const bool in_time =
        wait_until_end(process, is_complete ? deadline : Clock::now(), status) && is_complete;
    if (in_time && output.ends_with(success_line) && WIFEXITED(status) &&
        WEXITSTATUS(status) == 0) {
        if (libraries != nullptr) *libraries = listed_libraries(output);
        return "";
    }
    if (const std::size_t error = output.rfind("\n!"); error != std::string::npos)
        return output.substr(error + 2);
    if (output.starts_with('!')) return output.substr(1);
    const std::size_t last = output.rfind('@');
    if (last == std::string::npos)
        return "cannot be tried out: " + program.string() + " does not answer as fettle-trial does";
    std::string phase = output.substr(last + 1);
    while (!phase.empty() && phase.back() == '\n') phase.pop_back();
    if (!in_time)
        return "did not come to an end " + phase + " within " + std::to_string(limit.count()) +
               " s";
    if (WIFSIGNALED(status))
        return std::string("crashed (") + strsignal(WTERMSIG(status)) + ") " + phase;
    return "ended the process with status " + std::to_string(WEXITSTATUS(status)) + " " + phase;
}

// --- Bytes

std::vector<std::byte> to_bytes(const Trial& trial) {
    std::vector<std::byte> bytes;
    property::ByteWriter to(bytes);
    to.put(FETTLE_PROGRAM);
    to.put(trial.kind);
    to.put(trial.file.string());
    to.put(trial.copy.string());
    to.put(trial.name);
    write(to, trial.tree);
    return bytes;
}

Trial trial_from(std::span<const std::byte> bytes) {
    property::ByteReader from(bytes, "trial");
    const std::string version(from.text());
    if (version != FETTLE_PROGRAM)
        throw std::runtime_error("fettle-trial is of another version: expected " + version +
                                 ", found " FETTLE_PROGRAM);
    Trial trial;
    trial.kind = from.get<TrialKind>();
    trial.file = std::string(from.text());
    trial.copy = std::string(from.text());
    trial.name = std::string(from.text());
    trial.tree = read_tree(from);
    from.finish();
    return trial;
}

}  // namespace fettle::module
