#include <fettle/physics_c/drawing.h>

#include <cmath>

#include "calls.h"

namespace fettle::physics_c {

using namespace physics;

namespace {

constexpr float turn = 6.2831853f;
constexpr int arc_points = 32;  // of a whole turn

/// Pose at which a body is drawn; the origin for the world itself.
struct Place {
    Vec2 position = {};
    float cosine = 1.0f, sine = 0.0f;

    explicit Place(const Pose& pose)
        : position(pose.position), cosine(std::cos(pose.angle)), sine(std::sin(pose.angle)) {}
    Vec2 operator()(const Vec2& p) const {
        return position + Vec2(cosine * p.x - sine * p.y, sine * p.x + cosine * p.y);
    }
};

/// The outline of a convex core, counter-clockwise, at the distance `rounding` from it.
std::vector<Vec2> rounded(const std::vector<Vec2>& core, float rounding) {
    if (!(rounding > 0.0f)) return core;
    std::vector<Vec2> outline;
    const size_t count = core.size();
    const auto direction = [&](size_t i) {
        const Vec2 along = core[(i + 1) % count] - core[i];
        return std::atan2(-along.x, along.y);  // of the outward normal of the edge
    };
    for (size_t i = 0; i < count; ++i) {
        const float from = direction((i + count - 1) % count);
        float sweep = direction(i) - from;
        if (sweep < 0.0f) sweep += turn;
        const int steps = std::max(1, int(std::ceil(sweep / turn * arc_points)));
        for (int k = 0; k <= steps; ++k) {
            const float angle = from + sweep * float(k) / float(steps);
            outline.push_back(core[i] + rounding * Vec2(std::cos(angle), std::sin(angle)));
        }
    }
    return outline;
}

std::vector<Vec2> outline_of(const Ellipse& ellipse) {
    std::vector<Vec2> outline;
    const float cosine = std::cos(ellipse.angle), sine = std::sin(ellipse.angle);
    for (int i = 0; i < arc_points; ++i) {
        const float t = turn * float(i) / float(arc_points);
        const Vec2 p(ellipse.radius_x * std::cos(t), ellipse.radius_y * std::sin(t));
        outline.push_back(ellipse.center +
                          Vec2(cosine * p.x - sine * p.y, sine * p.x + cosine * p.y));
    }
    return outline;
}

/// Draws with the functions of a caller.
class Pen {
  public:
    explicit Pen(const fettle_debug_draw& draw) : draw_(draw) {}

    void polygon(const std::vector<Vec2>& points, const Place& at, bool closed, uint32_t color) {
        if (draw_.polygon == nullptr) return;
        placed_.clear();
        for (const Vec2& p : points) placed_.push_back(converted(at(p)));
        draw_.polygon(draw_.user, placed_.data(), uint32_t(placed_.size()), closed, color);
    }
    void circle(const Vec2& center, float radius, float angle, uint32_t color) {
        if (draw_.circle != nullptr)
            draw_.circle(draw_.user, converted(center), radius, angle, color);
    }
    void segment(const Vec2& from, const Vec2& to, uint32_t color) {
        if (draw_.segment != nullptr)
            draw_.segment(draw_.user, converted(from), converted(to), color);
    }
    void point(const Vec2& at, uint32_t color) {
        if (draw_.point != nullptr) draw_.point(draw_.user, converted(at), color);
    }

  private:
    const fettle_debug_draw& draw_;
    std::vector<fettle_vec2> placed_;
};

uint32_t color_of(const Body& body, const Shape& shape) {
    if (shape.sensor()) return 0xe0c050;
    if (body.type() == BodyType::static_body) return 0x70a070;
    if (body.type() == BodyType::kinematic_body) return 0x7090d0;
    return body.awake() ? 0xe0a090 : 0x909090;
}

void draw_shape(Pen& pen, const Shape& shape, const Pose& pose, uint32_t color) {
    const Place at(pose);
    const Geometry geometry = shape.geometry();
    const auto vertices = shape.vertices();
    const std::vector<Vec2> points(vertices.begin(), vertices.end());
    if (const auto* circle = std::get_if<Circle>(&geometry))
        pen.circle(at(circle->center), circle->radius, pose.angle, color);
    else if (const auto* ellipse = std::get_if<Ellipse>(&geometry))
        pen.polygon(outline_of(*ellipse), at, true, color);
    else if (const auto* chain = std::get_if<Chain>(&geometry))
        pen.polygon(points, at, chain->closed, color);
    else if (std::holds_alternative<Concave>(geometry))
        pen.polygon(points, at, true, color);
    else
        pen.polygon(rounded(points, shape.rounding()), at, true, color);
}

void draw_joint(Pen& pen, const Joint& joint) {
    constexpr uint32_t color = 0x60c0c0;
    const auto draw_end = [&](const Body& body, const Vec2& anchor) {
        if (body) pen.segment(body.world_center(), anchor, color);
        pen.point(anchor, color);
    };
    if (joint.dormant()) return;
    const Vec2 a = joint.world_anchor_a(), b = joint.world_anchor_b();
    draw_end(joint.body_a(), a);
    draw_end(joint.body_b(), b);
    pen.segment(a, b, color);
}

void draw_contacts(Pen& pen, const World& world) {
    constexpr float length = 0.2f;  // m, of a normal
    constexpr uint32_t color = 0xd04040;
    for (const Contact& contact : world.contacts()) {
        for (int i = 0; i < contact.point_count; ++i) {
            const Vec2 at = contact.points[size_t(i)].point;
            pen.point(at, color);
            pen.segment(at, at + length * contact.normal, color);
        }
    }
}

void draw_body(Pen& pen, const fettle_debug_draw& draw, const Body& body) {
    const Pose pose = body.interpolated(draw.fraction);
    for (const Shape& shape : body.shapes()) {
        if (flag(draw.shapes)) draw_shape(pen, shape, pose, color_of(body, shape));
        if (flag(draw.boxes)) {
            const Aabb box = shape.aabb();
            pen.polygon({box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}},
                        Place(Pose{}), true, 0x8060a0);
        }
    }
    if (flag(draw.centers)) pen.point(body.world_center(), 0xffffff);
}

}  // namespace
}  // namespace fettle::physics_c

using namespace fettle::physics_c;

fettle_code fettle_debug_draw_init(fettle_debug_draw* draw, size_t size) {
    fettle_debug_draw defaults{};
    defaults.shapes = true;
    defaults.joints = true;
    defaults.fraction = 1.0f;
    return init(__func__, draw, size, defaults);
}

fettle_code fettle_world_draw(fettle_world* world, const fettle_debug_draw* draw) {
    return guarded(__func__, [&] {
        using namespace fettle::physics;
        const World& drawn = live(world);
        const fettle_debug_draw& how = needed("draw", draw);
        check_size(how.size, sizeof how);
        checked(Finite{"fraction", how.fraction});
        const Visiting visiting(*world);
        Pen pen(how);
        for (const Body& body : drawn.bodies()) draw_body(pen, how, body);
        if (flag(how.joints))
            for (const Joint& joint : drawn.joints()) draw_joint(pen, joint);
        if (flag(how.contacts)) draw_contacts(pen, drawn);
    });
}
