#pragma once
// The exit statuses of the program.

namespace fettle::program {

enum ExitStatus : int {
    success = 0,
    script_error = 1,  // an uncaught error in main.lua, a callback, a timer or a handler
    bad_usage = 2,     // the command line is invalid, or a display is needed and missing
    file_error = 3     // a file could not be read or written
};

/// The exit status that shells use for a program that was ended by a signal.
inline int status_of_signal(int number) {
    return 128 + number;
}

}  // namespace fettle::program
