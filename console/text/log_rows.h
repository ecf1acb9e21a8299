#pragma once
// The rows of the log: its lines, wrapped to a width. Lines are wrapped once, when they are new.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include <text/log.h>

namespace fettle::console {

struct LogRow {
    std::uint64_t line;      // number of the line since the beginning
    std::size_t begin, end;  // bytes of the line
    bool first;              // the first row of its line
    std::size_t indent = 0;  // columns; rows after the first begin below the text of a column
};

class LogRows {
  public:
    explicit LogRows(const Log& log) : log_(log) {}

    /// Only lines that contain the text get rows; "": all.
    void filter(std::string_view text);
    /// Wraps new lines, or all of them if the number of columns is another one. True if lines of
    /// the log have got other numbers.
    bool wrap(std::size_t columns);

    const std::deque<LogRow>& all() const { return rows_; }
    std::size_t columns() const { return columns_; }
    /// Lines with smaller numbers have rows.
    std::uint64_t wrapped() const { return wrapped_; }
    /// The line of the log with that number; nullptr if the log does not have it any more.
    const LogLine* line(std::uint64_t number) const;
    /// All rows as text, from the first column after the signs.
    std::vector<std::string> texts() const;

  private:
    bool passes(const LogLine& whole) const;
    void wrap_line(std::uint64_t number, const LogLine& line);
    void wrap_cells(std::uint64_t number, const LogLine& line);
    void wrap_part(std::uint64_t number, const LogLine& line, LogRow part, std::size_t hang);
    std::size_t hanging_indent(std::string_view text) const;
    void mark_row(std::uint64_t number, const LogRow& source);

    const Log& log_;
    std::string filter_;
    std::deque<LogRow> rows_;
    std::size_t columns_ = 0;
    std::uint64_t wrapped_ = 0;
    std::uint64_t rearranged_ = 0;  // Log::rearranged of these rows
};

}  // namespace fettle::console
