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

void Log::push(LineKind kind, std::string text) {
    if (text.size() > max_line_bytes) {
        std::size_t whole = text.size();
        text.resize(code_point_boundary(text, max_line_bytes));
        text += " … (" + std::to_string(whole) + " bytes)";
    }
    if (is_counted(kind) && !lines_.empty() && lines_.back().kind == kind &&
        lines_.back().text == text && !text.empty()) {
        ++lines_.back().count;
        return;
    }
    push(LogLine{kind, std::move(text)});
}

void Log::push(LogLine line) {
    lines_.push_back(std::move(line));
    if (lines_.size() > max_lines) {
        lines_.pop_front();
        ++dropped_;
    }
}

void Log::add(LineKind kind, std::string_view text) {
    std::string clean = clean_text(text);
    std::size_t begin = 0;
    for (;;) {
        std::size_t end = clean.find('\n', begin);
        if (end == std::string::npos) break;
        push(kind, clean.substr(begin, end - begin));
        begin = end + 1;
        if (kind == LineKind::command) kind = LineKind::continuation;
    }
    // A newline at the end of the text does not begin another line.
    if (begin < clean.size() || begin == 0) push(kind, clean.substr(begin));
}

void Log::command(std::string_view text) {
    add(LineKind::command, text);
}

void Log::command(std::string_view text, std::uint64_t before) {
    const std::uint64_t kept = std::max(before, dropped_) - dropped_;
    if (kept >= lines_.size()) return command(text);
    const auto first = std::next(lines_.begin(), static_cast<std::ptrdiff_t>(kept));
    std::deque<LogLine> caused(std::make_move_iterator(first),
                               std::make_move_iterator(lines_.end()));
    lines_.erase(first, lines_.end());
    command(text);
    for (LogLine& line : caused) push(std::move(line));
    ++rearranged_;
}

void Log::error(const script::ScriptError& error) {
    std::string message = error.message;
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

void Log::table(std::span<const std::string> rows, const script::TableLines& of) {
    const auto shape = std::make_shared<LogTable>();
    const std::string_view head = rows.front();
    for (const std::size_t begin : of.cells.front())
        shape->begins.push_back(cell_count(head.substr(0, begin)));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::size_t last = of.cells[i].back();
        if (last < rows[i].size())
            shape->end =
                std::max(shape->end,
                         shape->begins.back() + cell_count(std::string_view(rows[i]).substr(last)));
    }
    for (std::size_t i = 0; i < rows.size(); ++i)
        push(LogLine{LineKind::output, rows[i], 1, {}, {}, shape, of.cells[i]});
}

void Log::output(const std::vector<std::string>& lines,
                 const std::vector<script::TableLines>& tables) {
    const bool folds = lines.size() > max_unfolded;
    const std::size_t shown = folds ? shown_of_folded : lines.size();
    auto next = tables.begin();
    for (std::size_t i = 0; i < shown; ++i) {
        if (next == tables.end() || next->first != i) {
            output(lines[i]);
            continue;
        }
        const std::size_t rows = std::min(next->cells.size(), shown - i);
        table(std::span(lines).subspan(i, rows), *next++);
        i += rows - 1;
    }
    if (!folds) return;
    LogLine fold{LineKind::fold, "… " + std::to_string(lines.size() - shown) + " more lines"};
    for (std::size_t i = shown; i < lines.size(); ++i) fold.hidden.push_back(lines[i]);
    push(std::move(fold));
}

void Log::unfold(std::size_t index) {
    if (index >= lines_.size() || lines_[index].kind != LineKind::fold) return;
    const std::vector<std::string> hidden = std::move(lines_[index].hidden);
    const auto fold = std::next(lines_.begin(), static_cast<std::ptrdiff_t>(index));
    std::deque<LogLine> behind(std::make_move_iterator(std::next(fold)),
                               std::make_move_iterator(lines_.end()));
    lines_.erase(fold, lines_.end());
    for (const std::string& line : hidden) output(line);
    for (LogLine& line : behind) push(std::move(line));
    ++rearranged_;
}

}  // namespace fettle::console
