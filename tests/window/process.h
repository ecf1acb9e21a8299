#pragma once
// Programs started by a test, which end with it.

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace fettle::test {

class Process {
  public:
    Process() = default;
    /// `output`: where stdout and stderr go. Environment is added to this process's own; an empty
    /// value removes a variable.
    Process(const std::vector<std::string>& command,
            const std::map<std::string, std::string>& environment,
            const std::filesystem::path& output);
    ~Process() { end(); }
    Process(Process&& other) noexcept : id_(other.id_), status_(other.status_) { other.id_ = 0; }
    Process& operator=(Process&& other) noexcept;

    bool running();
    /// Waits until it ends by itself; -1 when it does not in time or is killed by a signal.
    int wait(double seconds);
    /// Asks it to end and waits; its exit status, -1 when it does not end in half a minute or a
    /// signal kills it.
    int asked_to_end();
    /// Asks it to end, then makes it.
    void end();

  private:
    pid_t id_ = 0;
    int status_ = 0;
};

/// Runs a command to its end; its exit status.
int run(const std::vector<std::string>& command,
        const std::map<std::string, std::string>& environment, const std::filesystem::path& output);

/// Whether a program of this name is in the PATH.
bool available(const std::string& program);

std::string read_file(const std::filesystem::path& file);

}  // namespace fettle::test
