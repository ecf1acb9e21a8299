// The figures of the pen.
//   pen.circle(center, radius [, fill [, border [, width]]])
//   pen.ellipse(center, width, height [, fill [, border [, width [, angle]]]])
//   pen.box(center, width, height [, fill [, border [, width [, angle [, rounding]]]]])
//   pen.pie(center, radius, from, to [, fill [, border [, width]]])
//   pen.polygon(vertices [, fill [, border [, width]]])
//   pen.arc(center, radius, from, to [, color [, width]])
//   pen.line(from, to [, color [, width]])   pen.line(points [, color [, width]])
//   pen.point(position [, color [, size]])
// Angles are counter-clockwise as seen, also where y points down.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fettle/property/thick_line.h>

#include <library/pen_arguments.h>
#include <limits/limiters.h>
#include <lua/exception_guard.h>
#include <lua/machine.h>

namespace fettle::script {

using property::Color;
using property::Paint;
using property::Painter;

namespace {

// Instructions that are charged to an untrusted game for each pair of corners of a polygon that is
// not convex.
constexpr std::uint64_t pair_charge = 1;
constexpr double turn = 2 * std::numbers::pi;

/// The angle as the painter counts it: clockwise on the screen, where y points down.
double turned(const Painter& to, double angle) {
    return to.on_screen() ? -angle : angle;
}

Vec2 rotated(const Vec2& v, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * v.x - s * v.y, s * v.x + c * v.y};
}

std::vector<Vec2> points_at(lua_State* L, int index, const std::string& what, std::size_t least) {
    const Value value = to_value(L, index);
    if (!value.is(Type::list) || value.list().size() < least)
        throw Error(ErrorKind::wrong_type,
                    what + ": needs a list of " + (least == 2 ? "two" : "three") + " or more vec");
    std::vector<Vec2> points;
    points.reserve(value.list().size());
    for (const Value& each : value.list()) {
        if (!each.is(Type::vec2))
            throw Error(ErrorKind::wrong_type, what + ": needs a list of vec");
        check_finite(each.vec2().x, what.c_str());
        check_finite(each.vec2().y, what.c_str());
        points.push_back(each.vec2());
    }
    return points;
}

void stroke(Painter& to, const std::vector<Vec2>& points, Color color, float width) {
    // No body and no instance has this number.
    constexpr std::uint64_t whole = ~std::uint64_t{0};
    const double rounding = 0.5 * width / to.pixels_per_unit();
    std::vector<property::LinePiece> pieces;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        pieces.push_back({points[i], points[i + 1], rounding});
    property::draw_thick_line(to, whole, pieces, width, color);
}

/// Points of a circle from one angle to the other, such that it is seen as round.
std::vector<Vec2> arc_points(const Painter& to, const Vec2& center, double radius, double from,
                             double until) {
    constexpr double deviation = 0.1;  // px
    const double angle = std::clamp(until - from, -turn, turn);
    const double pixels = std::max(1.0, radius * to.pixels_per_unit());
    const double step = std::max(0.02, 2 * std::acos(1 - deviation / pixels));
    const int count = std::max(1, static_cast<int>(std::ceil(std::abs(angle) / step)));
    std::vector<Vec2> points;
    for (int i = 0; i <= count; ++i)
        points.push_back(center + rotated({radius, 0}, turned(to, from + angle * i / count)));
    return points;
}

int circle(lua_State* L) {
    drop_self(L);
    // One by one: of several wrong arguments, the first is reported.
    const Vec2 center = point_at(L, 1, "pen.circle");
    const double radius = length_at(L, 2, "pen.circle", "radius");
    painter(L).circle(center, radius, paint_at(L, 3, "pen.circle"));
    return 0;
}

int ellipse(lua_State* L) {
    drop_self(L);
    const Vec2 center = point_at(L, 1, "pen.ellipse");
    const double w = length_at(L, 2, "pen.ellipse", "width") / 2;
    const double h = length_at(L, 3, "pen.ellipse", "height") / 2;
    const double angle = angle_at(L, 7, "pen.ellipse", 0);
    Painter& to = painter(L);
    to.ellipse(center, {w, h}, turned(to, angle), paint_at(L, 4, "pen.ellipse"));
    return 0;
}

int box(lua_State* L) {
    drop_self(L);
    const Vec2 center = point_at(L, 1, "pen.box");
    double w = length_at(L, 2, "pen.box", "width") / 2;
    double h = length_at(L, 3, "pen.box", "height") / 2;
    const double angle = angle_at(L, 7, "pen.box", 0);
    double rounding = lua_isnoneornil(L, 8) ? 0 : length_at(L, 8, "pen.box", "rounding");
    // The painter adds the rounding around the polygon.
    rounding = std::min({rounding, w, h});
    w -= rounding;
    h -= rounding;
    Painter& to = painter(L);
    std::array<Vec2, 4> corners{Vec2(-w, -h), Vec2(w, -h), Vec2(w, h), Vec2(-w, h)};
    for (Vec2& corner : corners) corner = center + rotated(corner, turned(to, angle));
    to.polygon(corners, rounding, paint_at(L, 4, "pen.box"));
    return 0;
}

int polygon(lua_State* L) {
    drop_self(L);
    const std::vector<Vec2> vertices = points_at(L, 1, "pen.polygon", 3);
    machine_of(L).limiters.budget.charge(L, pair_charge * vertices.size() * vertices.size());
    painter(L).polygon(vertices, 0, paint_at(L, 2, "pen.polygon"));
    return 0;
}

struct Part {
    Vec2 center;
    double radius, from, to;
};

Part part_at(lua_State* L, const char* what) {
    return {point_at(L, 1, what), length_at(L, 2, what, "radius"), angle_at(L, 3, what, 0),
            angle_at(L, 4, what, turn)};
}

int pie(lua_State* L) {
    drop_self(L);
    const Part part = part_at(L, "pen.pie");
    Painter& to = painter(L);
    const Paint paint = paint_at(L, 5, "pen.pie");
    if (std::abs(part.to - part.from) >= turn) return to.circle(part.center, part.radius, paint), 0;
    if (part.to == part.from) return 0;
    std::vector<Vec2> points = arc_points(to, part.center, part.radius, part.from, part.to);
    points.push_back(part.center);
    to.polygon(points, 0, paint);
    return 0;
}

int arc(lua_State* L) {
    drop_self(L);
    const Part part = part_at(L, "pen.arc");
    Painter& to = painter(L);
    const Color color = color_or(L, 5, "pen.arc", {1, 1, 1, 1});
    stroke(to, arc_points(to, part.center, part.radius, part.from, part.to), color,
           width_or(L, 6, "pen.arc", 1.5));
    return 0;
}

int line(lua_State* L) {
    drop_self(L);
    if (vec_at(L, 1) == nullptr && (lua_istable(L, 1) || list_at(L, 1) != nullptr)) {
        const std::vector<Vec2> points = points_at(L, 1, "pen.line", 2);
        machine_of(L).limiters.budget.charge(L, points.size());
        const Color color = color_or(L, 2, "pen.line", {1, 1, 1, 1});
        stroke(painter(L), points, color, width_or(L, 3, "pen.line", 1.5));
        return 0;
    }
    const Vec2 from = point_at(L, 1, "pen.line"), to = point_at(L, 2, "pen.line");
    const Color color = color_or(L, 3, "pen.line", {1, 1, 1, 1});
    painter(L).line(from, to, color, width_or(L, 4, "pen.line", 1.5));
    return 0;
}

int point(lua_State* L) {
    drop_self(L);
    const Vec2 position = point_at(L, 1, "pen.point");
    const Color color = color_or(L, 2, "pen.point", {1, 1, 1, 1});
    painter(L).point(position, color, width_or(L, 3, "pen.point", 4));
    return 0;
}

}  // namespace

void add_figures(lua_State* L) {
    add_function<circle>(L, "circle");
    add_function<ellipse>(L, "ellipse");
    add_function<box>(L, "box");
    add_function<polygon>(L, "polygon");
    add_function<pie>(L, "pie");
    add_function<arc>(L, "arc");
    add_function<line>(L, "line");
    add_function<point>(L, "point");
}

}  // namespace fettle::script
