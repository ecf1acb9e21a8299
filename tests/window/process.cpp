#include "process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>
#include <utility>

namespace fettle::test {

namespace {

constexpr auto poll_interval = std::chrono::milliseconds(5);

[[noreturn]] void become(const std::vector<std::string>& command,
                         const std::map<std::string, std::string>& environment,
                         const std::filesystem::path& output) {
    int out = ::open(output.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
    int in = ::open("/dev/null", O_RDONLY);
    if (out < 0 || in < 0) ::_exit(126);
    ::dup2(in, 0);
    ::dup2(out, 1);
    ::dup2(out, 2);
    for (const auto& [name, value] : environment) {
        if (value.empty())
            ::unsetenv(name.c_str());
        else
            ::setenv(name.c_str(), value.c_str(), 1);
    }
    std::vector<char*> arguments;
    for (const std::string& argument : command)
        arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    ::execvp(arguments[0], arguments.data());
    ::_exit(127);
}

}  // namespace

Process::Process(const std::vector<std::string>& command,
                 const std::map<std::string, std::string>& environment,
                 const std::filesystem::path& output) {
    id_ = ::fork();
    if (id_ == 0) become(command, environment, output);
}

Process& Process::operator=(Process&& other) noexcept {
    end();
    std::swap(id_, other.id_);
    status_ = other.status_;
    return *this;
}

bool Process::running() {
    if (id_ <= 0) return false;
    if (::waitpid(id_, &status_, WNOHANG) == 0) return true;
    id_ = 0;
    return false;
}

int Process::wait(double seconds) {
    auto deadline = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    while (running()) {
        if (std::chrono::steady_clock::now() > deadline) return -1;
        std::this_thread::sleep_for(poll_interval);
    }
    return WIFEXITED(status_) ? WEXITSTATUS(status_) : -1;
}

int Process::asked_to_end() {
    if (!running()) return -1;
    ::kill(id_, SIGTERM);
    return wait(30);
}

void Process::end() {
    if (!running()) return;
    ::kill(id_, SIGTERM);
    if (wait(5) == -1 && running()) {
        ::kill(id_, SIGKILL);
        wait(5);
    }
}

int run(const std::vector<std::string>& command,
        const std::map<std::string, std::string>& environment,
        const std::filesystem::path& output) {
    return Process(command, environment, output).wait(60);
}

bool available(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "/usr/bin:/bin");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (::access((folder + "/" + program).c_str(), X_OK) == 0) return true;
    return false;
}

std::string read_file(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream bytes;
    bytes << in.rdbuf();
    return std::move(bytes).str();
}

}  // namespace fettle::test
