#include <fettle/property/between_steps.h>

#include <cmath>
#include <numbers>

#include "state.h"

namespace fettle::property {

namespace {

/// A move that is longer than this many times the move before does not continue it.
constexpr double most_acceleration = 4;

/// The shorter way between two angles: scripts often have angles that end at a half turn.
double shorter_turn(double from, double to) {
    const double turn = to - from;
    return std::abs(turn) <= std::numbers::pi ? turn : std::remainder(turn, 2 * std::numbers::pi);
}

/// Calls `visit(columns)` for the columns of each class whose instances have places.
template <class Visit>
void each_placed_class(Tree::State& s, Visit visit) {
    for (const auto& columns : s.instances.stored)
        if (columns != nullptr && columns->places.any()) visit(*columns);
}

}  // namespace

bool Track::jumped(const Vec2& way, double far) const {
    const double squared = way.length_squared();
    if (squared <= far * far) return false;
    // Not <=: without an earlier placement, nothing is continued.
    return !(squared < most_acceleration * most_acceleration *
                           (before_.position - earlier_.position).length_squared());
}

Placement Track::drawn(const Placement& now, double alpha, double far) const {
    if (std::isnan(before_.position.x)) return now;
    const double back = 1 - alpha;
    Placement at = now;
    if (now.position == after_.position) {
        const Vec2 way = after_.position - before_.position;
        if (jumped(way, far)) return now;
        at.position -= back * way;
    }
    if (now.angle == after_.angle) at.angle -= back * shorter_turn(before_.angle, after_.angle);
    if (now.scale == after_.scale && before_.scale * after_.scale > 0)
        at.scale -= back * (after_.scale - before_.scale);
    return at;
}

void note_step_begins(Tree& tree) {
    Tree::State& s = tree.state();
    each_placed_class(s, [](StoredColumns& c) { c.places.note_step_begins(c); });
    s.instances.ad_hoc.note_step_begins();
    ++s.noted.begun;
    s.noted.running = true;
}

void note_step_ended(Tree& tree, const FarMoves& far) {
    Tree::State& s = tree.state();
    each_placed_class(s, [](StoredColumns& c) { c.places.note_step_ended(c); });
    s.instances.ad_hoc.note_step_ended();
    s.noted.far = far;
    s.noted.running = false;
}

void note_step_left(Tree& tree) {
    tree.state().noted.running = false;
}

const NotedSteps& noted_steps(const Tree& tree) {
    return tree.state().noted;
}

Value drawn_points(const Tree& tree, Handle instance, const Property& points, bool on_screen,
                   double alpha) {
    const Tree::State& s = tree.state();
    const Node& node = s.instances.require(instance, points);
    const StoredColumns* const columns = s.instances.stored[node.class_id].get();
    if (columns == nullptr || !columns->places.has_points()) return tree.peek(instance, points);
    return columns->places.drawn_points(*columns, node.stored_row, alpha,
                                        on_screen ? s.noted.far.screen : s.noted.far.world);
}

}  // namespace fettle::property
