#include <text/log.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>

#include <text/highlight.h>
#include <text/utf8.h>

namespace fettle::console {

namespace {

/// Whether the traceback contains more lines of code than the one shown.
bool leads_elsewhere(const script::ScriptError& error) {
    std::size_t places = 0, begin = 0;
    const std::string& trace = error.traceback;
    while (begin < trace.size()) {
        std::size_t end = std::min(trace.find('\n', begin), trace.size());
        std::string_view frame = std::string_view(trace).substr(begin, end - begin);
        std::size_t colon = frame.find(':');
        bool place = colon != std::string_view::npos && colon + 1 < frame.size() &&
                     frame[colon + 1] >= '0' && frame[colon + 1] <= '9';
        places += place ? 1 : 0;
        begin = end + 1;
    }
    return places > 1;
}

/// Whether the message says less than what failed, such as "formula of world.ball.mass". A command
/// stands above its error.
bool names_context(const script::ScriptError& error) {
    return error.file.empty() && !error.context.empty() && error.context != "console";
}

/// The word at a column, counted from 1.
Span span_at(std::string_view source, std::size_t column) {
    std::size_t begin = std::min(code_point_offset(source, column - 1), source.size());
    std::size_t end = begin;
    for (const Span& span : highlight_command(source))
        if (span.begin <= begin && begin < span.end) end = span.end;
    // In a path, only the step at the column.
    end = std::min(end, source.find('.', begin));
    return {begin, end, Token::plain};
}

/// Whether a repeated line of that kind is counted. The lines of an error belong together.
bool is_counted(LineKind kind) {
    return kind == LineKind::output || kind == LineKind::game || kind == LineKind::note;
}

}  // namespace

void Log::push(LineKind kind, std::string text, bool short_numbers) {
    if (text.size() > max_line_bytes) {
        std::size_t whole = text.size();
        text.resize(code_point_boundary(text, max_line_bytes));
        text += " … (" + std::to_string(whole) + " bytes)";
    }
    LogLine line{kind, {}};
    if (short_numbers) {
        ShortLine made = with_short_numbers(text);
        line.text = std::move(made.text);
        line.numbers = std::move(made.numbers);
    } else {
        line.text = std::move(text);
    }
    if (is_counted(kind) && !lines_.empty() && lines_.back().kind == kind &&
        lines_.back().text == line.text && lines_.back().numbers == line.numbers &&
        !line.text.empty()) {
        ++lines_.back().count;
        return;
    }
    push(std::move(line));
}

void Log::push(LogLine line) {
    lines_.push_back(std::move(line));
    if (lines_.size() > max_lines) {
        lines_.pop_front();
        ++dropped_;
    }
}

void Log::add(LineKind kind, std::string_view text, bool short_numbers) {
    std::string clean = clean_text(text);
    std::size_t begin = 0;
    for (;;) {
        std::size_t end = clean.find('\n', begin);
        if (end == std::string::npos) break;
        push(kind, clean.substr(begin, end - begin), short_numbers);
        begin = end + 1;
        if (kind == LineKind::command) kind = LineKind::continuation;
    }
    // A newline at the end of the text does not begin another line.
    if (begin < clean.size() || begin == 0) push(kind, clean.substr(begin), short_numbers);
}

void Log::command(std::string_view text) {
    add(LineKind::command, text);
}

void Log::command(std::string_view text, std::uint64_t before) {
    add(LineKind::command, text, false, before);
}

void Log::note(std::string_view text, std::uint64_t before) {
    add(LineKind::note, text, true, before);
}

void Log::add(LineKind kind, std::string_view text, bool short_numbers, std::uint64_t before) {
    const std::uint64_t kept = std::max(before, dropped_) - dropped_;
    if (kept >= lines_.size()) return add(kind, text, short_numbers);
    const auto first = std::next(lines_.begin(), static_cast<std::ptrdiff_t>(kept));
    std::deque<LogLine> caused(std::make_move_iterator(first),
                               std::make_move_iterator(lines_.end()));
    lines_.erase(first, lines_.end());
    add(kind, text, short_numbers);
    for (LogLine& line : caused) push(std::move(line));
    ++rearranged_;
}

void Log::error(const script::ScriptError& error) {
    std::string message =
        (names_context(error) ? "in " + error.context + ": " : "") + error.message;
    if (message.size() > max_message_bytes) {
        message.resize(code_point_boundary(message, max_message_bytes));
        message += " …";
    }
    add(LineKind::error, message);
    if (!error.source_line.empty()) {
        std::string source = clean_text(error.source_line);
        std::replace(source.begin(), source.end(), '\n', ' ');
        Span span = error.column > 0 ? span_at(source, static_cast<std::size_t>(error.column))
                                     : error_span(source, error.message);
        std::size_t before = cell_count(std::string_view(source).substr(0, span.begin));
        std::size_t length =
            cell_count(std::string_view(source).substr(span.begin, span.end - span.begin));
        push(LineKind::source, source);
        push(LineKind::caret,
             std::string(before, ' ') + std::string(std::max<std::size_t>(length, 1), '^'));
    }
    if (leads_elsewhere(error)) add(LineKind::trace, error.traceback);
}

void Log::file(std::string_view text, const std::string& file) {
    LogLine line{LineKind::note, std::string(text) + file};
    line.file = file;
    push(std::move(line));
}

void Log::put_first(const std::deque<LogLine>& earlier) {
    const std::deque<LogLine> own = std::exchange(lines_, earlier);
    for (const LogLine& line : own) push(line);
    ++rearranged_;
}

void Log::clear() {
    dropped_ += lines_.size();
    lines_.clear();
    ++rearranged_;
}

/// Rows with short numbers have narrower columns. A cell that is wider than its column moves the
/// rest of its own row only.
void Log::table(std::span<const std::string> rows, const script::TableLines& of) {
    const auto shape = std::make_shared<LogTable>();
    const std::size_t columns = of.cells.front().size();
    // Where a cell begins. A row does not end with blanks, so its last cells may lie after it.
    const auto place = [&](std::size_t row, std::size_t k) {
        const std::size_t begin = of.cells[row][k], end = std::min(begin, rows[row].size());
        return cell_count(std::string_view(rows[row]).substr(0, end)) + begin - end;
    };
    std::vector<std::size_t> given(columns, std::string::npos);  // widths, with the gap
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t k = 0; k + 1 < std::min(columns, of.cells[i].size()); ++k)
            given[k] = std::min(given[k], place(i, k + 1) - place(i, k));
    std::vector<std::vector<ShortLine>> cells;
    std::vector<std::size_t> widths(columns);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::string_view row = rows[i];
        const std::vector<std::size_t>& begins = of.cells[i];
        cells.emplace_back();
        for (std::size_t k = 0; k < begins.size(); ++k) {
            const std::size_t begin = std::min(begins[k], row.size());
            const std::size_t next =
                k + 1 < begins.size() ? std::min(begins[k + 1], row.size()) : row.size();
            const std::string_view text = row.substr(begin, next - begin);
            const std::string_view cell = text.substr(0, text.find_last_not_of(' ') + 1);
            cells.back().push_back(with_short_numbers(cell));
            if (k >= columns) continue;
            if (cell_count(cell) <= given[k] - LogTable::gap)
                widths[k] = std::max(widths[k], cell_count(cells.back().back().text));
        }
    }
    for (std::size_t k = 0, begin = 0; k < columns; ++k) {
        shape->begins.push_back(begin);
        shape->end = begin + widths[k];
        begin += widths[k] + LogTable::gap;
    }
    for (const std::vector<ShortLine>& row : cells) {
        LogLine line{LineKind::output, {}};
        if (of.head) line.table = shape;
        for (std::size_t k = 0; k < row.size(); ++k) {
            if (k > 0) line.text.append(LogTable::gap, ' ');
            if (of.head) line.cells.push_back(line.text.size());
            for (ShortNumber number : row[k].numbers) {
                number.begin += line.text.size();
                number.end += line.text.size();
                line.numbers.push_back(std::move(number));
            }
            line.text += row[k].text;
            const std::size_t width = cell_count(row[k].text);
            if (k + 1 < row.size() && width < widths[k]) line.text.append(widths[k] - width, ' ');
        }
        line.text.resize(line.text.find_last_not_of(' ') + 1);
        push(std::move(line));
    }
}

void Log::fold(std::string text, std::size_t first) {
    LogLine fold{LineKind::fold, std::move(text)};
    const auto rest = std::next(lines_.begin(), static_cast<std::ptrdiff_t>(first));
    fold.hidden.assign(std::make_move_iterator(rest), std::make_move_iterator(lines_.end()));
    lines_.erase(rest, lines_.end());
    push(std::move(fold));
}

void Log::output(const script::Evaluation& result) {
    Log all;
    auto table = result.tables.begin();
    auto printed = result.printed.begin();
    auto folded = result.folded.begin();
    for (std::size_t i = 0; i < result.lines.size(); ++i) {
        const bool folds = folded != result.folded.end();
        if (table != result.tables.end() && table->first == i) {
            const std::size_t rows = std::min(table->cells.size(), result.lines.size() - i);
            const auto shown = std::span(result.lines).subspan(i, rows);
            i += rows - 1;
            if (folds && folded->line == i + 1 && !folded->cells.empty()) {
                // One table, whose last rows are hidden.
                script::TableLines whole = *table++;
                const auto more = std::span(folded->lines)
                                      .first(std::min(folded->cells.size(), folded->lines.size()));
                std::vector<std::string> lines(shown.begin(), shown.end());
                lines.insert(lines.end(), more.begin(), more.end());
                whole.cells.insert(whole.cells.end(), folded->cells.begin(), folded->cells.end());
                const std::size_t first = all.lines_.size() + rows;
                all.table(lines, whole);
                for (std::size_t k = more.size(); k < folded->lines.size(); ++k)
                    all.output(folded->lines[k]);
                all.fold(result.lines[++i], first);
                ++folded;
            } else {
                all.table(shown, *table++);
            }
        } else if (folds && folded->line == i) {
            const std::size_t first = all.lines_.size();
            for (const std::string& line : folded++->lines) all.output(line);
            all.fold(result.lines[i], first);
        } else if (printed != result.printed.end() && *printed == i) {
            all.printed(result.lines[i]);
            ++printed;
        } else {
            all.output(result.lines[i]);
        }
    }
    std::deque<LogLine>& lines = all.lines_;
    const auto shown =
        static_cast<std::ptrdiff_t>(lines.size() > max_unfolded ? shown_of_folded : lines.size());
    const auto rest = std::next(lines.begin(), shown);
    for (auto line = lines.begin(); line != rest; ++line) push(std::move(*line));
    if (rest == lines.end()) return;
    all.fold("… " + std::to_string(lines.end() - rest) + " more lines",
             static_cast<std::size_t>(shown));
    push(std::move(lines.back()));
}

void Log::unfold(std::size_t index) {
    if (index >= lines_.size() || lines_[index].kind != LineKind::fold) return;
    std::vector<LogLine> hidden = std::move(lines_[index].hidden);
    const auto fold = std::next(lines_.begin(), static_cast<std::ptrdiff_t>(index));
    std::deque<LogLine> after(std::make_move_iterator(std::next(fold)),
                              std::make_move_iterator(lines_.end()));
    lines_.erase(fold, lines_.end());
    for (LogLine& line : hidden) push(std::move(line));
    for (LogLine& line : after) push(std::move(line));
    ++rearranged_;
}

std::optional<std::uint64_t> Log::unfold_last() {
    for (std::size_t i = lines_.size(); i-- > 0;) {
        if (lines_[i].kind != LineKind::fold) continue;
        const std::uint64_t number = dropped_ + i;
        unfold(i);
        return number;
    }
    return std::nullopt;
}

}  // namespace fettle::console
