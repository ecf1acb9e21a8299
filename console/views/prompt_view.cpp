#include <views/prompt_view.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <look/imgui_compat.h>
#include <look/theme.h>
#include <text/highlight.h>
#include <text/short_numbers.h>
#include <text/utf8.h>

namespace fettle::console {

namespace {

constexpr float prompt_gutter = 2;  // columns
constexpr std::size_t menu_rows = 10;
constexpr float row_padding = 5;  // pixels
constexpr double blink_seconds = 0.55;
constexpr float gap = 5, edge = 8;  // pixels between the prompt and the list, and around it

float columns(std::string_view text) {
    return static_cast<float>(cell_count(text));
}

/// What is known of a candidate beside its name, with short numbers.
std::string facts(const script::Completion& of) {
    return with_short_numbers(of.detail).text;
}

}  // namespace

float PromptView::height(float available) const {
    float line_height = ImGui::GetTextLineHeightWithSpacing();
    auto lines = static_cast<float>(prompt_.edit().line_count());
    float padding = 2 * ImGui::GetStyle().FramePadding.y;
    // Whole lines: a line that is cut cannot be read.
    const float most = std::max(1.0f, std::floor((available / 3 - padding) / line_height));
    return std::min(lines, most) * line_height + padding;
}

void PromptView::draw(float height, float cell, bool focused) {
    ImVec2 corner = ImGui::GetCursorScreenPos();
    ImVec2 size(ImGui::GetContentRegionAvail().x, height);
    ImGuiStyle& style = ImGui::GetStyle();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    float line_height = ImGui::GetTextLineHeightWithSpacing();
    ImVec2 end(corner.x + size.x, corner.y + size.y);
    list.AddRectFilled(corner, end, palette::well, style.FrameRounding);
    list.AddRect(corner, end, focused ? with_alpha(palette::accent, 0.55f) : palette::line,
                 style.FrameRounding);

    ImGui::InvisibleButton("prompt", ImVec2(std::max(1.0f, size.x), std::max(1.0f, size.y)));
    rect_ = item_rect();
    follow_caret(size, line_height, cell);
    ImVec2 origin(corner.x + style.FramePadding.x - scroll_.x,
                  corner.y + style.FramePadding.y + 1 - scroll_.y);
    ImVec2 text_origin(origin.x + prompt_gutter * cell, origin.y);
    mouse(text_origin, line_height, cell);
    list.PushClipRect(corner, end, true);
    if (prompt_.search()) {
        std::string head = "search: " + *prompt_.search() + "  ";
        ImU32 color = prompt_.search_failed() ? palette::error : palette::note;
        draw_text(list, text_origin, color, head);
        text_origin.x += columns(head) * cell;
    }
    const auto first =
        static_cast<std::size_t>(std::max(0.0f, (corner.y - origin.y) / line_height));
    const auto last =
        static_cast<std::size_t>(std::max(0.0f, (end.y - origin.y) / line_height)) + 1;
    for (std::size_t i = first; i < std::min(last, prompt_.edit().line_count()); ++i)
        draw_text(list, ImVec2(origin.x, origin.y + static_cast<float>(i) * line_height),
                  i == 0 ? palette::accent : palette::faint, i == 0 ? "›" : "·");
    draw_lines(text_origin, line_height, cell);
    draw_caret(text_origin, line_height, cell, focused);
    list.PopClipRect();

    signature_anchor_ = ImVec2(text_origin.x, end.y + gap);
    if (prompt_.menu().open()) {
        const TextEdit& edit = prompt_.edit();
        std::size_t from = prompt_.menu().selection().replace_from;
        menu_anchor_ =
            ImVec2(text_origin.x + static_cast<float>(edit.column_of(from)) * cell, end.y + gap);
    }
}

void PromptView::follow_caret(ImVec2 size, float line_height, float cell) {
    const TextEdit& edit = prompt_.edit();
    float x = (prompt_gutter + static_cast<float>(edit.column_of(edit.cursor()))) * cell;
    float y = static_cast<float>(edit.line_of(edit.cursor())) * line_height;
    float room_x = size.x - 4 * cell;
    float room_y = size.y - line_height - 2 * ImGui::GetStyle().FramePadding.y;
    scroll_.x = std::clamp(scroll_.x, std::max(0.0f, x - room_x), std::max(0.0f, x - 8 * cell));
    if (x <= room_x) scroll_.x = 0;
    scroll_.y = std::clamp(scroll_.y, std::max(0.0f, y - room_y), std::max(0.0f, y));
}

void PromptView::mouse(ImVec2 origin, float line_height, float cell) {
    ImVec2 at = ImGui::GetIO().MousePos;
    TextEdit& edit = prompt_.edit();
    auto row = static_cast<std::size_t>(std::max(0.0f, (at.y - origin.y) / line_height));
    auto column = static_cast<std::size_t>(std::max(0.0f, (at.x - origin.x) / cell + 0.5f));
    clicked_ = ImGui::IsItemClicked(0);
    if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
    if (clicked_) {
        edit.place(edit.offset_at(row, column), ImGui::GetIO().KeyShift);
        prompt_.close_menu();
        dragging_ = true;
    } else if (dragging_ && ImGui::IsMouseDown(0)) {
        edit.place(edit.offset_at(row, column), true);
    }
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) {
        edit.select_word(edit.cursor());
        dragging_ = false;
    }
    if (!ImGui::IsMouseDown(0)) dragging_ = false;
}

/// Only what is visible is drawn: a pasted text may have many lines, and long ones.
void PromptView::draw_lines(ImVec2 origin, float line_height, float cell) {
    const ImDrawList& list = *ImGui::GetWindowDrawList();
    const float top = list.GetClipRectMin().y, bottom = list.GetClipRectMax().y;
    const std::string_view text = prompt_.edit().text();
    float y = origin.y;
    for (std::size_t begin = 0; begin <= text.size() && y < bottom; y += line_height) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        if (y + line_height > top)
            draw_line(text.substr(begin, end - begin), begin, ImVec2(origin.x, y), line_height,
                      cell);
        begin = end + 1;
    }
}

/// `base`: where the line begins in the text.
void PromptView::draw_line(std::string_view line, std::size_t base, ImVec2 at, float line_height,
                           float cell) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float left = list.GetClipRectMin().x, right = list.GetClipRectMax().x;
    const auto [from, to] = prompt_.edit().selection();
    const std::size_t begin = std::clamp(from, base, base + line.size()) - base;
    const std::size_t end = std::clamp(to, base, base + line.size()) - base;
    if (from < to && from <= base + line.size() && to >= base)
        list.AddRectFilled(ImVec2(at.x + columns(line.substr(0, begin)) * cell, at.y),
                           ImVec2(at.x + columns(line.substr(0, end)) * cell, at.y + line_height),
                           palette::selection);
    float x = at.x;
    std::size_t done = 0;
    const auto pass = [&](std::size_t until) {
        x += columns(line.substr(done, until - done)) * cell;
        done = until;
    };
    for (const Span& span : highlight_command(line)) {
        pass(span.begin);
        if (x > right) break;
        const float start = x;
        pass(span.end);
        if (x >= left)
            draw_text(list, ImVec2(start, at.y), token_color(span.token),
                      line.substr(span.begin, span.end - span.begin));
    }
}

void PromptView::draw_caret(ImVec2 origin, float line_height, float cell, bool focused) {
    const TextEdit& edit = prompt_.edit();
    if (blink_cursor_ != edit.cursor()) {
        blink_cursor_ = edit.cursor();
        blink_from_ = ImGui::GetTime();
    }
    ImVec2 at(origin.x + static_cast<float>(edit.column_of(edit.cursor())) * cell,
              origin.y + static_cast<float>(edit.line_of(edit.cursor())) * line_height);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_text(list, at, palette::faint, prompt_.suggestion());
    bool lit = std::fmod(ImGui::GetTime() - blink_from_, 2 * blink_seconds) < blink_seconds;
    if (focused && lit)
        list.AddRectFilled(ImVec2(std::floor(at.x), at.y),
                           ImVec2(std::floor(at.x) + 2, at.y + ImGui::GetTextLineHeight()),
                           palette::accent);
}

// --- Candidates

PromptView::MenuLayout PromptView::menu_layout(float cell) const {
    const CompletionMenu& menu = prompt_.menu();
    float label_width = 0, detail_width = 0;
    for (const auto& candidate : menu.candidates()) {
        label_width = std::max(label_width, columns(candidate.completion.label) * cell);
        detail_width = std::max(detail_width, columns(facts(candidate.completion)) * cell);
    }
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const ImGuiStyle& style = ImGui::GetStyle();
    label_width = std::min(label_width, 32 * cell);
    const bool may_scroll = menu.candidates().size() > menu_rows;
    float width = label_width + std::min(detail_width, 60 * cell) + 5 * cell +
                  2 * style.WindowPadding.x + (may_scroll ? style.ScrollbarSize : 0);
    width = std::min(std::max(width, 36 * cell), screen.x - 2 * edge);
    const float inner = width - 2 * style.WindowPadding.x;
    const float row_height = ImGui::GetTextLineHeight() + row_padding;  // without spacing
    float facts_width = inner - label_width - 4 * cell - (may_scroll ? style.ScrollbarSize : 0);
    Description description = describe(inner - 2 * cell, facts_width);

    // Below the prompt or above it, with as many rows as there is room for.
    const float wanted = static_cast<float>(std::min(menu_rows, menu.candidates().size()));
    const float frame = 2 * style.WindowPadding.y;
    const float below = screen.y - edge - menu_anchor_.y, above = rect_.low.y - gap - edge;
    const bool upward = frame + wanted * row_height + description.height > below && above > below;
    const float room = (upward ? above : below) - frame;
    constexpr float least_rows = 3;
    if (room - description.height < std::min(wanted, least_rows) * row_height) description = {};
    const float rows =
        std::clamp(std::floor((room - description.height) / row_height), 1.0f, wanted);
    const float height = frame + rows * row_height + description.height;
    const bool scrolls = static_cast<float>(menu.candidates().size()) > rows;

    const ImVec2 at(std::clamp(menu_anchor_.x - style.WindowPadding.x - cell, edge,
                               std::max(edge, screen.x - width - edge)),
                    upward ? rect_.low.y - gap - height : menu_anchor_.y);
    return {at, width, height, label_width, row_height, rows, scrolls, std::move(description)};
}

void PromptView::draw_menu(float cell, ImFont* bold) {
    menu_rect_ = signature_rect_ = {};
    const CompletionMenu& menu = prompt_.menu();
    if (!menu.open()) {
        shown_selection_ = 0;
        draw_signature();
        return;
    }
    const auto [at, width, height, label_width, row_height, rows, scrolls, description] =
        menu_layout(cell);
    const ImGuiStyle& style = ImGui::GetStyle();
    const float inner = width - 2 * style.WindowPadding.x;
    ImGui::SetNextWindowPos(at);
    ImGui::SetNextWindowSize(ImVec2(width, height));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, palette::popup);
    ImGui::Begin("##candidates", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoSavedSettings);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(style.ItemSpacing.x, 0));
    ImGui::BeginChild("rows", ImVec2(inner, rows * row_height));
    if (shown_selection_ != menu.selected() || shown_rows_ != rows) {
        auto row = static_cast<float>(menu.selected());
        float view = ImGui::GetScrollY();
        ImGui::SetScrollY(std::clamp(view, (row + 1 - rows) * row_height, row * row_height));
        shown_selection_ = menu.selected();
        shown_rows_ = rows;
    }
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(menu.candidates().size()), row_height);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd && menu.open(); ++i)
            draw_candidate(static_cast<std::size_t>(i), inner - (scrolls ? style.ScrollbarSize : 0),
                           label_width, cell);
    ImGui::EndChild();
    ImGui::PopStyleVar();
    if (menu.open() && description.height > 0) draw_description(description, cell, bold);
    menu_rect_ = window_rect();
    ImGui::End();
    ImGui::PopStyleColor();
}

/// The signature of the call that is being typed, with the present parameter marked. A long one
/// has several lines in a narrow window.
void PromptView::draw_signature() {
    const auto shown = prompt_.search() ? std::nullopt : prompt_.signature();
    if (!shown) return;
    const ImGuiStyle& style = ImGui::GetStyle();
    const float widest = ImGui::GetIO().DisplaySize.x - 16;
    const float room = widest - 2 * style.WindowPadding.x;
    const std::string text = wrapped(shown->text, room);
    std::vector<ParameterRange> lines;
    float width = 0;
    for (std::size_t begin = 0; begin <= text.size(); begin = lines.back().end + 1) {
        lines.push_back({begin, std::min(text.find('\n', begin), text.size())});
        const std::string_view line =
            std::string_view(text).substr(begin, lines.back().end - begin);
        width = std::max(width, text_width(line));
    }
    const std::string doc =
        wrapped(shown->doc, std::min(room, std::max(width, 40 * text_width("M"))));
    width = std::min(
        std::max(width, ImGui::CalcTextSize(doc.c_str()).x) + 2 * style.WindowPadding.x, widest);
    ImGui::SetNextWindowPos(
        ImVec2(std::clamp(signature_anchor_.x, 8.0f, std::max(8.0f, widest + 8 - width)),
               signature_anchor_.y));
    ImGui::SetNextWindowSize(ImVec2(width, 0));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, palette::popup);
    ImGui::Begin("##signature", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_AlwaysAutoResize);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float high = ImGui::GetTextLineHeight();
    ImGui::Dummy(
        ImVec2(width - 2 * style.WindowPadding.x, high * static_cast<float>(lines.size())));
    const ParameterRange now = shown->parameter;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    float y = at.y;
    for (const ParameterRange& line : lines) {
        const std::size_t marked = std::clamp(now.begin, line.begin, line.end),
                          after = std::clamp(now.end, marked, line.end);
        float x = at.x;
        const auto draw = [&](std::size_t begin, std::size_t end, ImU32 color) {
            x += draw_text(list, ImVec2(x, y), color,
                           std::string_view(text).substr(begin, end - begin));
        };
        draw(line.begin, marked, palette::dim);
        draw(marked, after, palette::accent);
        draw(after, line.end, palette::dim);
        y += high;
    }
    if (!doc.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, palette::faint);
        text_line(doc);
        ImGui::PopStyleColor();
    }
    signature_rect_ = window_rect();
    ImGui::End();
    ImGui::PopStyleColor();
}

void PromptView::draw_candidate(std::size_t index, float width, float label_width, float cell) {
    const auto& candidate = prompt_.menu().candidates()[index];
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImVec2 at = ImGui::GetCursorScreenPos();
    float height = ImGui::GetTextLineHeightWithSpacing() + row_padding;
    ImGui::PushID(static_cast<int>(index));
    bool clicked = ImGui::InvisibleButton("candidate", ImVec2(std::max(1.0f, width), height));
    bool hovered = ImGui::IsItemHovered();
    ImGui::PopID();
    bool chosen = index == prompt_.menu().selected();
    ImVec2 end(at.x + width, at.y + height);
    float rounding = ImGui::GetStyle().FrameRounding;
    if (chosen || hovered)
        list.AddRectFilled(at, end, chosen ? palette::chosen : palette::hover, rounding);
    if (chosen) list.AddRectFilled(at, ImVec2(at.x + 3, end.y), palette::accent, rounding);
    ImVec2 text(at.x + cell, at.y + (height - ImGui::GetTextLineHeight()) / 2);
    const std::string& label = candidate.completion.label;
    draw_text_fit(list, text, palette::text, label, label_width);
    // Draws the matched letters again in the accent color.
    for (std::size_t byte : candidate.matched) {
        std::string_view before = std::string_view(label).substr(0, byte);
        float x = columns(before) * cell;
        if (x + cell > label_width + 1) break;
        draw_text(list, ImVec2(text.x + x, text.y), palette::accent,
                  std::string_view(label).substr(byte, next_code_point(label, byte) - byte));
    }
    const float used = label_width + 3 * cell, room = width - used - cell;
    const std::string shown = facts(candidate.completion);
    draw_text_fit(list, ImVec2(at.x + used, text.y), palette::dim, shown, room);
    // The whole numbers, and what is cut.
    const bool label_fits = columns(label) * cell <= label_width;
    if (hovered &&
        (shown != candidate.completion.detail || text_width(shown) > room || !label_fits))
        show_tip((label_fits ? "" : label + "\n") + candidate.completion.detail);
    if (clicked) prompt_.accept_candidate(index);
}

/// What is said of the chosen candidate below the list. `width`: of its text in pixels;
/// `facts_width`: the room for its facts in the list, where they are said if they fit.
PromptView::Description PromptView::describe(float width, float facts_width) const {
    const script::Completion& chosen = prompt_.menu().selection();
    Description found{.facts = {}, .doc = wrapped(chosen.doc, width)};
    if (text_width(facts(chosen)) > facts_width) found.facts = wrapped(facts(chosen), width);
    if (found.facts.empty() && found.doc.empty()) return found;
    const float spacing = ImGui::GetStyle().ItemSpacing.y;
    const auto height = [&](const std::string& text) {
        return text.empty()
                   ? 0
                   : ImGui::CalcTextSize(text.data(), text.data() + text.size()).y + spacing;
    };
    found.height = 2 * spacing + 1 + ImGui::GetTextLineHeight() + spacing + height(found.facts) +
                   height(found.doc);
    return found;
}

void PromptView::draw_description(const Description& description, float cell, ImFont* bold) {
    ImGui::Spacing();
    ImGui::Separator();
    ImGui::Indent(cell);
    compat::push_font(bold);
    text_line(prompt_.menu().selection().label);
    ImGui::PopFont();
    ImGui::PushStyleColor(ImGuiCol_Text, palette::note);
    if (!description.facts.empty()) text_line(description.facts);
    ImGui::PopStyleColor();
    ImGui::PushStyleColor(ImGuiCol_Text, palette::dim);
    if (!description.doc.empty()) text_line(description.doc);
    ImGui::PopStyleColor();
    ImGui::Unindent(cell);
}

}  // namespace fettle::console
