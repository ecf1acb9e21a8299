#pragma once
// What the console has printed: lines of text with a kind each, the oldest dropped when there are
// too many.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>

#include <fettle/script/runtime.h>

namespace fettle::console {

enum class LineKind : std::uint8_t {
    command,       // first line of what was typed
    continuation,  // its further lines
    output,        // results, echoes of assignments, printed text
    note,          // what the console itself says
    error,
    source,  // the line of code an error is about
    caret,   // spaces and carets below it
    trace    // traceback and locals
};

struct LogLine {
    LineKind kind;
    std::string text;
};

class Log {
  public:
    static constexpr std::size_t max_lines = 20'000;
    static constexpr std::size_t max_line_bytes = 16 * 1024;

    void command(std::string_view text);
    void output(std::string_view text) { add(LineKind::output, text); }
    void note(std::string_view text) { add(LineKind::note, text); }
    /// Message, source line with a caret below the trouble, traceback when it says more than the
    /// message.
    void error(const script::ScriptError& error);
    void error(std::string_view message) { add(LineKind::error, message); }
    void clear();

    const std::deque<LogLine>& lines() const { return lines_; }
    /// Lines ever dropped from the front: line i of `lines` is number `dropped() + i`.
    std::uint64_t dropped() const { return dropped_; }
    /// Increases by one each time `clear` is called.
    std::uint64_t clearings() const { return clearings_; }

  private:
    void add(LineKind kind, std::string_view text);
    void push(LineKind kind, std::string text);

    std::deque<LogLine> lines_;
    std::uint64_t dropped_ = 0;
    std::uint64_t clearings_ = 0;
};

}  // namespace fettle::console
