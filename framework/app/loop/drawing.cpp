// Draws a frame.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>

#include <fettle/app/filled_box.h>
#include <fettle/app/foreground.h>
#include <fettle/app/loop.h>
#include <fettle/app/screen.h>
#include <fettle/property/drawing.h>
#include <fettle/property/fixed_text.h>
#include <fettle/property/last_value.h>

#include <loop/cameras.h>
#include <loop/effects.h>
#include <loop/wires.h>
#include <loop/writer_colors.h>
#include <time/smoothing.h>

namespace fettle::app {

using property::Color;
using property::Vec2;

namespace {

/// Black or white, whichever has the better contrast to `background`.
Color contrasting(Color background, float opacity) {
    const float light = 0.299f * background.r + 0.587f * background.g + 0.114f * background.b;
    const float shade = light < 0.5f ? 1.0f : 0.0f;
    return {shade, shade, shade, opacity};
}

/// Draws a grid. The lines are a power of ten of meters apart, which is 20 to 200 pixels.
void draw_grid(property::Painter& painter, const View& view) {
    const double spacing = std::pow(10, std::ceil(std::log10(20 / view.zoom())));
    const Vec2 lower = view.lower(), upper = view.upper();
    const auto line = [&](double at, int axis) {
        Vec2 from = lower, to = upper;
        from[axis] = to[axis] = at;
        const bool tenth = std::abs(std::remainder(at, 10 * spacing)) < 0.01 * spacing;
        const bool origin = std::abs(at) < 0.01 * spacing;
        const float opacity = origin ? 0.3f : tenth ? 0.14f : 0.06f;
        painter.line(from, to, contrasting(view.background, opacity), 1);
    };
    for (int axis = 0; axis < 2; ++axis)
        for (double n = std::ceil(lower[axis] / spacing); n * spacing <= upper[axis]; ++n)
            line(n * spacing, axis);
}

/// Draws the bars beside a picture that does not fill the window.
void draw_bars(property::Painter& painter, const View& view) {
    if (view.fit == Fit::expand) return;
    const Vec2 half = 0.5 * view.zoom() * Vec2(view.width(), view.height);
    // Counted from the corner of the picture.
    const Vec2 start = -1.0 * view.corner(), end = start + view.screen;
    const Vec2 middle = 0.5 * (start + end), lower = middle - half, upper = middle + half;
    const auto bar = [&](const Vec2& from, const Vec2& to) {
        if ((to - from).smallest() <= 0) return;
        const std::array<Vec2, 4> corners{from, Vec2(to.x, from.y), to, Vec2(from.x, to.y)};
        painter.polygon(corners, 0, {.fill = {0, 0, 0, 1}, .border = {0, 0, 0, 0}});
    };
    painter.begin_screen();
    bar(start, {lower.x, end.y});
    bar({upper.x, start.y}, end);
    bar(start, {end.x, lower.y});
    bar({start.x, upper.y}, end);
    painter.end_screen();
}

/// Draws the cover of the screen during a change of the scene, which scripts begin with
/// go_to_scene.
void draw_transition(property::Painter& painter, const property::Tree& tree, const Vec2& screen) {
    const property::Handle now = tree.child(tree.root(), "transition");
    if (!now || tree.class_of(now).name() != "Transition") return;
    const std::string kind = last_value(tree, now, "kind").text();
    if (kind == "none") return;
    const double progress = last_value(tree, now, "progress").as_double();
    Color color = last_value(tree, now, "color").color();
    const double covered = progress < 0.5 ? 2 * progress : 2 - 2 * progress;
    Vec2 from(0, 0), to = screen;
    painter.begin_screen();
    if (kind == "iris") {
        // A ring, the hole of which closes.
        const double all = 0.5 * screen.length() + 2;
        const auto thick = static_cast<float>(all * covered);
        painter.circle(0.5 * screen, all, {{0, 0, 0, 0}, color, std::max(1.0f, thick)});
    } else {
        if (kind == "fade") color.a *= static_cast<float>(covered);
        if (kind == "wipe" && progress < 0.5) to.x *= covered;
        if (kind == "wipe" && progress >= 0.5) from.x = screen.x * (1 - covered);
        const std::array<Vec2, 4> corners{from, Vec2(to.x, from.y), to, Vec2(from.x, to.y)};
        painter.polygon(corners, 0, {.fill = color, .border = {0, 0, 0, 0}});
    }
    painter.end_screen();
}

constexpr float usual_text = 15;  // px, the usual size of the console's text

/// Draws the frame rate and a bar for each phase of a frame at the top right.
void draw_timings(Surface& surface, const Clock& clock, float scale) {
    struct Row {
        const char* name;
        double ms;
    };
    const Timings& t = clock.timings;
    const std::array<Row, 7> rows{{{"input", t.input},
                                   {"update", t.update},
                                   {"scripts", t.scripts},
                                   {"modules", t.modules},
                                   {"handlers", t.handlers},
                                   {"draw", t.draw},
                                   {"wait", t.wait}}};
    const float row_height = 17 * scale, width = 220 * scale, padding = 10 * scale,
                high = 12 * scale;
    const float height = row_height * (rows.size() + 1) + 2 * padding;
    const float left = surface.width() - width - 12, top = 12;
    constexpr SurfaceColor ink{230, 233, 240, 255}, pale{150, 158, 172, 255};
    fill(surface, left, top, width, height, {16, 19, 25, 210});
    float y = top + padding;
    const std::string speed = property::fixed_text(clock.fps, 0) + " fps   " +
                              property::fixed_text(t.frame, 1) + " ms   " +
                              std::to_string(clock.dropped_steps) + " dropped";
    surface.text(left + padding, y, speed, high, ink, Face::plain);
    for (const Row& row : rows) {
        y += row_height;
        surface.text(left + padding, y, row.name, high, pale, Face::plain);
        surface.text(left + width - padding - 34 * scale, y, property::fixed_text(row.ms, 2), high,
                     ink, Face::plain);
        // The full length of a bar is 1/60 s.
        const float share = std::min(1.0f, static_cast<float>(row.ms * 60 / 1000));
        const float bar = 84 * scale, at = left + 76 * scale;
        fill(surface, at, y + 5 * scale, bar, 6 * scale, {255, 255, 255, 24});
        if (share > 0)
            fill(surface, at, y + 5 * scale, std::max(1.0f, bar * share), 6 * scale,
                 {110, 190, 255, 255});
    }
}

}  // namespace

ClipRectangle Loop::free_area(ClipRectangle whole, const Layer* except) const {
    for (const Layer* layer : layers_)
        if (layer != except) whole = layer->free_area(whole);
    return whole;
}

void Loop::draw(Screen& screen, double seconds) {
    const Pin pin(*this, "draw");
    const auto start = std::chrono::steady_clock::now();
    const View& view = services_.view;
    Clock& clock = services_.clock;
    const property::Drawing drawing(clock.alpha);
    screen.begin(view.background);
    View drawn = view.drawn(tree_, clock.alpha);
    float size = 0;  // of the texts of layers, such as the console
    for (const Layer* layer : layers_) size = std::max(size, layer->text_size());
    if (size > 0) drawn.label_scale = size / usual_text;
    property::Painter& painter = screen.painter(drawn);
    if (view.show.grid) draw_grid(painter, drawn);
    std::optional<WriterColors> blame;
    if (view.show.blame) blame.emplace(tree_, clock.dt);
    services_.cameras().draw(painter, drawn, clock.alpha, [&](property::Painter& on) {
        using Part = property::DrawingPart::Part;
        {
            const property::DrawingPart part(blame ? Part::instances : Part::all);
            if (halted_ || runtime_life_.expired())
                tree_.draw(tree_.root(), on, clock.alpha);
            else
                runtime_.draw(on);
        }
        if (!blame) return;
        blame->draw(on, clock.alpha);
        const property::DrawingPart part(Part::marks);  // over the colors of the writers
        tree_.draw(tree_.root(), on, clock.alpha);
    });
    if (view.show.wires) draw_wires(painter, tree_);
    draw_bars(painter, drawn);
    if (Foreground* const menus = services_.input.foreground()) menus->draw(painter);
    draw_transition(painter, tree_, drawn.picture());
    if (const Effect* const effect = services_.effects().now(clock.now))
        services_.effects().drawn(screen.apply(*effect));
    Surface& surface = screen.surface();
    const ClipRectangle free = free_area({0, 0, surface.width(), surface.height()});
    if (blame) blame->draw_legend(surface, free, size);
    // A layer at the upper edge, such as the console, shows them itself.
    if (view.show.timings && free.top == 0)
        draw_timings(surface, clock, static_cast<float>(drawn.label_scale));
    for (std::size_t i = 0; i < layers_.size(); ++i) layers_[i]->draw(screen.surface(), seconds);
    const std::chrono::duration<double, std::milli> spent =
        std::chrono::steady_clock::now() - start;
    clock.frames.add_drawing(spent.count());
    if (seconds > 0) smooth(clock.timings.draw, spent.count(), seconds);
}

void Loop::draw_layers(Screen& screen, double seconds) {
    const Pin pin(*this, "draw_layers");
    screen.begin(services_.view.background);
    for (std::size_t i = 0; i < layers_.size(); ++i) layers_[i]->draw(screen.surface(), seconds);
}

}  // namespace fettle::app
