// Drawing of a world as outlines, with the functions of a host.

#include <checks/arguments.h>
#include <fettle/physics/debug_draw.h>
#include <geometry/trigonometry.h>
#include <world/world_data.h>

#include <algorithm>
#include <cmath>

namespace fettle::physics {

using namespace detail;

namespace {

constexpr int arc_points = 32;  // of a whole turn

constexpr uint32_t sensor_color = 0xe0c050, static_color = 0x70a070, kinematic_color = 0x7090d0,
                   awake_color = 0xe0a090, asleep_color = 0x909090, joint_color = 0x60c0c0,
                   contact_color = 0xd04040, box_color = 0x8060a0, center_color = 0xffffff;

constexpr float normal_length = 0.2f;  // m, of the normal of a contact

/// Coordinates of a body as coordinates of the world.
struct Place {
    Position position;
    Rotation rotation;

    explicit Place(const Pose& pose) : position(pose.position), rotation(rotation_of(pose.angle)) {}
    Position operator()(Vec2 local) const { return position + rotate(rotation, local); }
};

Vec2 on_circle(float angle) {
    const Rotation q = rotation_of(angle);
    return {q.c, q.s};
}

Aabb box_around(const Position& a, const Position& b) {
    return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

/// The functions of a host, of which any may destroy the world: then the drawing ends.
class Pen {
  public:
    Pen(const WorldSelf& self, DebugDraw& target) : self_(self), target_(target) {}

    void polygon(std::span<const Position> points, bool closed, uint32_t color) {
        target_.polygon(points, closed, color);
        check_alive();
    }
    void circle(const Position& center, float radius, float angle, uint32_t color) {
        target_.circle(center, radius, angle, color);
        check_alive();
    }
    void segment(const Position& from, const Position& to, uint32_t color) {
        target_.segment(from, to, color);
        check_alive();
    }
    void point(const Position& at, uint32_t color) {
        target_.point(at, color);
        check_alive();
    }
    uint32_t color_of(const Body& body, const Shape& shape) const {
        const uint32_t color = target_.color_of(body, shape);
        check_alive();
        return color;
    }

  private:
    void check_alive() const {
        if (self_.orphaned()) self_.throw_orphaned();
    }

    const WorldSelf& self_;
    DebugDraw& target_;
};

class Drawing {
  public:
    Drawing(const World& world, const Pen& target, const DebugDrawOptions& options)
        : world_(world), target_(target), options_(options) {}

    void draw() {
        for (const Body& body : world_.bodies()) draw_body(body);
        if (options_.joints)
            for (const Joint& joint : world_.joints()) draw_joint(joint);
        if (options_.contacts)
            for (const Contact& contact : world_.contacts()) draw_contact(contact);
    }

  private:
    void draw_body(const Body& body) {
        if (options_.region && !overlap(*options_.region, body.aabb())) return;
        const Pose pose = body.interpolated(options_.fraction);
        for (const Shape& shape : body.shapes()) {
            if (options_.shapes) draw_shape(shape, pose, target_.color_of(body, shape));
            if (options_.boxes) draw_box(shape.aabb());
        }
        if (options_.centers) target_.point(body.world_center(), center_color);
    }

    void draw_shape(const Shape& shape, const Pose& pose, uint32_t color) {
        const Place at(pose);
        points_.clear();
        switch (shape.type()) {
            case ShapeType::circle:
                return target_.circle(at(shape.center()), shape.radius(), pose.angle, color);
            case ShapeType::ellipse:
                add_ellipse(std::get<Ellipse>(shape.geometry()), at);
                return target_.polygon(points_, true, color);
            case ShapeType::chain:
            case ShapeType::concave:
                for (const Vec2& p : shape.vertices()) points_.push_back(at(p));
                return target_.polygon(points_,
                                       shape.type() == ShapeType::concave || shape.closed(), color);
            default:
                add_rounded(shape.vertices(), shape.rounding(), at);
                return target_.polygon(points_, true, color);
        }
    }

    void add_ellipse(const Ellipse& ellipse, const Place& at) {
        const Rotation q = rotation_of(ellipse.angle);
        for (int i = 0; i < arc_points; ++i) {
            const Vec2 p = on_circle(two_pi<float> * float(i) / float(arc_points));
            points_.push_back(
                at(ellipse.center + rotate(q, {ellipse.radius_x * p.x, ellipse.radius_y * p.y})));
        }
    }

    /// Adds the outline of a convex core, at the distance `rounding` from it.
    void add_rounded(std::span<const Vec2> core, float rounding, const Place& at) {
        const size_t count = core.size();
        const auto direction = [&](size_t i) {
            const Vec2 along = core[(i + 1) % count] - core[i];
            return std::atan2(-along.x, along.y);  // of the outward normal of the edge
        };
        for (size_t i = 0; i < count; ++i) {
            if (!(rounding > 0.0f)) {
                points_.push_back(at(core[i]));
                continue;
            }
            const float from = direction((i + count - 1) % count);
            float sweep = direction(i) - from;
            if (sweep < 0.0f) sweep += two_pi<float>;
            const int steps = std::max(1, int(std::ceil(sweep / two_pi<float> * arc_points)));
            for (int k = 0; k <= steps; ++k)
                points_.push_back(
                    at(core[i] + rounding * on_circle(from + sweep * float(k) / float(steps))));
        }
    }

    void draw_box(const Aabb& box) {
        const Position corners[] = {
            box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
        target_.polygon(corners, true, box_color);
    }

    void draw_joint(const Joint& joint) {
        if (joint.dormant()) return;
        const Position a = joint.world_anchor_a(), b = joint.world_anchor_b();
        if (options_.region && !overlap(*options_.region, box_around(a, b))) return;
        draw_end(joint.body_a(), a);
        draw_end(joint.body_b(), b);
        target_.segment(a, b, joint_color);
    }
    void draw_end(const Body& body, const Position& anchor) {
        if (body) target_.segment(body.world_center(), anchor, joint_color);
        target_.point(anchor, joint_color);
    }

    void draw_contact(const Contact& contact) {
        for (int i = 0; i < contact.point_count; ++i) {
            const Position at = contact.points[size_t(i)].point;
            if (options_.region && !overlap(*options_.region, {at, at})) continue;
            target_.point(at, contact_color);
            target_.segment(at, at + normal_length * contact.normal, contact_color);
        }
    }

    const World& world_;
    Pen target_;
    const DebugDrawOptions& options_;
    std::vector<Position> points_;
};

}  // namespace

DebugDraw::~DebugDraw() = default;

uint32_t DebugDraw::color_of(const Body& body, const Shape& shape) const {
    if (shape.sensor()) return sensor_color;
    if (body.type() == BodyType::static_body) return static_color;
    if (body.type() == BodyType::kinematic_body) return kinematic_color;
    return body.awake() ? awake_color : asleep_color;
}

void World::draw(DebugDraw& target, const DebugDrawOptions& options) const {
    check_finite("fraction", options.fraction);
    if (options.region) check_box("region", *options.region);
    data_->read_all();  // before the world is locked
    WorldLock lock(data_->self, WorldLock::During::query, in_draw);
    Drawing(*this, Pen(data_->self, target), options).draw();
    lock.finish();
}

}  // namespace fettle::physics
