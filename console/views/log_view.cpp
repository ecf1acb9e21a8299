#include <views/log_view.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <fettle/property/value.h>

#include <look/theme.h>
#include <text/utf8.h>

namespace fettle::console {

namespace {

constexpr std::size_t gutter = 2;  // columns

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

bool colored(LineKind kind) {
    return kind == LineKind::command || kind == LineKind::continuation ||
           kind == LineKind::source || kind == LineKind::output || kind == LineKind::game;
}

}  // namespace

void LogView::draw(float height, float cell) {
    float line_height = ImGui::GetTextLineHeightWithSpacing();
    // Whole rows: the topmost one is not cut.
    if (const float rest = std::fmod(height, line_height); rest < height) {
        ImGui::SetCursorPosY(ImGui::GetCursorPosY() + rest);
        height -= rest;
    }
    ImGui::BeginChild("log", ImVec2(0, height));
    float width = ImGui::GetWindowWidth() - ImGui::GetStyle().ScrollbarSize;
    const std::size_t columns = rows_.columns();
    if (rows_.wrap(static_cast<std::size_t>(std::max(8.0f, std::floor(width / cell) - gutter))))
        selection_.reset();
    if (columns != rows_.columns() || line_height != line_height_ || height != height_)
        reshaped_to_ = place_after_reshaping(line_height, height);
    height_ = height;

    ImVec2 origin = ImGui::GetCursorScreenPos();
    if (reshaped_to_) origin.y += ImGui::GetScrollY() - *reshaped_to_;
    float total = static_cast<float>(rows_.all().size()) * line_height;
    // A few lines are placed at the bottom, next to the prompt.
    float slack = std::max(0.0f, height - total);
    origin.y += slack;
    ImGui::InvisibleButton("text", ImVec2(std::max(1.0f, width), std::max(1.0f, slack + total)));
    mouse(origin, line_height, cell);
    float top = ImGui::GetWindowPos().y;
    auto first = static_cast<std::ptrdiff_t>((top - origin.y) / line_height);
    auto last = static_cast<std::ptrdiff_t>((top + height - origin.y) / line_height) + 1;
    for (auto i = std::max<std::ptrdiff_t>(0, first);
         i < std::min(last, static_cast<std::ptrdiff_t>(rows_.all().size())); ++i)
        draw_row(rows_.all()[static_cast<std::size_t>(i)],
                 ImVec2(origin.x, origin.y + static_cast<float>(i) * line_height), line_height,
                 cell);
    if (!rows_.all().empty()) {
        const auto topmost =
            static_cast<std::ptrdiff_t>(std::lround((top - origin.y) / line_height));
        const auto count = static_cast<std::ptrdiff_t>(rows_.all().size());
        top_ =
            rows_.all()[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(topmost, 0, count - 1))]
                .line;
    }
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

void LogView::draw_row(const LogRow& row, ImVec2 at, float line_height, float cell) {
    const LogLine* found = rows_.line(row.line);
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
        bool hovered = link_.hovered && link_.line == row.line && link_.span.begin == span.begin;
        if (hovered && x > from) {
            float y = std::round(at.y + ImGui::GetTextLineHeight()) - 1;
            list.AddLine(ImVec2(from, y), ImVec2(x, y), palette::path);
        }
    }
    put(row.end, base);
    if (found->count > 1 && row.end == text.size())
        draw_text(list, ImVec2(x + cell, at.y), palette::faint, "×" + std::to_string(found->count));
}

void LogView::draw_selection(const LogRow& row, ImVec2 at, float line_height, float cell) {
    if (!selecting()) return;
    auto [from, to] = std::minmax(selection_->from, selection_->to);
    if (to.line < row.line || from.line > row.line) return;
    std::size_t begin = from.line < row.line ? row.begin : std::max(from.offset, row.begin);
    std::size_t end = to.line > row.line ? row.end : std::min(to.offset, row.end);
    if (begin > end || (begin == end && to.line == row.line)) return;
    std::string_view text = rows_.line(row.line)->text;
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
    auto count = static_cast<std::ptrdiff_t>(rows_.all().size());
    if (index < 0 || count == 0) return {count == 0 ? 0 : rows_.all().front().line, 0};
    if (index >= count) return {rows_.all().back().line, rows_.all().back().end};
    const LogRow& row = rows_.all()[static_cast<std::size_t>(index)];
    const LogLine* found = rows_.line(row.line);
    if (found == nullptr) return {row.line, 0};
    std::string_view text = std::string_view(found->text).substr(row.begin, row.end - row.begin);
    auto cells = static_cast<std::size_t>(std::max(0.0f, column - static_cast<float>(row.indent)));
    return {row.line, row.begin + cell_offset(text, cells)};
}

std::string_view LogView::pointed_link() const {
    const LogLine* const found = link_.hovered ? rows_.line(link_.line) : nullptr;
    const auto& [begin, end, token] = link_.span;
    if (found == nullptr || end > found->text.size()) return {};
    return std::string_view(found->text).substr(begin, end - begin);
}

bool LogView::hover(Point point) {
    const LogLine* found = rows_.line(point.line);
    if (found == nullptr) return false;
    if (const std::optional<Span> span = path_at(*found, point.offset)) {
        const std::string_view path =
            std::string_view(found->text).substr(span->begin, span->end - span->begin);
        if (is_link && is_link(path)) {
            link_ = {.line = point.line, .span = *span, .hovered = true};
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
    if (const LogLine* found = rows_.line(point.line))
        for (const Span& span : highlight_output(found->text))
            if (point.offset >= span.begin && point.offset < span.end)
                selection_ = Selection{{point.line, span.begin}, {point.line, span.end}};
}

void LogView::follow_path(Point point) {
    const LogLine* found = rows_.line(point.line);
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
    link_.hovered = false;
    bool on_text = row >= 0 && row < static_cast<std::ptrdiff_t>(rows_.all().size()) && column >= 0;
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

std::string LogView::selected() const {
    std::string out;
    if (!selecting()) return out;
    auto [from, to] = std::minmax(selection_->from, selection_->to);
    for (std::uint64_t number = from.line; number <= to.line; ++number) {
        const LogLine* found = rows_.line(number);
        if (found == nullptr) continue;
        std::size_t begin = number == from.line ? std::min(from.offset, found->text.size()) : 0;
        std::size_t end = number == to.line ? to.offset : found->text.size();
        if (!out.empty() || number != from.line) out += '\n';
        out += found->whole(begin, std::max(end, begin));
    }
    return out;
}

}  // namespace fettle::console
