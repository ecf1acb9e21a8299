#pragma once
// The run of one test in a fresh game.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <game/test_driver.h>

namespace fettle::program {

struct TestOptions {
    std::filesystem::path game = ".";
    std::string filter{};           // only tests whose file or name contains it
    std::filesystem::path junit{};  // report to write; empty: none
    bool update = false;            // write the pictures instead of comparing them
    bool output = false;            // show what the game printed, also if the test passes
    std::uint64_t timeout = 60;     // s of processor time, of each test
    std::vector<std::string> modules{};
};

struct TestOutcome {
    std::string file, name;
    bool passed = false;
    std::string message{};               // of the failure: one line
    std::string details{};               // source line and traceback: lines
    std::string output{};                // what the game printed: lines
    std::filesystem::path recording{};   // of a failed run
    std::vector<std::string> skipped{};  // pictures that were not compared
    double seconds = 0;
};

/// The tests of a file. With a failed outcome if the game or the file cannot be loaded.
struct TestList {
    std::vector<std::string> names{};
    TestOutcome outcome{};
};
TestList list_tests(const TestOptions& options, const std::string& file);

/// Runs the test. The store, the saves and the files of the game that it writes stay in memory.
TestOutcome run_test(const TestOptions& options, const TestChoice& choice);

}  // namespace fettle::program
