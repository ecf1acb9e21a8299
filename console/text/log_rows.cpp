#include <text/log_rows.h>

#include <algorithm>

#include <fettle/property/spelling.h>

#include <text/utf8.h>

namespace fettle::console {

namespace {

constexpr std::size_t row_indent = 4;  // cells, of the rows of a table after the first

/// Whether a step of a path begins at the byte: ".name" after a name, or what follows a slash.
bool is_step(std::string_view text, std::size_t at) {
    const auto letter = [&](std::size_t i) {
        const auto c = static_cast<unsigned char>(text[i]);
        return c == '_' || c >= 0x80 || (c | 32u) - 'a' < 26u;
    };
    if (at + 1 >= text.size() || at == 0) return false;
    if (text[at] == '.') return letter(at + 1) && text[at - 1] != ' ';
    return text[at - 1] == '/' && letter(at);
}

/// Where the last column of a table begins, if that is between `from` and `end`; otherwise `end`. A
/// column that begins after the middle of a row is moved to the next row, because little of it
/// would fit.
std::size_t last_column(std::string_view text, std::size_t from, std::size_t end) {
    const std::size_t gap = text.substr(0, end).rfind("  ");
    if (gap == std::string_view::npos || gap < from) return end;
    return std::min(text.find_first_not_of(' ', gap), end);
}

/// Where a row that begins at `begin` and has room up to `end` ends best: after a blank outside of
/// brackets and texts, after another blank, before a step of a path, or at `end`. No row is less
/// than half full.
std::size_t break_in(std::string_view text, std::size_t begin, std::size_t end) {
    const std::size_t half = begin + (end - begin) / 2, late = begin + (end - begin) * 2 / 3;
    std::size_t outside = 0, blank = 0, step = 0, open = 0;
    bool quoted = false;
    for (std::size_t i = begin; i < end; ++i) {
        const char c = text[i];
        if (c == '"') quoted = !quoted;
        if (!quoted && (c == '(' || c == '[' || c == '{')) ++open;
        if (!quoted && (c == ')' || c == ']' || c == '}') && open > 0) --open;
        if (c == ' ' && i > half) blank = i + 1;
        if (c == ' ' && i > late && open == 0 && !quoted) outside = i + 1;
        if (i > half && i > begin && is_step(text, i)) step = i;
    }
    return outside > 0 ? outside : blank > 0 ? blank : step > 0 ? step : end;
}

}  // namespace

const LogLine* LogRows::line(std::uint64_t number) const {
    if (number < log_.dropped() || number - log_.dropped() >= log_.lines().size()) return nullptr;
    return &log_.lines()[number - log_.dropped()];
}

/// Columns by which the rows after the first are indented: to the last column of a table, or, in
/// other lines, as far as the line itself.
std::size_t LogRows::hanging_indent(std::string_view text) const {
    const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
    std::size_t hang = begin;
    for (std::size_t gap = text.find("  ", begin); gap != std::string_view::npos;
         gap = text.find("  ", hang)) {
        const std::size_t next = text.find_first_not_of(' ', gap);
        if (next == std::string_view::npos) break;
        const std::size_t column = cell_count(text.substr(0, next));
        if (column > columns_ / 2) break;
        hang = next;
    }
    return std::min(cell_count(text.substr(0, hang)), columns_ / 2);
}

/// Adds a row with the part of a line of carets that lies below a row of its source line.
void LogRows::mark_row(std::uint64_t number, const LogRow& source) {
    const LogLine* found = line(number);
    if (found == nullptr || found->kind != LineKind::caret) return;
    const std::string_view code = line(source.line)->text;
    const std::size_t from = cell_count(code.substr(0, source.begin));
    const std::size_t to =
        source.end == code.size() ? found->text.size() : cell_count(code.substr(0, source.end));
    const std::size_t first = found->text.find('^');
    const std::size_t begin = std::min(from, found->text.size());
    const std::size_t end = std::min(to, found->text.size());
    if (first >= end || begin >= found->text.size()) return;
    rows_.push_back({number, begin, end, begin == 0, source.indent});
}

/// Breaks a part of a line. `part`: its first row if it did not need more than one; `hang`: how far
/// the others are indented.
void LogRows::wrap_part(std::uint64_t number, const LogLine& whole, LogRow part, std::size_t hang) {
    const std::string_view text = std::string_view(whole.text).substr(0, part.end);
    const std::size_t first = part.begin;
    do {
        const std::size_t wide = columns_ - part.indent;
        part.end = part.begin + cell_offset(text.substr(part.begin), wide);
        if (part.end < text.size()) {
            const std::size_t column = last_column(text, part.begin + wide / 2, part.end);
            if (column < part.end) {
                part.end = column;
                if (part.begin == first) hang = std::min(hang + 2, columns_ / 2);
            } else {
                part.end = break_in(text, part.begin, part.end);
            }
        }
        rows_.push_back(part);
        if (whole.kind == LineKind::source) mark_row(number + 1, LogRow(rows_.back()));
        part = {number, part.end, text.size(), false, hang};
    } while (part.begin < text.size());
}

/// Breaks the row of a table. All its rows break before the same cells, so that their columns stay
/// columns.
void LogRows::wrap_cells(std::uint64_t number, const LogLine& whole) {
    const LogTable& table = *whole.table;
    const std::size_t count = whole.cells.size();
    const auto offset = [&](std::size_t cell) {
        return cell < count ? std::min(whole.cells[cell], whole.text.size()) : whole.text.size();
    };
    const auto end_of = [&](std::size_t cell) {
        return cell + 1 < table.begins.size() ? table.begins[cell + 1] - LogTable::gap : table.end;
    };
    for (std::size_t from = 0, indent = 0; from < count; indent = row_indent) {
        std::size_t to = from + 1;
        while (to < count && end_of(to) - table.begins[from] + indent <= columns_) ++to;
        // Without the blanks in front of the next cell.
        const std::size_t last =
            std::string_view(whole.text).substr(0, offset(to)).find_last_not_of(' ');
        const std::size_t begin = offset(from), end = std::max(begin, last + 1);
        if (from == 0 || begin < end)
            wrap_part(number, whole, {number, begin, end, from == 0, indent},
                      std::min(indent + row_indent, columns_ / 2));
        from = to;
    }
}

void LogRows::wrap_line(std::uint64_t number, const LogLine& whole) {
    // Carets are added below the row with the place that they mark.
    if (whole.kind == LineKind::caret) return;
    if (whole.table && whole.cells.size() == whole.table->begins.size())
        return wrap_cells(number, whole);
    // Two blanks in code do not separate columns.
    const bool is_code = whole.kind == LineKind::command || whole.kind == LineKind::continuation ||
                         whole.kind == LineKind::source;
    const std::size_t blanks = std::min(whole.text.find_first_not_of(' '), whole.text.size());
    wrap_part(number, whole, {number, 0, whole.text.size(), true},
              is_code ? std::min(blanks, columns_ / 2) : hanging_indent(whole.text));
}

void LogRows::filter(std::string_view text) {
    if (text == filter_) return;
    filter_ = text;
    columns_ = 0;  // all lines are wrapped again
}

/// Ignores case, and finds whole numbers, too. A fold passes, because one of its hidden lines may.
bool LogRows::passes(const LogLine& whole) const {
    if (filter_.empty() || whole.kind == LineKind::fold) return true;
    return property::contains_ignoring_case(whole.text, filter_) ||
           (!whole.numbers.empty() && property::contains_ignoring_case(whole.whole(), filter_));
}

bool LogRows::wrap(std::size_t columns) {
    const bool rearranged = rearranged_ != log_.rearranged();
    if (columns != columns_ || rearranged) {
        rows_.clear();
        columns_ = columns;
        wrapped_ = log_.dropped();
        rearranged_ = log_.rearranged();
    }
    while (!rows_.empty() && rows_.front().line < log_.dropped()) rows_.pop_front();
    wrapped_ = std::max(wrapped_, log_.dropped());
    for (; const LogLine* next = line(wrapped_); ++wrapped_)
        if (passes(*next)) wrap_line(wrapped_, *next);
    return rearranged;
}

std::vector<std::string> LogRows::texts() const {
    std::vector<std::string> all;
    for (const LogRow& row : rows_)
        if (const LogLine* found = line(row.line))
            all.push_back(std::string(row.indent, ' ') +
                          found->text.substr(row.begin, row.end - row.begin));
    return all;
}

}  // namespace fettle::console
