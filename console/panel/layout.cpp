// Layout of the console: the panel at the top, the inspector on the right, the list of candidates
// above both.

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include <fettle/property/exception_text.h>

#include <in_game/outline.h>
#include <look/fields.h>
#include <look/imgui_compat.h>
#include <look/theme.h>
#include <panel/sizes.h>
#include <panel/state.h>

namespace fettle::console {

namespace {

constexpr float handle_size = 16;  // width of the edges for resizing, half of it outside, in pixels
// The least sizes of the windows, in ems.
constexpr float least_panel = 26, least_height = 8.5f;  // the panel: its width and height
constexpr float least_log = 6.5f;    // the panel without overlays: title, a line and prompt
constexpr float useful_log = 10.5f;  // with three lines more, which an answer mostly needs
constexpr float stacked_below = 44;  // the watch list and the plot, in narrower windows
constexpr float least_plot = 9, least_list = 4, least_frames = 7;
constexpr float low_plot = 4.1f, low_list = 2, low_frames = 5;  // in low windows; below that, none
constexpr float least_beside = 15;      // the inspector: its width beside the panel
constexpr float useful_inspector = 14;  // its height below the panel, with some properties
constexpr float least_legend = 5.3f;    // the legend of `view.show.blame`, with three rows
constexpr float compared_share = 0.4f;  // of the screen's height that other views leave two runs

/// A window without a picture over an edge, which can be dragged. Returns whether it is.
bool edge_is_dragged(const char* name, const Rect& place, ImGuiMouseCursor cursor) {
    ImGui::SetNextWindowPos(place.low);
    ImGui::SetNextWindowSize(ImVec2(place.high.x - place.low.x, place.high.y - place.low.y));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBackground |
                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar(3);
    ImGui::InvisibleButton("edge", ImVec2(std::max(1.0f, place.high.x - place.low.x),
                                          std::max(1.0f, place.high.y - place.low.y)));
    const bool active = ImGui::IsItemActive();
    if (active || ImGui::IsItemHovered()) ImGui::SetMouseCursor(cursor);
    ImGui::End();
    return active;
}

}  // namespace

void Console::State::frame(double seconds) {
    if (screen.building || !(screen.width > 0) || !(screen.height > 0)) return;  // also NaN
    screen.building = true;
    input.fed_button = input.fed_key = input.fed_text = input.fed_move = false;
    ui.begin_frame(screen.width, screen.height, seconds, text_size());
    float cell = ImGui::CalcTextSize("MMMMMMMM").x / 8;
    note_lost_undo();
    draw_part([&] { draw_in_game(); });
    draw_part([&] { draw_box(); });
    float right = 0;
    screen.height_edge = screen.width_edge = screen.plot_edge = {};
    note_size_of_window();
    if (inspector_is_beside()) {
        right = inspector_width() + margin;
        draw_part([&] { draw_inspector(screen.width - right, inspector_width()); });
    }
    draw_part([&] { draw_panel(screen.width - 2 * margin - right, panel_height(), cell); });
    // Beside two runs, the inspector ends where the panel ends: what is below has all of the width.
    if (comparison_height() > 0) right = 0;
    draw_part([&] { draw_time_bar(right); });
    draw_part([&] { draw_observed(right); });
    draw_part([&] { draw_frames(right); });
    draw_part([&] { draw_comparison(seconds); });
    if (!inspector_is_beside()) draw_part([&] { draw_inspector_below(); });
    draw_part([&] { views.prompt_view.draw_menu(cell, ui.bold()); });
    draw_part([&] { context_menu.draw(); });
    screen.popup_open =
        ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    ui.end_frame();
    ui.navigate_with_keys(screen.popup_open);
    status.drawn = true;
    screen.building = false;
}

/// In pixels. In a narrow window the factor grows the text only as far as there is room for the
/// buttons and for a command.
float Console::State::text_size() {
    constexpr float readable = 13;
    const float wanted = settings.number("font_size") * settings.number("scale");
    const float most =
        std::max({readable, settings.number("font_size"), screen.width / least_panel});
    return std::clamp(std::round(std::min(wanted, most)), 6.0f, 96.0f);
}

/// The visible part of the world; empty without a view.
property::Seen Console::State::seen() const {
    if (!options.to_world) return {};
    const property::Vec2 size(screen.width, screen.height);
    const property::Vec2 a = options.to_world(0, screen.height),
                         b = options.to_world(screen.width, 0);
    return {(a + b) / 2, a.min(b), a.max(b), size};
}

/// The instance whose row in the inspector, or whose path in the log, is under the mouse.
property::Handle Console::State::pointed() {
    if (settings.flag("inspector") && tree.alive(inspector.pointed())) return inspector.pointed();
    const std::string_view path = views.log_view.pointed_link();
    return !path.empty() && is_link(path) ? property::resolve(tree, path).instance
                                          : property::Handle();
}

void Console::State::draw_outlines() {
    constexpr std::size_t most = 300;  // more outlines could not be distinguished
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const std::vector<property::Handle>& others = inspector.selected_instances().others();
    const std::size_t shown = std::min(others.size(), most);
    std::vector<property::Handle> all(others.end() - static_cast<std::ptrdiff_t>(shown),
                                      others.end());
    all.push_back(inspector.selected());
    const property::Handle under = pointed();
    if (under && !inspector.selected_instances().contains(under)) all.push_back(under);
    console::draw_outlines(list, tree, all, options.to_pixels, seen(), ImGui::GetTime());
}

void Console::State::draw_box() {
    if (!input.box) return;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const ImVec2 low(std::min(input.box->from_x, input.box->to_x),
                     std::min(input.box->from_y, input.box->to_y));
    const ImVec2 high(std::max(input.box->from_x, input.box->to_x),
                      std::max(input.box->from_y, input.box->to_y));
    list.AddRectFilled(low, high, with_alpha(palette::accent, 0.12f));
    list.AddRect(low, high, palette::accent);
}

/// Functions of the host may throw. The other parts are still drawn, and the log shows the error
/// once, although it may occur in every frame.
void Console::State::draw_part(const std::function<void()>& part) {
    const compat::Recovery recovery;
    std::string problem;
    try {
        return part();
    } catch (...) {
        problem = property::exception_text();
    }
    recovery.recover();
    if (problem != screen.part_problem) log.error("console: " + problem);
    screen.part_problem = problem;
}

float Console::State::room_beside_panel() const {
    return screen.width - least_panel * ImGui::GetFontSize() - 3 * margin;
}

/// In a narrow window the inspector is below the panel, so that there is room for a command.
bool Console::State::inspector_is_beside() {
    return settings.flag("inspector") && room_beside_panel() >= least_beside * ImGui::GetFontSize();
}

/// In pixels of the screen: it grows with the text, as long as there is room for a command.
float Console::State::inspector_width() {
    return std::min({settings.number("inspector_width") * settings.number("scale"),
                     screen.width * 0.6f, room_beside_panel()});
}

/// The panel covers nothing that is below it, unless the window is lower than all of them: then
/// views at the lower edge get less room, or are left out. What is left out takes no room from the
/// panel.
float Console::State::panel_height() {
    if (inspector_is_in_panel()) return height_with_inspector();
    const float em = ImGui::GetFontSize();
    const float overlays = settings.flag("overlays") ? views.overlay_bar.height() : 0;
    const float whole = std::max(1.0f, screen.height - 2 * margin);
    const float least = std::min(whole, least_log * em + overlays);
    const float useful = std::min(whole, useful_log * em + overlays);
    float below = 2 * margin;
    if (settings.flag("time_bar") && views.time_bar.available())
        below += views.time_bar.height() + margin;
    if (comparison_height() > 0) below += comparison_height() + margin;
    below += legend_room();
    const auto leaves_enough = [&](float height) {
        return comparison_height() > 0 || screen.height - below - height - margin >= useful;
    };
    // What a person has asked for gets its least room where there is too little.
    const auto leave = [&](float usual, float low) {
        below += (leaves_enough(usual) ? usual : low) + margin;
    };
    const bool plotted = !observing.plots().empty();
    if (plotted) leave(least_plot_height(), lowest_plot_height());
    if (!observing.pins().empty() && (!plotted || screen.width < stacked_below * em))
        leave(least_list * em, low_list * em);
    if (options.frames != nullptr && shows("timings")) leave(least_frames * em, low_frames * em);
    if (settings.flag("inspector") && !inspector_is_beside() &&
        leaves_enough(useful_inspector * em))
        below += useful_inspector * em + margin;
    // A good third of a low window has room for the title, one line and the prompt; overlays take
    // none of it.
    const float usual =
        std::min(whole, std::min(least_height * em, 0.35f * screen.height) + overlays);
    const float most = std::min(whole, std::max({screen.height - below, least, usual}));
    return std::clamp(settings.number("height") * screen.height, least, most);
}

/// Each value but the first adds its line of the legend, so that the curves keep their height.
float Console::State::least_plot_height() const {
    return least_plot * ImGui::GetFontSize() +
           PlotView::added_legend_height(observing.plots().size());
}

/// The same in a low window; a plot with less room is left out.
float Console::State::lowest_plot_height() const {
    return low_plot * ImGui::GetFontSize() +
           PlotView::added_legend_height(observing.plots().size());
}

/// The height at which the pictures of two runs use all of their width, within its share of the
/// screen; 0 without a comparison. It is the same with and without a selection.
float Console::State::comparison_height() {
    if (!comparison.shown() || !options.to_world) return 0;
    const float wide = screen.width - 2 * margin;
    return std::min(CompareView::height(wide, screen.width / screen.height),
                    compared_share * screen.height);
}

/// The height that stays free above the views at the lower edge for the legend of the game's
/// overlays.
float Console::State::legend_room() const {
    return shows("blame") ? std::ceil(least_legend * ImGui::GetFontSize()) : 0;
}

app::ClipRectangle Console::State::free_area(const app::ClipRectangle& whole) const {
    if (!status.was_open) {
        const Rect& sign = screen.paused_sign;
        if (sign.empty()) return whole;
        return {whole.left, whole.top, whole.width, std::max(0.0f, sign.low.y - whole.top)};
    }
    const Rect& side = screen.inspector_rect;
    const bool is_beside = side.low.y < screen.panel_rect.high.y;
    const float top = std::max({whole.top, screen.panel_rect.high.y, is_beside ? 0 : side.high.y});
    float right = whole.left + whole.width, low = whole.top + whole.height;
    if (!side.empty() && is_beside) right = std::min(right, side.low.x);
    low = std::min(low, views.compare_view.rect().empty() ? free_above() : top);
    return {whole.left, top, std::max(0.0f, right - whole.left), std::max(0.0f, low - top)};
}

/// The lowest free place above the views at the lower edge.
float Console::State::free_above() const {
    float low = screen.height - margin;
    for (const Rect& rect : {views.time_bar.rect(), views.watch_list.rect(), views.plot_view.rect(),
                             views.frame_view.rect()})
        if (!rect.empty()) low = std::min(low, rect.low.y - margin);
    return low;
}

/// Draws the time bar along the lower edge. Its width leaves room for the inspector even while that
/// does not reach down so far.
void Console::State::draw_time_bar(float right) {
    if (!settings.flag("time_bar") || !views.time_bar.available()) return views.time_bar.hide();
    const float low = screen.height - margin;
    time_marks.update();
    views.time_bar.draw(ImVec2(margin, low), screen.width - 2 * margin - right,
                        settings.number("opacity"), ui.bold());
}

/// Draws the pictures over the game and under the windows.
void Console::State::draw_in_game() {
    if (!options.to_pixels || (options.game_covered && options.game_covered())) return;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    app::ClipRectangle free{0, 0, screen.width, screen.height};
    if (options.free_of_others) free = options.free_of_others(free);
    list.PushClipRect(ImVec2(free.left, free.top),
                      ImVec2(free.left + free.width, free.top + free.height));
    ghosts.update(static_cast<double>(settings.number("ghost_time")));
    ghosts.draw(list, options.to_pixels);
    if (tree.alive(inspector.selected()) && shows("onion_skins"))
        onion_skins.draw(list, options.to_pixels);
    draw_outlines();
    list.PopClipRect();
}

/// Draws two runs between the panel and the views at the lower edge. They have all of the width,
/// because the inspector beside the panel then ends where the panel ends.
void Console::State::draw_comparison(double seconds) {
    if (!comparison.shown() || !options.to_world) return views.compare_view.hide();
    const float top = screen.panel_rect.high.y + margin;
    float low = free_above();
    if (settings.flag("inspector") && !inspector_is_beside()) {  // it is below both runs
        const float inspected = least_inspector * ImGui::GetFontSize() + margin;
        if (low - inspected >= top + CompareView::least_height) low -= inspected;
    }
    views.compare_view.draw({ImVec2(margin, top), ImVec2(screen.width - margin, low)}, comparison,
                            ui.pictures(), seconds,
                            views.time_bar.available() ? views.time_bar.times().dt : 1.0 / 60);
    // The windows would leave strips of the game visible between them.
    if (!views.compare_view.rect().empty())
        ImGui::GetBackgroundDrawList()->AddRectFilled(
            ImVec2(0, 0), ImVec2(screen.width, screen.height), palette::well);
}

/// Draws the times of the last frames above the observed values.
void Console::State::draw_frames(float right) {
    if (options.frames == nullptr || !shows("timings")) return views.frame_view.hide();
    float low = screen.height - margin;
    for (const Rect& rect :
         {views.time_bar.rect(), views.watch_list.rect(), views.plot_view.rect()})
        if (!rect.empty()) low = std::min(low, rect.low.y - margin);
    const float least = low_frames * ImGui::GetFontSize();
    float room = low - screen.panel_rect.high.y - margin;
    if (comparison_height() > 0)
        room -= std::clamp(room - least, 0.0f, comparison_height() + margin);
    if (room - legend_room() >= least) room -= legend_room();
    if (room < least) return views.frame_view.hide();
    const float tall = std::min(FrameView::height(), room);
    const double dt = views.time_bar.available() ? views.time_bar.times().dt : 1.0 / 60;
    views.frame_view.draw(ImVec2(margin, low),
                          ImVec2(std::max(120.0f, screen.width - 2 * margin - right), tall), tree,
                          *options.frames, dt, settings.number("opacity"));
}

/// Draws the watch list and the plot above the time bar.
void Console::State::draw_observed(float right) {
    observing.update();
    const float low = views.time_bar.rect().empty() ? screen.height - margin
                                                    : views.time_bar.rect().low.y - margin;
    const float wide = screen.width - 2 * margin - right, em = ImGui::GetFontSize();
    const bool pinned = !observing.pins().empty(), plotted = !observing.plots().empty();
    // In a low window, the other views are left out first.
    const float least = (pinned ? least_list * em : 0) + (plotted ? least_plot_height() : 0);
    float room = low - screen.panel_rect.high.y - margin;
    // Two runs get as much as they can use, other views all of their height or none.
    if (comparison_height() > 0)
        room -= std::clamp(room - least, 0.0f, comparison_height() + margin);
    const auto leave = [&](float pixels) {
        if (room - pixels >= least) room -= pixels;
    };
    if (options.frames != nullptr && shows("timings")) leave(least_frames * em + margin);
    if (settings.flag("inspector") && !inspector_is_beside()) leave(least_inspector * em + margin);
    leave(legend_room());
    const float opacity = settings.number("opacity");
    // Side by side, unless both would be too narrow for their values.
    const bool stacked = wide < stacked_below * em;
    float list = 0;
    if (pinned)
        list = stacked ? wide : std::min(wide, plotted ? std::min(28 * em, wide * 0.5f) : 34 * em);
    // A list above which a plot stands leaves it the least room, and scrolls.
    const float lowest_plot = lowest_plot_height();
    const float of_plot = plotted && stacked ? std::ceil(lowest_plot + margin) + 1 : 0;
    const float list_room = std::max(low_list * em, room - of_plot);
    if (room < low_list * em)
        views.watch_list.hide();
    else
        views.watch_list.draw(ImVec2(margin, low), list, list_room, tree, observing.pins(),
                              opacity);
    const bool under = pinned && stacked && !views.watch_list.rect().empty();
    const float bottom = under ? views.watch_list.rect().low.y - margin : low;
    const float left = margin + (pinned && !stacked ? list + margin : 0);
    const float plot_room = room - (low - bottom);
    if (plot_room < lowest_plot) return views.plot_view.hide();
    const TimeBar::Times now = views.time_bar.times();
    const float chosen = settings.number("plot_height") * settings.number("scale");
    const float usual = std::min(std::max(plot_room * 0.6f, least_plot * em), 16 * em);
    const float tall = std::min(std::max(chosen > 0 ? chosen : usual, low_plot * em), plot_room);
    views.plot_view.draw(ImVec2(left, bottom),
                         ImVec2(std::max(12 * em, wide - (left - margin)), tall), plot_room, tree,
                         observing.plots(), {now.step, now.oldest, now.newest, now.dt}, opacity);
    draw_plot_handle(tall);
}

void Console::State::draw_plot_handle(float plot_height) {
    const Rect& plot = views.plot_view.rect();
    // Most of it is outside, because the legend begins at the edge.
    screen.plot_edge = {ImVec2(plot.low.x, plot.low.y - 0.75f * handle_size),
                        ImVec2(plot.high.x, plot.low.y + 0.25f * handle_size)};
    if (!edge_is_dragged("##plot edge", screen.plot_edge, ImGuiMouseCursor_ResizeNS) ||
        ImGui::GetIO().MouseDelta.y == 0)
        return;
    const double tall = (plot_height + plot.low.y - ImGui::GetIO().MousePos.y) /
                        static_cast<double>(settings.number("scale"));
    settings.set("plot_height", property::Value(std::clamp(tall, 1.0, 4000.0)));
}

// --- The panel

void Console::State::draw_panel(float panel_width, float panel_height, float cell) {
    ImGui::SetNextWindowPos(ImVec2(margin, margin));
    ImGui::SetNextWindowSize(ImVec2(std::max(80.0f, panel_width), panel_height));
    ImGui::SetNextWindowBgAlpha(settings.number("opacity"));
    ImGui::Begin("##console", nullptr, panel_flags);
    screen.panel_rect = window_rect();
    draw_title(cell);
    if (settings.flag("overlays")) views.overlay_bar.draw();
    float prompt_height = views.prompt_view.height(panel_height);
    float log_height =
        ImGui::GetContentRegionAvail().y - prompt_height - ImGui::GetStyle().ItemSpacing.y * 2;
    if (inspector_is_in_panel())
        draw_inspector_in_panel(log_height);
    else if (views.tweak_list.available() && settings.flag("tweaks"))
        views.tweak_list.draw(std::max(1.0f, log_height));
    else
        draw_log(std::max(1.0f, log_height), cell);
    ImGui::Spacing();
    views.prompt_view.draw(prompt_height, cell, !ImGui::IsAnyItemActive());
    ImGui::End();
    if (!inspector_is_in_panel()) draw_height_handle();
}

void Console::State::draw_log(float log_height, float cell) {
    views.log_view.filter(settings.text("filter"));
    views.log_view.draw(log_height, cell);
}

void Console::State::draw_height_handle() {
    const Rect& panel = screen.panel_rect;
    screen.height_edge = {ImVec2(panel.low.x, panel.high.y - handle_size / 2),
                          ImVec2(panel.high.x, panel.high.y + handle_size / 2)};
    if (!edge_is_dragged("##height", screen.height_edge, ImGuiMouseCursor_ResizeNS) ||
        ImGui::GetIO().MouseDelta.y == 0)
        return;
    const float share = (ImGui::GetIO().MousePos.y - panel.low.y) / screen.height;
    settings.set("height", property::Value(std::clamp<double>(share, 0.15, 1)));
}

// --- The inspector

void Console::State::draw_inspector(float left, float inspector_width) {
    ImGui::SetNextWindowPos(ImVec2(left, margin));
    // Two runs are below it. It is as high without a selection, so that a selection moves nothing.
    const float tall = comparison_height() == 0 ? screen.height - 2 * margin : panel_height();
    ImGui::SetNextWindowSize(ImVec2(inspector_width, tall));
    ImGui::SetNextWindowBgAlpha(settings.number("opacity"));
    ImGui::Begin("##inspector", nullptr, panel_flags);
    screen.inspector_rect = window_rect();
    inspector.draw(ui.bold());
    ImGui::End();
    draw_width_handle();
}

void Console::State::draw_width_handle() {
    const Rect& side = screen.inspector_rect;
    screen.width_edge = {ImVec2(side.low.x - handle_size / 2, side.low.y),
                         ImVec2(side.low.x + handle_size / 2, side.high.y)};
    if (!edge_is_dragged("##width", screen.width_edge, ImGuiMouseCursor_ResizeEW) ||
        ImGui::GetIO().MouseDelta.x == 0)
        return;
    const float wide = side.high.x - ImGui::GetIO().MousePos.x;
    const float scale = settings.number("scale");
    const float most = std::min(2000.0f, screen.width * 0.6f / scale);
    settings.set("inspector_width",
                 property::Value(std::clamp<double>(wide / scale, 200, std::max(200.0f, most))));
}

}  // namespace fettle::console
