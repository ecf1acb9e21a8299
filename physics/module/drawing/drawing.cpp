// Drawing: shapes between the last two poses of their bodies, and optional marks on top.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <fettle/property/label.h>

#include <bindings/bindings.h>
#include <drawing/drawing.h>
#include <drawing/forms.h>
#include <drawing/marks.h>

namespace fettle::physics_module {
namespace {

using property::Color;
using property::Overlay;
using property::Paint;
using property::Painter;
using property::Vec2;

/// Opacity of the fill of a sensor that has no color of its own: it is an area, and what is in it
/// stays visible. One that has a color is a thing of the game, such as a coin, and has that color.
constexpr float sensor_opacity = 0.25f;

bool sees(const Painter& painter, const physics::Aabb& box, const Vec2& reach) {
    return painter.sees(widen(box.min) - reach, widen(box.max) + reach);
}

/// How far a body is drawn from where it is, at most. The box of a shape is that of its current
/// pose; at an interpolated pose the shape may extend beyond the box by this distance.
Vec2 reach_of(const HostedWorld& in, std::uint32_t body, double alpha) {
    const auto& now = physics::HostAccess::state(in.world, body).position;
    if (const auto written = in.written_poses.drawn(in.world, body, alpha))
        return (widen(now) - written->position).abs();
    return widen(
        physics::Vec2((now - physics::HostAccess::previous(in.world, body).position).abs()));
}

/// The drawn position of a point of contact. It moves with the body that moves; if both move, it is
/// the mean of the two positions.
Vec2 shared_point(HostedWorld& in, const physics::Contact& contact, const physics::Vec2& point,
                  double alpha) {
    Vec2 sum(0, 0);
    int moving = 0;
    for (const physics::BodyId id : {contact.body_a, contact.body_b}) {
        if (!in.world.is_valid(id) || in.world.body(id).type() == physics::BodyType::static_body)
            continue;
        sum += Frame(in, id.index, alpha).point(in.world.body(id).local_point(point));
        ++moving;
    }
    return moving == 0 ? widen(point) : Vec2(sum / moving);
}

void draw_contacts(HostedWorld& in, Painter& painter, double alpha) {
    const Color dot{1.0f, 0.85f, 0.2f, 1.0f}, arrow{0.3f, 0.95f, 0.45f, 1.0f};
    for (const physics::Contact& contact : in.world.contacts()) {
        for (int k = 0; k < contact.point_count; ++k) {
            const physics::ContactPoint& p = contact.points[static_cast<std::size_t>(k)];
            const Vec2 at = shared_point(in, contact, p.point, alpha);
            if (!painter.sees(at, at)) continue;
            painter.point(at, dot, 6);
            // The weight of a kilogram is 10 N: drawn as a tenth of a meter.
            const double length = std::min(
                2.0, 0.01 * static_cast<double>(contact.normal_force) / contact.point_count);
            painter.line(at, at + length * widen(contact.normal), arrow, 1.5f);
        }
    }
}

void draw_outlines(HostedWorld& in, Painter& painter, double alpha) {
    for (const physics::Shape& shape : in.world.shapes()) {
        const physics::Body body = shape.body();
        if (!body || !sees(painter, shape.aabb(), reach_of(in, body.index(), alpha))) continue;
        const Color color =
            shape.sensor() ? Color{1.0f, 0.8f, 0.3f, 1.0f} : Color{0.25f, 0.45f, 1.0f, 1.0f};
        const Color inside = is_line(shape) ? color : Color{0, 0, 0, 0};
        draw_form(shape, Frame(in, body.index(), alpha), {inside, color, 1.5f}, painter);
    }
}

void draw_boxes(HostedWorld& in, Painter& painter, double alpha) {
    const Paint paint{{0, 0, 0, 0}, {0.85f, 0.45f, 0.85f, 0.8f}, 1.0f};
    for (const physics::Shape& shape : in.world.shapes()) {
        const physics::Body body = shape.body();
        if (!body) continue;
        const auto [a, b] = extent_of(shape, Frame(in, body.index(), alpha));
        if (!painter.sees(a, b)) continue;
        const std::array<Vec2, 4> corners = {a, Vec2(b.x, a.y), b, Vec2(a.x, b.y)};
        painter.polygon(corners, 0, paint);
    }
}

void draw_motion(HostedWorld& in, Painter& painter, double alpha) {
    const Color center{0.95f, 0.95f, 0.95f, 1.0f}, velocity{0.35f, 0.8f, 1.0f, 1.0f};
    for (const physics::Body& body : in.world.bodies()) {
        const Frame frame(in, body.index(), alpha);
        const Vec2 at = frame.point(body.center());
        if (!painter.sees(at, at)) continue;
        if (painter.shows(Overlay::velocities) && body.awake())
            painter.line(at, at + 0.1 * widen(body.velocity()), velocity, 1.5f);
        if (painter.shows(Overlay::centers)) painter.point(at, center, 5);
    }
}

/// A point in a body's coordinates, interpolated between the last two steps; in world coordinates
/// if there is no body.
Vec2 anchor_point(const HostedWorld& in, const physics::Body& body, const physics::Vec2& anchor,
                  double alpha) {
    return body ? Frame(in, body.index(), alpha).point(anchor) : widen(anchor);
}

/// Draws the line along which the joint acts, and lines to the centers of its bodies.
void draw_joint(const HostedWorld& in, const physics::Joint& joint, Painter& painter,
                double alpha) {
    const Color color = joint.broken()    ? Color{0.95f, 0.35f, 0.35f, 0.7f}
                        : joint.enabled() ? Color{0.6f, 0.95f, 0.75f, 1.0f}
                                          : Color{0.6f, 0.6f, 0.6f, 0.7f};
    const physics::Body a = joint.body_a(), b = joint.body_b();
    const Vec2 from = anchor_point(in, a, joint.anchor_a(), alpha);
    const Vec2 to = anchor_point(in, b, joint.anchor_b(), alpha);
    const Vec2 reach(1, 1);
    if (!painter.sees(from.min(to) - reach, from.max(to) + reach)) return;
    const auto type = joint.type();
    if (type == physics::JointType::pulley) {
        const physics::PulleyJoint pulley(&joint.world(), joint.id());
        const Vec2 over_a = widen(pulley.ground_a()), over_b = widen(pulley.ground_b());
        painter.line(from, over_a, color, 1.5f);
        painter.line(over_a, over_b, color, 1.5f);
        painter.line(over_b, to, color, 1.5f);
        return;
    }
    painter.line(from, to, color, 1.5f);
    if (type != physics::JointType::mouse && type != physics::JointType::distance) {
        const Color faint{color.r, color.g, color.b, 0.5f * color.a};
        if (a) painter.line(anchor_point(in, a, a.center(), alpha), from, faint, 1);
        if (b) painter.line(anchor_point(in, b, b.center(), alpha), to, faint, 1);
    }
    painter.point(from, color, 5);
    painter.point(to, color, 5);
}

void draw_joints(HostedWorld& in, Painter& painter, double alpha) {
    for (const physics::Joint& joint : in.world.joints())
        if (!joint.dormant()) draw_joint(in, joint, painter, alpha);
}

/// Where labels are drawn: in cells as high as half a label. None is drawn over another one.
class LabelPlaces {
  public:
    explicit LabelPlaces(double height) : cell_(height / 2) {}
    /// False if a label is there already.
    bool reserve(const Vec2& middle, std::string_view text) {
        const Vec2 reach(cell_ * 0.6 * static_cast<double>(text.size()), cell_);
        const std::int64_t left = number(middle.x - reach.x), right = number(middle.x + reach.x);
        const std::int64_t low = number(middle.y - reach.y), high = number(middle.y + reach.y);
        for (std::int64_t y = low; y <= high; ++y)
            for (std::int64_t x = left; x <= right; ++x)
                if (taken_.contains({x, y})) return false;
        for (std::int64_t y = low; y <= high; ++y)
            for (std::int64_t x = left; x <= right; ++x) taken_.insert({x, y});
        return true;
    }

  private:
    std::int64_t number(double place) const {
        return static_cast<std::int64_t>(std::floor(place / cell_));
    }
    double cell_;
    std::set<std::pair<std::int64_t, std::int64_t>> taken_;
};

void draw_names(const property::Tree& tree, HostedWorld& in, Painter& painter, double alpha) {
    // Readable from far, and no larger than needed from near.
    const double pixel = 1 / painter.pixels_per_unit();
    const double height = painter.label_scale() * std::clamp(0.35, 13 * pixel, 20 * pixel);
    LabelPlaces places(height);
    for (const physics::Body& body : in.world.bodies()) {
        const Vec2 at = Frame(in, body.index(), alpha).point(body.center());
        const Handle self = unpack(body.user_data());
        if (!painter.sees(at, at) || !tree.alive(self)) continue;
        const std::string name(tree.get(self, "name").text());  // a guest has no name()
        if (places.reserve(at, name)) property::draw_label(painter, at, name, height, {1, 1, 1, 1});
    }
}

}  // namespace

namespace {

void draw_figure(Hosting& hosting, Row row, Painter& painter, double alpha) {
    HostedWorld& in = hosting.hosted(row);
    const Look look = in.looks.get(slot_of(row));
    if (!look.visible && !painter.shows(Overlay::shapes)) return;
    const physics::Shape shape = hosting.shape(row);
    const physics::Body owner = shape.body();
    const Vec2 reach = owner ? reach_of(in, owner.index(), alpha) : Vec2(0, 0);
    if (!sees(painter, shape.aabb(), reach)) return;
    Paint paint{.fill = hosting.fill_of(row), .border = hosting.border_of(row)};
    // A painter of outlines does not use the colors: it draws what is hidden, too.
    if (!look.visible) paint.fill.a = paint.border.a = 0;
    if (shape.sensor() && !look.fill) paint.fill.a *= sensor_opacity;
    const Frame frame = owner ? Frame(in, owner.index(), alpha) : Frame();
    const bool alone = !owner || owner.shape_count() < 2;
    // The lines of a chain are parts of one figure, too.
    const bool whole = !alone || is_line(shape);
    if (whole)
        painter.part_of(make_row(world_number(row), owner ? owner.index() : 0) + std::uint64_t{1});
    draw_form(shape, frame, paint, painter);
    if (whole) painter.part_of(0);
    if (look.orientation_mark) draw_mark(shape, frame, paint, painter);
}

}  // namespace

void draw_shape(void* context, const property::Tree&, Handle, Row row, Painter& painter,
                double alpha) {
    draw_figure(*static_cast<ShapeKind*>(context)->hosting, row, painter, alpha);
}

void draw_mover(void* context, const property::Tree&, Handle, Row row, Painter& painter,
                double alpha) {
    Hosting& hosting = *static_cast<Hosting*>(context);
    if (const physics::Shape shape = capsule_of(hosting.body(row)))
        draw_figure(hosting, make_row(world_number(row), shape.index()), painter, alpha);
}

void draw_world_overlays(void* context, const property::Tree& tree, Handle, Row row,
                         Painter& painter, double alpha) {
    Hosting& hosting = *static_cast<Hosting*>(context);
    HostedWorld& in = hosting.hosted(row);
    if (painter.shows(Overlay::shapes)) draw_outlines(in, painter, alpha);
    if (painter.shows(Overlay::aabbs)) draw_boxes(in, painter, alpha);
    if (painter.shows(Overlay::joints)) draw_joints(in, painter, alpha);
    if (painter.shows(Overlay::islands)) draw_islands(in, painter, alpha);
    if (painter.shows(Overlay::velocities) || painter.shows(Overlay::centers))
        draw_motion(in, painter, alpha);
    if (painter.shows(Overlay::limits)) draw_limits(in, painter, alpha);
    if (painter.shows(Overlay::contacts)) draw_contacts(in, painter, alpha);
    if (painter.shows(Overlay::impulses)) draw_impulses(in.world, hosting.last_dt, painter);
    if (painter.shows(Overlay::names)) draw_names(tree, in, painter, alpha);
}

}  // namespace fettle::physics_module
