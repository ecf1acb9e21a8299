#pragma once
// Programs that a test starts and that end with it.

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace fettle::test {

class Process {
  public:
    Process() = default;
    /// `output`: file for stdout and stderr. `environment` is added to that of this process; an
    /// empty value removes a variable.
    Process(const std::vector<std::string>& command,
            const std::map<std::string, std::string>& environment,
            const std::filesystem::path& output);
    ~Process() { end(); }
    Process(Process&& other) noexcept : id_(other.id_), status_(other.status_) { other.id_ = 0; }
    Process& operator=(Process&& other) noexcept;

    bool running();
    /// Waits until the process ends; returns -1 if it does not in time or is killed by a signal.
    int wait(double seconds);
    /// Sends SIGTERM and waits; returns the exit status, or -1 if the process does not end in half
    /// a minute or a signal kills it.
    int asked_to_end();
    /// Sends SIGTERM; after five seconds sends SIGKILL.
    void end();

  private:
    pid_t id_ = 0;
    int status_ = 0;
};

/// Runs a command to its end; returns its exit status.
int run(const std::vector<std::string>& command,
        const std::map<std::string, std::string>& environment, const std::filesystem::path& output);

/// True if a program with this name is in the PATH.
bool available(const std::string& program);

std::string read_file(const std::filesystem::path& file);

}  // namespace fettle::test
