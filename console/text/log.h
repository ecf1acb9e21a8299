#pragma once
// The output of the console: lines of text, each with a kind. Old lines are dropped when there are
// too many.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/script/runtime.h>

#include <text/short_numbers.h>

namespace fettle::console {

enum class LineKind : std::uint8_t {
    command,       // first line of a typed command
    continuation,  // further lines of it
    output,        // results, reports of assignments, printed text
    game,          // what the game prints
    note,          // messages of the console itself
    error,
    source,  // the line of code with an error
    caret,   // spaces and carets below it
    trace,   // traceback and locals
    fold     // stands for the lines in `hidden`
};

/// Where the columns of a table are, in cells.
struct LogTable {
    static constexpr std::size_t gap = 2;  // cells between columns
    std::vector<std::size_t> begins;
    std::size_t end = 0;  // of the last column
};

struct LogLine {
    LineKind kind;
    std::string text;
    std::size_t count = 1;                    // how often in succession it was printed
    std::vector<LogLine> hidden{};            // of a fold
    std::string file{};                       // that the line names
    std::shared_ptr<const LogTable> table{};  // whose row it is
    std::vector<std::size_t> cells{};         // of a row, the bytes where its cells begin
    std::vector<ShortNumber> numbers{};       // in `text`; copies have the whole ones

    /// The part of the text from `begin` to `end` with whole numbers.
    std::string whole(std::size_t begin = 0, std::size_t end = std::string::npos) const {
        return whole_text(text, numbers, begin, std::min(end, text.size()));
    }
};

class Log {
  public:
    static constexpr std::size_t max_lines = 20'000;
    static constexpr std::size_t max_line_bytes = 16 * 1024;
    static constexpr std::size_t max_message_bytes = 1000;  // of an error
    /// Output of one command with more lines is folded after the first of them.
    static constexpr std::size_t max_unfolded = 60, shown_of_folded = 40;

    void command(std::string_view text);
    /// A line that is printed several times in succession is stored once, with their number.
    /// `output` and `note` show short numbers, the others every character.
    void output(std::string_view text) { add(LineKind::output, text, true); }
    void printed(std::string_view text) { add(LineKind::output, text); }
    void game(std::string_view text) { add(LineKind::game, text); }
    /// The output of a command.
    void output(const script::Evaluation& result);
    void note(std::string_view text) { add(LineKind::note, text, true); }
    /// Adds a note in front of the lines from this number on, which its subject has caused.
    void note(std::string_view text, std::uint64_t before);
    /// A note that ends with the path of a file.
    void file(std::string_view text, const std::string& file);
    /// Adds the message, the source line with carets below the error, and the traceback if it
    /// contains more than the message.
    void error(const script::ScriptError& error);
    void error(std::string_view message) { add(LineKind::error, message); }
    void clear();
    /// Adds a command in front of the lines from this number on, which it has caused.
    void command(std::string_view text, std::uint64_t before);
    /// Puts the lines of an earlier log in front of these.
    void put_first(const std::deque<LogLine>& earlier);
    /// Puts the hidden lines in the place of the fold at that index of `lines`.
    void unfold(std::size_t index);
    /// Opens the fold nearest to the end. Returns the number of its first line; nothing if there is
    /// no fold.
    std::optional<std::uint64_t> unfold_last();

    const std::deque<LogLine>& lines() const { return lines_; }
    /// Number of lines dropped so far: line i of `lines` has number `dropped() + i`.
    std::uint64_t dropped() const { return dropped_; }
    /// The number of the next line.
    std::uint64_t end() const { return dropped_ + lines_.size(); }
    /// A number that changes when lines other than the last have changed.
    std::uint64_t rearranged() const { return rearranged_; }

  private:
    void add(LineKind kind, std::string_view text, bool short_numbers = false);
    void add(LineKind kind, std::string_view text, bool short_numbers, std::uint64_t before);
    void push(LineKind kind, std::string text, bool short_numbers = false);
    void push(LogLine line);
    /// Hides the lines from that index on below one with the text.
    void fold(std::string text, std::size_t first);
    void table(std::span<const std::string> rows, const script::TableLines& of);

    std::deque<LogLine> lines_;
    std::uint64_t dropped_ = 0;
    std::uint64_t rearranged_ = 0;
};

}  // namespace fettle::console
