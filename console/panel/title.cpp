// The title of the panel: what is selected, the field that filters the log, and buttons.

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include <look/fields.h>
#include <look/imgui_compat.h>
#include <look/theme.h>
#include <panel/state.h>

namespace fettle::console {

/// The field that filters the log, in the title.
void Console::State::draw_filter(float& right, float em) {
    const float wide = 9 * em;
    const ImVec2 start = ImGui::GetCursorScreenPos();
    right -= wide;
    ImGui::SetCursorScreenPos(ImVec2(right, start.y));
    ImGui::SetNextItemWidth(wide);
    std::string text = settings.text("filter");
    const float padding = (button_height() - ImGui::GetTextLineHeight()) / 2;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                        ImVec2(ImGui::GetStyle().FramePadding.x, padding));
    if (input_line("##filter", "filter the log", text, 0))
        settings.set("filter", property::Value(text));
    ImGui::PopStyleVar();
    screen.filter_rect = item_rect();
    right -= ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::SetCursorScreenPos(start);
}

bool Console::State::title_button(const char* label, bool lit, float& right) {
    const FontScope font(fonts().sans);
    float pad = ImGui::GetStyle().FramePadding.x;
    const std::string_view shown =
        std::string_view(label).substr(0, std::string_view(label).find("##"));
    float button_width = text_width(shown) + 2 * pad;
    const float high = button_height();
    ImVec2 start = ImGui::GetCursorScreenPos();
    if (right - button_width < start.x) return false;  // there is no room: it is left out
    right -= button_width;
    ImGui::SetCursorScreenPos(ImVec2(right, start.y));
    ImVec2 at = ImGui::GetCursorScreenPos();
    bool pressed = ImGui::InvisibleButton(label, ImVec2(button_width, high));
    bool hovered = ImGui::IsItemHovered();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImVec2 end(at.x + button_width, at.y + high);
    float rounding = ImGui::GetStyle().FrameRounding;
    list.AddRectFilled(at, end, hovered ? palette::hover : palette::raised, rounding);
    const float above = (high - ImGui::GetTextLineHeight()) / 2;
    draw_text(list, ImVec2(at.x + pad, at.y + above), lit ? palette::accent : palette::dim, shown);
    right -= ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::SetCursorScreenPos(start);
    return pressed;
}

void Console::State::draw_inspector_button(float& right) {
    const bool shown = settings.flag("inspector");
    const float right_of_button = right;
    screen.inspector_left_out = shown && status.drawn && screen.inspector_rect.empty();
    // Where it can be shown in place of the log, the button changes between the two.
    const bool in_turn = inspector_fits_in_panel();
    if (title_button("inspector", shown && !screen.inspector_left_out, right)) {
        if (!in_turn) settings.set("inspector", property::Value(!shown));
        status.inspector_over_log = !shown || !status.inspector_over_log;
    }
    if (!screen.inspector_left_out || in_turn || right >= right_of_button) return;
    // It is on, and struck out.
    const Rect button = item_rect();
    const float middle = std::round(button.middle().y);
    ImGui::GetWindowDrawList()->AddLine(ImVec2(button.low.x + 2, middle),
                                        ImVec2(button.high.x - 2, middle), palette::accent, 1.5f);
    if (ImGui::IsItemHovered())
        show_tip("the inspector has no room in this window: make it larger, or close a view");
}

void Console::State::draw_title_buttons(float& right) {
    draw_inspector_button(right);
    const bool pauses = settings.flag("pauses");
    if (title_button("pause", pauses, right)) settings.set("pauses", property::Value(!pauses));
    if (views.overlay_bar.available()) {
        const int lit = views.overlay_bar.lit();
        const std::string label =
            lit == 0 ? "overlays###overlays" : "overlays " + std::to_string(lit) + "###overlays";
        const bool listed = settings.flag("overlays");
        if (title_button(label.c_str(), listed, right))
            settings.set("overlays", property::Value(!listed));
    }
    if (views.tweak_list.available()) {
        const bool listed = settings.flag("tweaks");
        const std::size_t open = views.tweak_list.open_count();
        const std::string label =
            open == 0 ? "tweaks###tweaks" : "tweaks " + std::to_string(open) + "###tweaks";
        if (title_button(label.c_str(), listed && !inspector_is_in_panel(), right)) {
            settings.set("tweaks", property::Value(!listed || inspector_is_in_panel()));
            status.inspector_over_log = false;
        }
    }
}

void Console::State::draw_selected_path(ImVec2& at, float right, float cell) {
    if (!tree.alive(inspector.selected())) return;
    // In a narrow window the inspector below says it.
    constexpr float least_cells = 12;
    constexpr std::string_view it = "it = ";
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::string path = tree.path(inspector.selected());
    const float before = text_width(it), room = right - at.x - cell;
    const float wide = std::min(before + text_width(path), room);
    if (wide >= room && room < least_cells * cell) return;
    draw_text(list, at, palette::accent, it);
    draw_path_fit(list, ImVec2(at.x + before, at.y), palette::accent, path, wide - before);
    at.x += wide + 3 * cell;
}

void Console::State::draw_title(float cell) {
    const float content = ImGui::GetContentRegionAvail().x;
    ImVec2 at = ImGui::GetCursorScreenPos();
    float right = at.x + content;
    at.y += 1;
    draw_title_buttons(right);
    const float em = ImGui::GetFontSize();
    if (content > 46 * em) draw_filter(right, em);

    ImDrawList& list = *ImGui::GetWindowDrawList();
    compat::push_font(ui.bold());
    if (at.x + text_width("console") < right) at.x += draw_text(list, at, palette::text, "console");
    ImGui::PopFont();
    at.x += 2 * cell;
    draw_selected_path(at, right, cell);
    constexpr std::string_view hints = "Tab complete   ↑ history   Ctrl-R search   Esc close";
    const FontScope font(fonts().sans);
    const float hint_width = text_width(hints);
    if (at.x + hint_width + 2 * cell < right)
        draw_text(list, ImVec2(right - hint_width - cell, at.y), palette::faint, hints);
    ImGui::Dummy(ImVec2(content, button_height() + 2));
    const ImVec2 line = ImGui::GetCursorScreenPos();
    list.AddLine(ImVec2(screen.panel_rect.low.x, line.y - 2),
                 ImVec2(screen.panel_rect.high.x, line.y - 2), palette::line);
    ImGui::Dummy(ImVec2(1, 1));
}

}  // namespace fettle::console
