#include <views/log_view.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <fettle/property/spelling.h>
#include <fettle/property/value.h>

#include <look/theme.h>
#include <text/utf8.h>

namespace fettle::console {

namespace {

constexpr std::size_t gutter = 2;  // columns

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

std::vector<Span> spans_of(const LogLine& line) {
    switch (line.kind) {
        case LineKind::command:
        case LineKind::continuation:
        case LineKind::source:
            return highlight_command(line.text);
        case LineKind::output:
        case LineKind::game:
        case LineKind::note:
        case LineKind::error:
            return highlight_output(line.text);
        default:
            return {};
    }
}

/// The path in the line that contains the byte at `offset`.
std::optional<Span> path_at(const LogLine& line, std::size_t offset) {
    for (const Span& span : spans_of(line))
        if (span.token == Token::path && offset >= span.begin && offset < span.end) return span;
    return std::nullopt;
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

bool colored(LineKind kind) {
    return kind == LineKind::command || kind == LineKind::continuation ||
           kind == LineKind::source || kind == LineKind::output || kind == LineKind::game;
}

}  // namespace

const LogLine* LogView::line(std::uint64_t number) const {
    if (number < log_.dropped() || number - log_.dropped() >= log_.lines().size()) return nullptr;
    return &log_.lines()[number - log_.dropped()];
}

/// Columns by which the rows after the first are indented: to the last column of a table, or, in
/// other lines, as far as the line itself.
std::size_t LogView::hanging_indent(std::string_view text) const {
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
void LogView::mark_row(std::uint64_t number, const Row& source) {
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
void LogView::wrap_part(std::uint64_t number, const LogLine& whole, Row part, std::size_t hang) {
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
        if (whole.kind == LineKind::source) mark_row(number + 1, Row(rows_.back()));
        part = {number, part.end, text.size(), false, hang};
    } while (part.begin < text.size());
}

/// Breaks the row of a table. All its rows break before the same cells, so that their columns stay
/// columns.
void LogView::wrap_cells(std::uint64_t number, const LogLine& whole) {
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

void LogView::wrap_line(std::uint64_t number, const LogLine& whole) {
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

void LogView::filter(std::string_view text) {
    if (text == filter_) return;
    filter_ = text;
    columns_ = 0;  // all lines are wrapped again
}

/// Ignores case, and finds whole numbers, too. A fold passes, because one of its hidden lines may.
bool LogView::passes(const LogLine& whole) const {
    if (filter_.empty() || whole.kind == LineKind::fold) return true;
    return property::contains_ignoring_case(whole.text, filter_) ||
           (!whole.numbers.empty() && property::contains_ignoring_case(whole.whole(), filter_));
}

void LogView::wrap(std::size_t columns) {
    if (columns != columns_ || rearranged_ != log_.rearranged()) {
        rows_.clear();
        columns_ = columns;
        wrapped_ = log_.dropped();
        if (rearranged_ != log_.rearranged()) selection_.reset();
        rearranged_ = log_.rearranged();
    }
    while (!rows_.empty() && rows_.front().line < log_.dropped()) rows_.pop_front();
    wrapped_ = std::max(wrapped_, log_.dropped());
    for (; const LogLine* next = line(wrapped_); ++wrapped_)
        if (passes(*next)) wrap_line(wrapped_, *next);
}

void LogView::draw(float height, float cell) {
    float line_height = ImGui::GetTextLineHeightWithSpacing();
    // Whole rows: the topmost one is not cut.
    if (const float rest = std::fmod(height, line_height); rest < height) {
        ImGui::SetCursorPosY(ImGui::GetCursorPosY() + rest);
        height -= rest;
    }
    ImGui::BeginChild("log", ImVec2(0, height));
    float width = ImGui::GetWindowWidth() - ImGui::GetStyle().ScrollbarSize;
    const std::size_t columns = columns_;
    wrap(static_cast<std::size_t>(std::max(8.0f, std::floor(width / cell) - gutter)));
    if (columns != columns_ || line_height != line_height_ || height != height_)
        reshaped_to_ = place_after_reshaping(line_height, height);
    height_ = height;

    ImVec2 origin = ImGui::GetCursorScreenPos();
    if (reshaped_to_) origin.y += ImGui::GetScrollY() - *reshaped_to_;
    float total = static_cast<float>(rows_.size()) * line_height;
    // A few lines are placed at the bottom, next to the prompt.
    float slack = std::max(0.0f, height - total);
    origin.y += slack;
    ImGui::InvisibleButton("text", ImVec2(std::max(1.0f, width), std::max(1.0f, slack + total)));
    mouse(origin, line_height, cell);
    float top = ImGui::GetWindowPos().y;
    auto first = static_cast<std::ptrdiff_t>((top - origin.y) / line_height);
    auto last = static_cast<std::ptrdiff_t>((top + height - origin.y) / line_height) + 1;
    for (auto i = std::max<std::ptrdiff_t>(0, first);
         i < std::min(last, static_cast<std::ptrdiff_t>(rows_.size())); ++i)
        draw_row(rows_[static_cast<std::size_t>(i)],
                 ImVec2(origin.x, origin.y + static_cast<float>(i) * line_height), line_height,
                 cell);
    if (const std::ptrdiff_t topmost = std::lround((top - origin.y) / line_height); !rows_.empty())
        top_ = rows_[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
                         topmost, 0, static_cast<std::ptrdiff_t>(rows_.size()) - 1))]
                   .line;
    at_end_ = reshaped_to_ ? at_end_ : ImGui::GetScrollY() >= ImGui::GetScrollMaxY() - 1;
    scroll(line_height);
    cell_ = cell;
    line_height_ = line_height;
    scrolled_ = ImGui::GetScrollY();
    text_end_ = ImVec2(origin.x, origin.y + total);
    ImGui::EndChild();
}

namespace {

constexpr float swatch_height = 3;  // px; below the text, so that it covers nothing

/// The color of a text such as "#ff8000" in `color("#ff8000")`.
std::optional<ImU32> color_at(std::string_view text, const Span& span) {
    if (span.token != Token::string || !text.substr(0, span.begin).ends_with("color(")) return {};
    const std::string_view quoted = text.substr(span.begin, span.end - span.begin);
    property::Color found;
    if (quoted.size() < 2 || !property::parse_color(quoted.substr(1, quoted.size() - 2), found))
        return {};
    return ImGui::ColorConvertFloat4ToU32(ImVec4(found.r, found.g, found.b, found.a));
}

}  // namespace

void LogView::draw_row(const Row& row, ImVec2 at, float line_height, float cell) {
    const LogLine* found = line(row.line);
    if (found == nullptr) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_selection(row, at, line_height, cell);
    if (row.first && found->kind == LineKind::command)
        draw_text(list, at, palette::accent, "›");
    else if (row.first && found->kind == LineKind::continuation)
        draw_text(list, at, palette::faint, "·");
    else if (row.first && found->kind == LineKind::game)
        draw_text(list, at, palette::dim, "│");
    else if (row.first && found->kind == LineKind::error)
        draw_text(list, at, palette::error, "✗");
    at.x += static_cast<float>(gutter + row.indent) * cell;

    std::string_view text = found->text;
    std::size_t done = row.begin;
    float x = at.x;
    auto put = [&](std::size_t to, ImU32 color) {
        to = std::min(to, row.end);
        if (to <= done) return;
        std::string_view piece = text.substr(done, to - done);
        draw_text(list, ImVec2(x, at.y), color, piece);
        x += static_cast<float>(cell_count(piece)) * cell;
        done = to;
    };
    ImU32 base = line_color(found->kind);
    for (const Span& span : spans_of(*found)) {
        put(span.begin, base);
        float from = x;
        bool is_path = span.token == Token::path && found->kind != LineKind::error;
        put(span.end, colored(found->kind) || is_path ? token_color(span.token) : base);
        if (const auto swatch = color_at(text, span); swatch && x > from)
            list.AddRectFilled(ImVec2(from, at.y + line_height - swatch_height),
                               ImVec2(x, at.y + line_height), *swatch);
        bool hovered = hovering_link_ && link_line_ == row.line && link_.begin == span.begin;
        if (hovered && x > from) {
            float y = std::round(at.y + ImGui::GetTextLineHeight()) - 1;
            list.AddLine(ImVec2(from, y), ImVec2(x, y), palette::path);
        }
    }
    put(row.end, base);
    if (found->count > 1 && row.end == text.size())
        draw_text(list, ImVec2(x + cell, at.y), palette::faint, "×" + std::to_string(found->count));
}

void LogView::draw_selection(const Row& row, ImVec2 at, float line_height, float cell) {
    if (!selecting()) return;
    auto [from, to] = std::minmax(selection_->from, selection_->to);
    if (to.line < row.line || from.line > row.line) return;
    std::size_t begin = from.line < row.line ? row.begin : std::max(from.offset, row.begin);
    std::size_t end = to.line > row.line ? row.end : std::min(to.offset, row.end);
    if (begin > end || (begin == end && to.line == row.line)) return;
    std::string_view text = line(row.line)->text;
    auto column = [&](std::size_t offset) {
        return static_cast<float>(gutter + row.indent +
                                  cell_count(text.substr(row.begin, offset - row.begin)));
    };
    float right = column(end) + (to.line > row.line && end == text.size() ? 0.5f : 0);
    ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(at.x + column(begin) * cell, at.y),
                                              ImVec2(at.x + right * cell, at.y + line_height),
                                              palette::selection);
}

LogView::Point LogView::point_at(std::ptrdiff_t index, float column) const {
    auto count = static_cast<std::ptrdiff_t>(rows_.size());
    if (index < 0 || count == 0) return {count == 0 ? 0 : rows_.front().line, 0};
    if (index >= count) return {rows_.back().line, rows_.back().end};
    const Row& row = rows_[static_cast<std::size_t>(index)];
    const LogLine* found = line(row.line);
    if (found == nullptr) return {row.line, 0};
    std::string_view text = std::string_view(found->text).substr(row.begin, row.end - row.begin);
    auto cells = static_cast<std::size_t>(std::max(0.0f, column - static_cast<float>(row.indent)));
    return {row.line, row.begin + cell_offset(text, cells)};
}

std::string_view LogView::pointed_link() const {
    const LogLine* const found = hovering_link_ ? line(link_line_) : nullptr;
    if (found == nullptr || link_.end > found->text.size()) return {};
    return std::string_view(found->text).substr(link_.begin, link_.end - link_.begin);
}

bool LogView::hover(Point point) {
    const LogLine* found = line(point.line);
    if (found == nullptr) return false;
    if (const std::optional<Span> span = path_at(*found, point.offset)) {
        const std::string_view path =
            std::string_view(found->text).substr(span->begin, span->end - span->begin);
        if (is_link && is_link(path)) {
            hovering_link_ = true;
            link_line_ = point.line;
            link_ = *span;
            ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
            if (ImGui::IsMouseClicked(1) && menu) menu(path);
        }
    }
    for (const ShortNumber& number : found->numbers)
        if (point.offset >= number.begin && point.offset < number.end) show_tip(number.whole);
    if (!found->file.empty()) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        show_tip("A click copies the path of the file");
        if (ImGui::IsMouseClicked(0) && take_file) {
            take_file(std::string(found->file));
            return true;
        }
    }
    if (found->kind == LineKind::fold) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        ImGui::SetTooltip("A click opens it; Ctrl+O opens the last one of the log");
        if (ImGui::IsMouseClicked(0) && unfold) {
            unfold(static_cast<std::size_t>(point.line - log_.dropped()));
            return true;
        }
    }
    return false;
}

void LogView::select_word(Point point) {
    if (const LogLine* found = line(point.line))
        for (const Span& span : highlight_output(found->text))
            if (point.offset >= span.begin && point.offset < span.end)
                selection_ = Selection{{point.line, span.begin}, {point.line, span.end}};
}

void LogView::follow_path(Point point) {
    const LogLine* found = line(point.line);
    if (found == nullptr || !follow) return;
    if (const std::optional<Span> span = path_at(*found, point.offset))
        follow(found->text.substr(span->begin, span->end - span->begin),
               ImGui::GetIO().KeyCtrl || ImGui::GetIO().KeyShift);
}

void LogView::mouse(ImVec2 origin, float line_height, float cell) {
    ImVec2 at = ImGui::GetIO().MousePos;
    auto row = static_cast<std::ptrdiff_t>(std::floor((at.y - origin.y) / line_height));
    float column = (at.x - origin.x) / cell - static_cast<float>(gutter);
    bool hovered = ImGui::IsItemHovered();
    hovering_link_ = false;
    bool on_text = row >= 0 && row < static_cast<std::ptrdiff_t>(rows_.size()) && column >= 0;
    if (hovered && on_text && !dragging_ && hover(point_at(row, column))) return;
    Point caret = point_at(row, column + 0.5f);  // between the characters nearest to the mouse
    if (hovered && ImGui::IsMouseClicked(0)) {
        selection_ = Selection{caret, caret};
        dragging_ = true;
    }
    if (dragging_ && ImGui::IsMouseDown(0) && selection_) selection_->to = caret;
    if (hovered && ImGui::IsMouseDoubleClicked(0) && on_text) {
        select_word(point_at(row, column));
        dragging_ = false;
    }
    if (ImGui::IsMouseReleased(0)) {
        if (dragging_ && !selecting() && hovered && on_text) follow_path(point_at(row, column));
        dragging_ = false;
    }
}

std::vector<std::string> LogView::shown_rows() const {
    std::vector<std::string> all;
    for (const Row& row : rows_)
        if (const LogLine* found = line(row.line))
            all.push_back(std::string(row.indent, ' ') +
                          found->text.substr(row.begin, row.end - row.begin));
    return all;
}

std::string LogView::selected() const {
    std::string out;
    if (!selecting()) return out;
    auto [from, to] = std::minmax(selection_->from, selection_->to);
    for (std::uint64_t number = from.line; number <= to.line; ++number) {
        const LogLine* found = line(number);
        if (found == nullptr) continue;
        std::size_t begin = number == from.line ? std::min(from.offset, found->text.size()) : 0;
        std::size_t end = number == to.line ? to.offset : found->text.size();
        if (!out.empty() || number != from.line) out += '\n';
        out += found->whole(begin, std::max(end, begin));
    }
    return out;
}

}  // namespace fettle::console
