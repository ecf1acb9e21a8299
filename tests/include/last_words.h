#pragma once
// Functions that end the program, tested in a child process.

#include <sys/wait.h>
#include <unistd.h>

#include <cstddef>
#include <exception>
#include <functional>
#include <string>

#include "catch.h"

/// The message of the exception with which `act` ends a process (std::terminate).
inline std::string termination_message(const std::function<void()>& act) {
    int ends[2];
    REQUIRE(pipe(ends) == 0);
    const pid_t child = fork();
    if (child == 0) {
        static int out;
        out = ends[1];
        std::set_terminate([] {
            try {
                throw;
            } catch (const std::exception& error) {
                const std::string words = error.what();
                (void)!write(out, words.data(), words.size());
            } catch (...) {
            }
            _exit(9);
        });
        act();
        _exit(0);
    }
    close(ends[1]);
    std::string words(1000, '\0');
    const ssize_t size = read(ends[0], words.data(), words.size());
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 9);
    words.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
    return words;
}
