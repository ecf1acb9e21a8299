#include "running_program.h"

#include <catch.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

namespace program_test {

namespace {

using Clock = std::chrono::steady_clock;

/// Tests the condition repeatedly; false if it does not become true within a minute.
template <class Condition>
bool eventually(Condition condition) {
    const Clock::time_point deadline = Clock::now() + std::chrono::minutes(1);
    while (!condition()) {
        if (Clock::now() > deadline) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return true;
}

}  // namespace

RunningProgram::RunningProgram(const Folder& folder, const std::vector<std::string>& arguments,
                               int ignored)
    : folder_(folder) {
    std::vector<std::string> words = {"fettle"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const std::string out = (folder / "out").string(), err = (folder / "err").string();
    process_ = ::fork();
    REQUIRE(process_ >= 0);
    if (process_ != 0) return;
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) std::signal(number, SIG_DFL);
    if (ignored != 0) std::signal(ignored, SIG_IGN);
    ::dup2(::open("/dev/null", O_RDONLY), STDIN_FILENO);
    ::dup2(::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
    ::dup2(::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
    ::unsetenv("DISPLAY");
    ::unsetenv("WAYLAND_DISPLAY");
    ::execv(FETTLE_PROGRAM, pointers.data());
    ::_exit(127);
}

RunningProgram::~RunningProgram() {
    if (process_ <= 0) return;
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
}

bool RunningProgram::makes(const std::string& file) {
    return eventually([&] { return std::filesystem::exists(folder_ / file); });
}

bool RunningProgram::reports(const std::string& text) {
    return eventually([&] { return contains(folder_.text("err"), text); });
}

void RunningProgram::send(int signal) const {
    ::kill(process_, signal);
}

RunningProgram::End RunningProgram::end() {
    End end;
    int status = 0;
    const bool ended =
        eventually([&] { return ::waitpid(process_, &status, WNOHANG) == process_; });
    INFO(folder_.text("out") << folder_.text("err"));
    REQUIRE(ended);
    process_ = -1;
    end.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    end.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + end.signal;
    end.out = folder_.text("out");
    end.err = folder_.text("err");
    return end;
}

}  // namespace program_test
