#pragma once
// The program while it runs: to be sent signals.

#include <sys/types.h>

#include <string>
#include <vector>

#include "program.h"

namespace program_test {

class RunningProgram {
  public:
    /// Runs `fettle ARGUMENTS` without a display. `ignored`: a signal that it is told to ignore; 0:
    /// none.
    RunningProgram(const Folder& folder, const std::vector<std::string>& arguments,
                   int ignored = 0);
    ~RunningProgram();
    RunningProgram(const RunningProgram&) = delete;

    /// Waits until the file is there; false when it does not come in a minute.
    bool makes(const std::string& file);
    void send(int signal) const;
    /// Waits for its end, a minute at most. `status`: as of a shell, 128 + its number for a signal
    /// that has killed it; `signal`: that number, 0 when it has ended by itself.
    struct End : Outcome {
        int signal = 0;
    };
    End end();

  private:
    const Folder& folder_;
    pid_t process_ = -1;
};

}  // namespace program_test
