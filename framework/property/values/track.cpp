#include <fettle/property/track.h>

#include <cmath>
#include <numbers>

namespace fettle::property {

namespace {

/// A move that is longer than this many times the move before does not continue it.
constexpr double most_acceleration = 4;

/// The shorter way between two angles: scripts often have angles that end at a half turn.
double shorter_turn(double from, double to) {
    const double turn = to - from;
    return std::abs(turn) <= std::numbers::pi ? turn : std::remainder(turn, 2 * std::numbers::pi);
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

}  // namespace fettle::property
