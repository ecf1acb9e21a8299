#pragma once
// Runs of a game with edits in the console that are kept and must be present in the next run.

#include <catch.h>

#include "program.h"

namespace program_test {

/// A run of the game in `folder`; `commands` are typed into the console as "STEP:TEXT".
inline Outcome run(const Folder& folder, const std::vector<std::string>& commands,
                   const std::string& eval = {}) {
    std::vector<std::string> arguments = {"run", (folder / "main.lua").string(), "--headless",
                                          "--steps", "9"};
    for (const std::string& command : commands) {
        arguments.emplace_back("--console");
        arguments.push_back(command);
    }
    if (!eval.empty()) {
        arguments.emplace_back("--eval");
        arguments.push_back(eval);
    }
    return fettle(folder, arguments);
}

/// The output of `eval` in a run after everything was kept; fails if the run prints anything else.
inline std::string output_of_next_run(const Folder& folder, const std::string& eval) {
    const Outcome outcome = run(folder, {}, eval);
    CHECK(outcome.status == 0);
    CHECK(without_notes(outcome.err) == "");
    return outcome.out;
}

}  // namespace program_test
