#include <look/theme.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <fettle/property/text_hash.h>

#include <look/extra_glyphs.h>
#include <look/imgui_compat.h>
#include <text/utf8.h>

namespace fettle::console {

namespace {

void apply_sizes(ImGuiStyle& style, float em) {
    auto px = [&](float ems) { return std::round(ems * em); };
    style.WindowPadding = ImVec2(px(0.6f), px(0.5f));
    style.FramePadding = ImVec2(px(0.4f), px(0.18f));
    style.ItemSpacing = ImVec2(px(0.4f), px(0.25f));
    style.ItemInnerSpacing = ImVec2(px(0.3f), px(0.25f));
    style.CellPadding = ImVec2(px(0.3f), px(0.12f));
    style.IndentSpacing = px(0.9f);
    style.ScrollbarSize = px(0.7f);
    style.GrabMinSize = px(0.7f);
    style.WindowRounding = px(0.4f);
    style.ChildRounding = px(0.25f);
    style.FrameRounding = px(0.25f);
    style.PopupRounding = px(0.35f);
    style.ScrollbarRounding = px(0.35f);
    style.GrabRounding = px(0.2f);
    style.TabRounding = px(0.25f);
    style.WindowBorderSize = 1;
    style.ChildBorderSize = 0;
    style.PopupBorderSize = 1;
    style.FrameBorderSize = 0;
    style.WindowMinSize = ImVec2(8, 8);
    style.ColorButtonPosition = ImGuiDir_Left;
    style.DisabledAlpha = disabled_alpha;
}

void apply_colors(ImGuiStyle& style) {
    auto set = [&](int index, ImU32 color) { style.Colors[index] = vector(color); };
    set(ImGuiCol_Text, palette::text);
    set(ImGuiCol_TextDisabled, palette::dim);
    set(ImGuiCol_WindowBg, palette::panel);
    set(ImGuiCol_ChildBg, palette::clear);
    set(ImGuiCol_PopupBg, palette::popup);
    set(ImGuiCol_Border, palette::line);
    set(ImGuiCol_FrameBg, palette::raised);
    set(ImGuiCol_FrameBgHovered, palette::hover);
    set(ImGuiCol_FrameBgActive, palette::hover);
    set(ImGuiCol_TitleBg, palette::panel);
    set(ImGuiCol_TitleBgActive, palette::panel);
    set(ImGuiCol_ScrollbarBg, palette::clear);
    set(ImGuiCol_ScrollbarGrab, palette::rgb(0x39414f));
    set(ImGuiCol_ScrollbarGrabHovered, palette::rgb(0x4b5566));
    set(ImGuiCol_ScrollbarGrabActive, palette::accent);
    set(ImGuiCol_CheckMark, palette::accent);
    set(ImGuiCol_SliderGrab, palette::accent);
    set(ImGuiCol_SliderGrabActive, palette::accent);
    set(ImGuiCol_Button, palette::raised);
    set(ImGuiCol_ButtonHovered, palette::hover);
    set(ImGuiCol_ButtonActive, palette::rgb(0x3a4352));
    set(ImGuiCol_Header, palette::raised);
    set(ImGuiCol_HeaderHovered, palette::hover);
    set(ImGuiCol_HeaderActive, palette::hover);
    set(ImGuiCol_Separator, palette::line);
    set(ImGuiCol_SeparatorHovered, palette::accent);
    set(ImGuiCol_SeparatorActive, palette::accent);
    set(ImGuiCol_ResizeGrip, palette::clear);
    set(ImGuiCol_TextSelectedBg, palette::selection);
    set(ImGuiCol_TableBorderLight, palette::line);
    set(compat::keyboard_outline, palette::accent);
}

}  // namespace

ImVec4 vector(ImU32 color) {
    return ImGui::ColorConvertU32ToFloat4(color);
}

ImU32 with_alpha(ImU32 color, float alpha) {
    auto a = static_cast<ImU32>(std::lround(static_cast<float>(color >> IM_COL32_A_SHIFT) * alpha));
    return (color & ~IM_COL32_A_MASK) | a << IM_COL32_A_SHIFT;
}

void apply_theme(float font_size) {
    ImGuiStyle style;
    apply_sizes(style, font_size);
    apply_colors(style);
    ImGui::GetStyle() = style;
}

ImU32 token_color(Token token) {
    switch (token) {
        case Token::keyword:
            return palette::accent;
        case Token::constant:
        case Token::number:
            return palette::number;
        case Token::string:
            return palette::string;
        case Token::comment:
            return palette::faint;
        case Token::path:
            return palette::path;
        case Token::arrow:
            return palette::accent;
        case Token::problem:
            return palette::error;
        case Token::symbol:
            return palette::dim;
        case Token::plain:
            break;
    }
    return palette::text;
}

ImU32 line_color(LineKind kind) {
    switch (kind) {
        case LineKind::note:
            return palette::note;
        case LineKind::error:
        case LineKind::caret:
            return palette::error;
        case LineKind::trace:
            return palette::dim;
        case LineKind::fold:
            return palette::path;
        default:
            return palette::text;
    }
}

// Hues that differ by the golden angle are far apart for any number of classes. The hash selects
// the index.
ImU32 class_color(std::string_view class_name) {
    std::uint32_t hash = property::text_hash(class_name);
    hash ^= hash >> 15;
    float hue = std::fmod(static_cast<float>(hash % 997) * 0.61803399f, 1.0f);
    float r = 0, g = 0, b = 0;
    ImGui::ColorConvertHSVtoRGB(hue, 0.38f, 0.95f, r, g, b);
    return ImGui::ColorConvertFloat4ToU32(ImVec4(r, g, b, 1));
}

Fonts fonts() {
    const auto& all = ImGui::GetIO().Fonts->Fonts;
    const auto nth = [&](int n) { return all[std::min(n, all.Size - 1)]; };
    return {nth(0), nth(1), nth(2)};
}

FontScope::FontScope(ImFont* font) {
    compat::push_font(font);
}
FontScope::~FontScope() {
    ImGui::PopFont();
}

ImU32 series_color(std::size_t index) {
    constexpr std::array<ImU32, 6> colors = {palette::accent, palette::path,  palette::string,
                                             palette::number, palette::error, palette::note};
    return colors[index % colors.size()];
}

std::string widget_text(std::string_view text) {
    return ExtraGlyphs::current().shown(text);
}

void text_line(std::string_view text) {
    const std::string line = widget_text(text);
    ImGui::TextUnformatted(line.data(), line.data() + line.size());
}

float text_width(std::string_view whole) {
    std::string storage;
    const std::string_view text = ExtraGlyphs::current().shown(whole, storage);
    return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
}

std::string tip_lines(std::string_view text) {
    constexpr float widest = 36;  // ems
    const ImGuiStyle& style = ImGui::GetStyle();
    const float room = ImGui::GetIO().DisplaySize.x - 2 * style.WindowPadding.x - 8;
    return wrapped(text, std::min(widest * ImGui::GetFontSize(), room));
}

void show_tip(std::string_view text) {
    ImGui::SetTooltip("%s", widget_text(tip_lines(text)).c_str());
}

void show_tip_beside(std::string_view text) {
    constexpr float gap = 4;
    const ImVec2 padding = ImGui::GetStyle().WindowPadding, screen = ImGui::GetIO().DisplaySize;
    const ImVec2 lines = ImGui::CalcTextSize(tip_lines(text).c_str());
    const float wide = lines.x + 2 * padding.x, tall = lines.y + 2 * padding.y;
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    const float y = std::min(ImGui::GetItemRectMin().y, screen.y - gap - tall);
    const float right = low.x + size.x + gap;
    if (right + wide <= screen.x)
        ImGui::SetNextWindowPos(ImVec2(right, y));
    else if (low.x - gap >= wide)
        ImGui::SetNextWindowPos(ImVec2(low.x - gap - wide, y));
    show_tip(text);
}

float button_height() {
    constexpr float least = 16;
    return std::max(least, std::ceil(ImGui::GetTextLineHeight()) + 2);
}

bool low_button(const char* label) {
    const float padding = (button_height() - ImGui::GetTextLineHeight()) / 2;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                        ImVec2(ImGui::GetStyle().FramePadding.x, padding));
    const bool pressed = ImGui::Button(label);
    ImGui::PopStyleVar();
    return pressed;
}

bool small_button(const char* id, const char* sign, const char* tip) {
    float side = ImGui::GetFrameHeight();
    ImVec2 at = ImGui::GetCursorScreenPos();
    bool pressed = ImGui::InvisibleButton(id, ImVec2(side, side));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    bool hovered = ImGui::IsItemHovered();
    if (hovered) {
        list.AddRectFilled(at, ImVec2(at.x + side, at.y + side), palette::hover,
                           ImGui::GetStyle().FrameRounding);
        show_tip(tip);
    }
    ImVec2 middle(at.x + (side - text_width(sign)) / 2,
                  at.y + (side - ImGui::GetTextLineHeight()) / 2);
    draw_text(list, middle, hovered ? palette::accent : palette::dim, sign);
    return pressed;
}

std::string wrapped(std::string_view text, float width) {
    std::string out;
    std::size_t line = 0;  // its begin in `out`
    while (!text.empty()) {
        const std::size_t blank = std::min(text.find_first_of(" \n", 1), text.size());
        const std::string_view word = text.substr(0, blank);  // with the blank before it
        if (word[0] == '\n') line = out.size() + 1;
        const bool breaks =
            word[0] == ' ' && out.size() > line &&
            text_width(std::string_view(out).substr(line)) + text_width(word) > width;
        out += breaks ? "\n" + std::string(word.substr(1)) : std::string(word);
        if (breaks) line = out.size() - (word.size() - 1);
        text.remove_prefix(blank);
    }
    return out;
}

float draw_text(ImDrawList& list, ImVec2 at, ImU32 color, std::string_view whole) {
    if (whole.empty()) return 0;
    std::string storage;
    const std::string_view text = ExtraGlyphs::current().shown(whole, storage);
    list.AddText(at, color, text.data(), text.data() + text.size());
    return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
}

namespace {

/// A name may contain line ends; they are shown as a sign, since what is below belongs to others.
std::string one_line(std::string_view text) {
    std::string line;
    for (const char c : text) c == '\n' ? line += "↵" : line += c;
    return line;
}

}  // namespace

void draw_path_fit(ImDrawList& list, ImVec2 at, ImU32 color, std::string_view whole, float width) {
    const std::string line = one_line(whole);
    std::string_view path = line;
    if (text_width(path) > width) {
        const float dots = text_width("…");
        if (dots <= width) at.x += draw_text(list, at, color, "…");
        while (!path.empty() && text_width(path) > width - dots)
            path.remove_prefix(next_code_point(path, 0));
    }
    draw_text(list, at, color, path);
}

std::string shortened(std::string_view whole, float width) {
    std::string text = one_line(whole);
    if (text_width(text) <= width) return text;
    const float room = width - text_width("…");
    std::size_t end = text.size();
    while (end > 0 && text_width(std::string_view(text).substr(0, end)) > room)
        end = previous_code_point(text, end);
    return text.substr(0, end) + (room >= 0 ? "…" : "");
}

void draw_text_fit(ImDrawList& list, ImVec2 at, ImU32 color, std::string_view text, float width) {
    draw_text(list, at, color, shortened(text, width));
}

}  // namespace fettle::console
