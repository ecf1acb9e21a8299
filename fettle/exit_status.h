#pragma once
// What the program says when it ends.

namespace fettle::program {

enum ExitStatus : int {
    success = 0,
    script_error = 1,  // uncaught, in main.lua, a callback, a timer or a handler
    bad_usage = 2,     // of the command line, or no display where one is needed
    file_error = 3     // a file could not be read or written
};

}  // namespace fettle::program
