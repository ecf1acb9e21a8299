// A sign over a game that stands still because of the console, while the console is closed.

#include <algorithm>
#include <cmath>
#include <string>

#include <fettle/app/filled_box.h>

#include <observed/game_time.h>
#include <panel/state.h>

namespace fettle::console {

namespace {

constexpr app::SurfaceColor panel_color{20, 23, 30, 255}, text_color{218, 221, 229, 255},
    bar_color{244, 162, 89, 255};

void fill_box(app::Surface& surface, const Rect& box, app::SurfaceColor color) {
    app::fill(surface, box.low.x, box.low.y, box.high.x - box.low.x, box.high.y - box.low.y, color);
}

}  // namespace

/// Whether the player has paused the game with the console, and cannot see that. A script that
/// pauses its game, for a menu, shows that itself. Before the console was used once, a command of a
/// script of the run has paused the game, and pictures of such a run show the game only.
bool Console::State::hides_pause() const {
    if (status.was_open || !status.used || (options.game_covered && options.game_covered()))
        return false;
    const property::Handle time = tree.child(tree.root(), "time");
    const property::Property* const paused = time ? tree.find(time, "paused") : nullptr;
    if (paused == nullptr || last_value(tree, time, *paused) != property::Value(true)) return false;
    const property::Provenance written = tree.last_writer(time, *paused);
    return !written.known || written.cause.writer != property::Writer::script;
}

void Console::State::draw_paused_sign(app::Surface& surface) {
    screen.paused_sign = {};
    if (!hides_pause()) return;
    const std::string text =
        "paused · click here to go on, " + settings.shown_key() + " opens the console";
    const float size = std::clamp(
        std::round(settings.number("font_size") * settings.number("scale")), 6.0f, 96.0f);
    const auto wide = [&](std::string_view part) {
        return surface.text(0, 0, part, size, {0, 0, 0, 0}, app::Face::plain);
    };
    const float pad = 0.6f * size, bar = 0.22f * size, bars = 3 * bar;
    const float room = surface.width() - 2 * (pad + pad) - bars - pad;
    // In a narrow window the sign says less.
    const std::string_view shown = wide(text) <= room ? text : std::string_view(text).substr(0, 6);
    app::ClipRectangle free{0, 0, surface.width(), surface.height()};
    if (options.free_of_others) free = options.free_of_others(free);
    const float tall = size + 2 * pad, left = pad, top = free.top + free.height - pad - tall;
    screen.paused_sign = {ImVec2(left, top),
                          ImVec2(left + 3 * pad + bars + wide(shown), top + tall)};
    fill_box(surface, screen.paused_sign, panel_color);
    for (const float x : {left + pad, left + pad + 2 * bar})
        fill_box(surface, {ImVec2(x, top + pad), ImVec2(x + bar, top + pad + size)}, bar_color);
    surface.text(left + 2 * pad + bars, top + pad - 0.1f * size, shown, size, text_color,
                 app::Face::plain);
}

/// A click on the sign goes on.
bool Console::State::click_paused_sign(const app::InputEvent& event) {
    if (event.name != "left" || !screen.paused_sign.contains(event.x, event.y) || !hides_pause())
        return false;
    set_time_flag(tree, "paused", false);
    screen.paused_sign = {};
    return true;
}

void Console::show_pause() {
    state_->status.used = true;
}

std::string Console::shown_key() const {
    return state_->settings.shown_key();
}

}  // namespace fettle::console
