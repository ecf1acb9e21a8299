#pragma once
// What is left of a process that ends in the middle of native code: what it printed, and a line
// that says what was running.

#include <string_view>

namespace fettle::program {

/// From now on, a crash (SIGSEGV, SIGABRT and others) writes out what was printed before, and a
/// line that names the work of the last `ExitGuard` and the function of a native module that runs;
/// then the signal ends the process as usual. A signal that has a handler already, such as that of
/// a sanitizer, keeps it. To be called before anything is printed.
void report_crashes();

/// Writes out what was printed and a line "fettle: WORK: REASON", with the function of a native
/// module that runs, if one does. It uses no lock and no memory of the heap, so it may be called in
/// a signal handler and in any thread, whatever the others do.
void report_sudden_end(const char* reason) noexcept;

/// While it exists, the text that `is` was given last is written after what was printed: the output
/// of a test, which is shown when the test ends.
class CollectedOutput {
  public:
    CollectedOutput() = default;
    ~CollectedOutput();
    CollectedOutput(const CollectedOutput&) = delete;
    CollectedOutput& operator=(const CollectedOutput&) = delete;
    /// `text` must stay where it is until the next call.
    void is(std::string_view text) noexcept;
};

}  // namespace fettle::program
