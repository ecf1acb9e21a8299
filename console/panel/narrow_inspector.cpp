// The inspector in a window that has no room for it beside the panel: below the panel, and in a low
// window in place of the log.

#include <algorithm>
#include <utility>

#include <panel/sizes.h>
#include <panel/state.h>

namespace fettle::console {

namespace {

constexpr float least_in_panel = 12;  // the height of the panel with the inspector in it, in ems

}  // namespace

/// The lowest place for the inspector below the panel: it covers no error, which other layers show.
float Console::State::free_for_inspector() const {
    const float low = free_above() - legend_room();
    if (options.game_covered && options.game_covered()) return 0;
    if (!options.free_of_others) return low;
    const app::ClipRectangle free = options.free_of_others({0, 0, screen.width, screen.height});
    return std::min(low, free.top + free.height - margin);
}

/// Draws the inspector in the room between the panel and the views at the lower edge, if there is
/// enough. If nothing is selected, the game is visible below the tree, so that it can be clicked.
void Console::State::draw_inspector_below() {
    if (inspector_is_in_panel()) return;
    const float least = least_inspector * ImGui::GetFontSize();
    const Rect& runs = views.compare_view.rect();
    const float top = (runs.empty() ? screen.panel_rect : runs).high.y + margin;
    const float room = free_for_inspector() - top;
    screen.inspector_has_no_room = settings.flag("inspector") && room < least;
    if (!settings.flag("inspector") || room < least) {
        screen.inspector_rect = {};
        return inspector.editor().end_drag();
    }
    ImGui::SetNextWindowPos(ImVec2(margin, top));
    const bool whole = tree.alive(inspector.selected());
    const float tall = whole ? room : inspector.height_without_selection(room);
    ImGui::SetNextWindowSize(ImVec2(screen.width - 2 * margin, tall));
    ImGui::SetNextWindowBgAlpha(settings.number("opacity"));
    ImGui::Begin("##inspector", nullptr, panel_flags);
    screen.inspector_rect = window_rect();
    inspector.draw(ui.bold(), room - tall);
    ImGui::End();
}

/// After a change of the size of the window or of the text, one frame shows whether the inspector
/// has room of its own.
void Console::State::note_size_of_window() {
    const ImVec2 ems(screen.width / ImGui::GetFontSize(), screen.height / ImGui::GetFontSize());
    if (std::exchange(screen.ems.x, ems.x) != ems.x || std::exchange(screen.ems.y, ems.y) != ems.y)
        screen.inspector_has_no_room = false;
}

/// Whether the panel could show the inspector in place of the log, since there is no other room.
bool Console::State::inspector_fits_in_panel() {
    return settings.flag("inspector") && screen.inspector_has_no_room && !inspector_is_beside() &&
           !comparison.shown() && !(options.game_covered && options.game_covered()) &&
           height_with_inspector() >= least_in_panel * ImGui::GetFontSize();
}

bool Console::State::inspector_is_in_panel() {
    return status.inspector_over_log && inspector_fits_in_panel();
}

/// The panel then leaves room for the time bar only, as if it were another tab.
float Console::State::height_with_inspector() {
    const bool bar = settings.flag("time_bar") && views.time_bar.available();
    return std::max(1.0f,
                    screen.height - 2 * margin - (bar ? views.time_bar.height() + margin : 0));
}

void Console::State::draw_inspector_in_panel(float height) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::BeginChild("inspector", ImVec2(0, std::max(1.0f, height)), 0,
                      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    inspector.draw_in_turn(ui.bold());
    ImGui::EndChild();
    screen.inspector_rect = {low, ImGui::GetItemRectMax()};
}

}  // namespace fettle::console
