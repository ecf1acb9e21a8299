#pragma once
// The program `fettle` as a running process, for tests that send signals to it.

#include <sys/types.h>

#include <string>
#include <vector>

#include "program.h"

namespace program_test {

class RunningProgram {
  public:
    /// Runs `fettle ARGUMENTS` without a display. `ignored`: a signal that the process ignores from
    /// the start; 0: none.
    RunningProgram(const Folder& folder, const std::vector<std::string>& arguments,
                   int ignored = 0);
    ~RunningProgram();
    RunningProgram(const RunningProgram&) = delete;

    /// Waits until the file exists; false if it does not within a minute.
    bool makes(const std::string& file);
    /// Waits until the error output contains the text; false if it does not within a minute.
    bool reports(const std::string& text);
    void send(int signal) const;
    /// Waits for the end of the process, a minute at most. `status`: as a shell gives it, so 128 +
    /// number for a signal that killed the process. `signal`: that number; 0 if the process ended
    /// by itself.
    struct End : Outcome {
        int signal = 0;
    };
    End end();

  private:
    const Folder& folder_;
    pid_t process_ = -1;
};

}  // namespace program_test
