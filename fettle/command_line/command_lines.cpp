#include <command_line/command_lines.h>

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <utility>

#include <ending/end_request.h>
#include <terminal/terminal.h>

#ifdef FETTLE_WITH_CONSOLE
#include <fettle/console/console.h>
#endif

namespace fettle::program {
namespace {

constexpr const char* too_early = "✗ the command ends too early";

/// The file of typed lines, beside that of the console's own commands; empty if there is none.
std::filesystem::path history_file() {
#ifdef FETTLE_WITH_CONSOLE
    const std::filesystem::path console = console::default_history_file();
    if (!console.empty()) return console.parent_path() / "repl_history";
#endif
    return {};
}

}  // namespace

void CommandLines::read(const std::string& greeting) {
    if (::isatty(STDIN_FILENO) == 1 && ::isatty(STDOUT_FILENO) == 1) {
        print_line(greeting);
        read_from_terminal();
        print_line("");
    } else {
        for (std::string line; !runner_.ended() && std::getline(std::cin, line);) add_line(line);
        if (!pending_.empty() && !runner_.ended()) print_line(too_early);
    }
    std::fflush(stdout);
}

void CommandLines::erase_typed_line() {
    if (editor_) editor_->erase_typed_line();
}

void CommandLines::read_from_terminal() {
    editor_.emplace(history_file(), [this](std::string_view line, std::size_t cursor) {
        return candidates(line, cursor);
    });
    const EndRequest::Interrupts interrupts;
    const auto idle = [&] {
        if (EndRequest::Interrupts::test_and_clear()) return LineEditor::Next::drop_line;
        runner_.idle();
        std::fflush(stdout);
        return runner_.ended() ? LineEditor::Next::end : LineEditor::Next::read_on;
    };
    while (!runner_.ended()) {
        const std::optional<LineEditor::Line> line =
            editor_->read(pending_.empty() ? "› " : "… ", idle);
        if (!line) break;
        if (line->dropped)
            pending_.clear();
        else
            add_line(line->text);
        EndRequest::Interrupts::test_and_clear();  // a signal that stopped the command
    }
    editor_.reset();
}

/// An empty line ends a command that is not complete.
void CommandLines::add_line(const std::string& line) {
    pending_ += pending_.empty() ? line : "\n" + line;
    const std::string command = pending_;
    if (!runner_.run(command)) {
        if (!line.empty()) return;
        print_line(too_early);
    }
    pending_.clear();
    std::fflush(stdout);
}

/// The line continues the lines before it.
std::vector<LineEditor::Candidate> CommandLines::candidates(std::string_view line,
                                                            std::size_t cursor) {
    const std::string before = pending_.empty() ? "" : pending_ + "\n";
    std::vector<LineEditor::Candidate> found;
    for (script::Completion& c :
         runner_.complete(before + std::string(line), before.size() + cursor))
        if (c.replace_from >= before.size())
            found.push_back({std::move(c.text), std::move(c.label), std::move(c.detail),
                             c.replace_from - before.size()});
    // The only one that begins with what is typed is meant, whatever else contains its letters.
    const auto begins_so = [&](const LineEditor::Candidate& each) {
        return each.replace_from < cursor &&
               each.text.starts_with(line.substr(each.replace_from, cursor - each.replace_from));
    };
    if (std::ranges::count_if(found, begins_so) == 1)
        std::erase_if(found, [&](const auto& each) { return !begins_so(each); });
    return found;
}

}  // namespace fettle::program
