#pragma once
// What `fettle repl` shares between a game of its own and a game that runs already.

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/script/runtime.h>

#include <command_line/line_editor.h>

namespace fettle::program {

/// The file of typed lines, beside that of the console's own commands; empty if there is none.
std::filesystem::path repl_history();

/// Candidates for a line that continues the lines before it, which end without a line end.
/// `complete` completes all of them together.
std::vector<LineEditor::Candidate> candidates_of(
    const std::string& before, std::string_view line, std::size_t cursor,
    const std::function<std::vector<script::Completion>(const std::string& all,
                                                        std::size_t cursor)>& complete);

}  // namespace fettle::program
