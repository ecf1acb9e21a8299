#include <in_game/ghosts.h>
#include <observed/game_time.h>

#include <algorithm>
#include <cmath>

#include <fettle/property/drawing.h>
#include <fettle/property/error.h>
#include <fettle/property/pose.h>

#include <look/theme.h>

namespace fettle::console {

using property::Handle;
using property::Record;
using property::Transform;
using property::Type;
using property::Value;
using property::Vec2;

namespace {

constexpr const char* ghost_method = "ghosts";
constexpr std::size_t most_drawn = 200;  // ghosts
constexpr float nearest = 3;             // px between two drawn points of a way

double length_of(const std::vector<Vec2>& points) {
    double sum = 0;
    for (std::size_t i = 1; i < points.size(); ++i) sum += (points[i] - points[i - 1]).length();
    return sum;
}

/// Draws a way that gets paler towards its end.
void draw_way(ImDrawList& list, const std::vector<Vec2>& points, const ToPixels& to_pixels) {
    const auto pixel = [&](std::size_t i) {
        const Vec2 p = to_pixels(points[i]);
        return ImVec2(static_cast<float>(p.x), static_cast<float>(p.y));
    };
    ImVec2 last = pixel(0);
    for (std::size_t i = 1; i < points.size(); ++i) {
        const ImVec2 next = pixel(i);
        const bool far = std::hypot(next.x - last.x, next.y - last.y) >= nearest;
        if (!far && i + 1 < points.size()) continue;
        const float share = static_cast<float>(i) / static_cast<float>(points.size());
        list.AddLine(last, next, with_alpha(palette::note, 0.75f - 0.5f * share), 2);
        last = next;
    }
}

}  // namespace

Ghosts::Ghosts(property::Tree& tree) : tree_(tree) {
    tree_.observe(*this);
}

Ghosts::~Ghosts() {
    tree_.unobserve(*this);
}

// --- Edits

void Ghosts::wrote(Handle, const property::Property& property, const Value&) {
    // Transient properties, such as the pause itself, are not part of the game.
    if (!property.transient) note();
}

void Ghosts::wrote_plain(const property::PlainWrites& writes) {
    if (!watches_ || edited_) return;
    for (const property::PlainWrite& write : writes.list)
        if (write.property != nullptr && !write.property->transient) return note();
}

void Ghosts::note() {
    if (!watches_ || edited_) return;
    const property::Writer writer = tree_.cause().writer;
    edited_ = writer == property::Writer::console || writer == property::Writer::inspector ||
              writer == property::Writer::undo || writer == property::Writer::remote;
}

void Ghosts::forget() {
    ghosts_.clear();
    edited_ = false;
}

// --- Looking ahead

void Ghosts::watch(bool on) {
    const Value paused = time_value(tree_, "paused"), step = time_value(tree_, "step");
    watches_ = on && paused.is(Type::boolean) && paused.boolean();
    if (!watches_) return forget();
    const std::int64_t here = step.is(Type::integer) ? step.integer() : 0;
    if (here != step_ && !edited_) forget();
    step_ = here;
}

void Ghosts::update(double seconds) {
    if (!edited_) return;
    look_ahead(seconds);
    edited_ = false;
}

void Ghosts::look_ahead(double seconds) {
    ghosts_.clear();
    std::vector<Handle> worlds;
    tree_.each_below(tree_.root(), [&](Handle instance) {
        if (tree_.class_of(instance).method(ghost_method) != nullptr) worlds.push_back(instance);
    });
    for (const Handle world : worlds) {
        try {
            const property::Result found = tree_.call(world, ghost_method, {Value(seconds)});
            const auto* const all = std::get_if<std::vector<Record>>(&found);
            if (all == nullptr) continue;
            for (const Record& record : *all) {
                Ghost ghost{record.get("body").reference(), {}, record.get("angle").number()};
                const Value points = record.get("points");
                for (const Value& point : points.list()) ghost.points.push_back(point.vec2());
                if (!ghost.points.empty()) ghosts_.push_back(std::move(ghost));
            }
        } catch (const property::Error&) {
            // A method of this name that means something else has no ghosts.
        }
    }
    std::ranges::stable_sort(ghosts_, [](const Ghost& a, const Ghost& b) {
        return length_of(a.points) > length_of(b.points);
    });
    if (ghosts_.size() > most_drawn) ghosts_.resize(most_drawn);
}

void Ghosts::draw(ImDrawList& list, const ToPixels& to_pixels) const {
    const double alpha = property::Drawing::alpha();
    for (const Ghost& ghost : ghosts_) {
        if (!tree_.alive(ghost.instance)) continue;
        draw_way(list, ghost.points, to_pixels);
        const auto now = property::place_below(tree_, ghost.instance, false, alpha);
        if (!now) continue;
        const Transform end = Transform::placed(ghost.points.back(), ghost.angle);
        Pen pen(list, to_pixels, {.color = with_alpha(palette::note, 0.45f), .width = 1.5f},
                end * inverse(*now));
        tree_.draw(ghost.instance, pen, alpha);
    }
}

}  // namespace fettle::console
