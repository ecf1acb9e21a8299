#pragma once
// Reads commands, each of one line or more, for `fettle repl`.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/script/runtime.h>

#include <terminal/line_editor.h>

namespace fettle::program {

/// Runs the commands that `CommandLines` reads.
class CommandRunner {
  public:
    virtual ~CommandRunner() = default;
    /// Whether no more commands are to be read.
    virtual bool ended() = 0;
    /// Called sixty times a second while a line is typed into a terminal.
    virtual void idle() = 0;
    /// Runs a command and prints its answer. False, and nothing is printed, if the command goes on
    /// in the next line.
    virtual bool run(const std::string& command) = 0;
    virtual std::vector<script::Completion> complete(const std::string& command,
                                                     std::size_t cursor) = 0;
};

/// Reads commands from the standard input until it or the runner ends: from a terminal with
/// editing, history and completion, and from anything else line by line.
class CommandLines {
  public:
    explicit CommandLines(CommandRunner& runner) : runner_(runner) {}

    /// Prints `greeting` first if it reads from a terminal.
    void read(const std::string& greeting);
    /// Erases the line that is being typed, if there is one; it is shown again later. Call before
    /// anything is printed.
    void erase_typed_line();

  private:
    void read_from_terminal();
    void add_line(const std::string& line);
    std::vector<LineEditor::Candidate> candidates(std::string_view line, std::size_t cursor);

    CommandRunner& runner_;
    std::optional<LineEditor> editor_;
    std::string pending_;  // the lines of a command that is not complete
};

}  // namespace fettle::program
