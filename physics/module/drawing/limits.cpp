// Limits of joints: arcs of the angles and lines of the translations that they allow.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <drawing/forms.h>
#include <drawing/marks.h>

namespace fettle::physics_module {
namespace {

using property::Color;
using property::Painter;
using property::Vec2;

constexpr Color allowed{1.0f, 0.72f, 0.3f, 0.9f};  // the range
constexpr Color present{1.0f, 0.95f, 0.7f, 1.0f};  // the value now

/// A body's coordinates as they are drawn; those of the world without a body.
class Side {
  public:
    Side(const HostedWorld& in, const physics::Body& body, double alpha)
        : frame_(body ? Frame(in, body.index(), alpha) : Frame()) {}
    Vec2 point(const physics::Vec2& local) const { return frame_.point(local); }
    Vec2 direction(const physics::Vec2& local) const {
        return frame_.point(local) - frame_.point(physics::Vec2(0, 0));
    }
    double angle() const { return frame_.angle(); }

  private:
    Frame frame_;
};

void draw_angle_limits(const physics::RevoluteJoint& joint, const Side& b, const Vec2& at,
                       Painter& painter) {
    double lower = static_cast<double>(joint.lower_angle());
    double upper = static_cast<double>(joint.upper_angle());
    if (!std::isfinite(lower) && !std::isfinite(upper)) return;
    const double now = static_cast<double>(joint.angle());
    // Without a limit on one side, a half turn is drawn to that side.
    if (!std::isfinite(lower)) lower = std::min(now, upper) - std::numbers::pi;
    if (!std::isfinite(upper)) upper = std::max(now, lower) + std::numbers::pi;
    const physics::Body body = joint.body_b();
    const Vec2 arm = body ? Vec2(b.point(body.center()) - at) : Vec2(0, 0);
    const double radius = std::clamp(0.6 * arm.length(), 0.4, 2.0);
    const double zero = (arm.length() > 1e-3 ? std::atan2(arm.y, arm.x) : b.angle()) - now;
    if (!painter.sees(at - Vec2(radius, radius), at + Vec2(radius, radius))) return;
    const auto rim = [&](double angle) {
        return Vec2(at + radius * Vec2(std::cos(zero + angle), std::sin(zero + angle)));
    };
    const int pieces = std::clamp(static_cast<int>((upper - lower) * 10), 2, 200);
    for (int i = 0; i < pieces; ++i)
        painter.line(rim(lower + (upper - lower) * i / pieces),
                     rim(lower + (upper - lower) * (i + 1) / pieces), allowed, 2);
    for (const double end : {lower, upper}) painter.line(at, rim(end), allowed, 1.5f);
    painter.line(at, rim(now), present, 2);
}

/// The translation of b along an axis of a.
void draw_translation_limits(const Side& a, const physics::Vec2& anchor, const physics::Vec2& axis,
                             double lower, double upper, double now, Painter& painter) {
    if (!std::isfinite(lower) && !std::isfinite(upper)) return;
    constexpr double open = 3;  // m that are drawn towards a side without a limit
    const bool ends_below = std::isfinite(lower), ends_above = std::isfinite(upper);
    if (!ends_below) lower = std::min(now, upper) - open;
    if (!ends_above) upper = std::max(now, lower) + open;
    const Vec2 zero = a.point(anchor), along = a.direction(axis).normalized();
    const Vec2 across(-along.y, along.x);
    const Vec2 from = zero + lower * along, to = zero + upper * along, at = zero + now * along;
    if (!painter.sees(from.min(to) - Vec2(1, 1), from.max(to) + Vec2(1, 1))) return;
    painter.line(from, to, allowed, 1.5f);
    const auto tick = [&](const Vec2& end) {
        painter.line(end - 0.2 * across, end + 0.2 * across, allowed, 2.5f);
    };
    if (ends_below) tick(from);
    if (ends_above) tick(to);
    painter.point(at, present, 7);
}

/// The distances that a rope allows, as circles round the anchor of a.
void draw_length_limits(const physics::DistanceJoint& joint, const Vec2& at, Painter& painter) {
    // A rod has one length, which its line shows already.
    if (std::isinf(joint.hertz())) return;
    const property::Paint ring{.fill = {0, 0, 0, 0}, .border = allowed, .border_width = 1.5f};
    for (const float length : {joint.min_length(), joint.max_length()})
        if (std::isfinite(length) && length > 0)
            painter.circle(at, static_cast<double>(length), ring);
}

template <class Sliding>
void draw_sliding(physics::World& world, const physics::Joint& joint, const Side& a,
                  Painter& painter) {
    const Sliding sliding(&world, joint.id());
    draw_translation_limits(a, joint.anchor_a(), sliding.axis(),
                            static_cast<double>(sliding.lower_translation()),
                            static_cast<double>(sliding.upper_translation()),
                            static_cast<double>(sliding.translation()), painter);
}

}  // namespace

void draw_limits(HostedWorld& in, Painter& painter, double alpha) {
    physics::World& world = in.world;
    for (const physics::Joint& joint : world.joints()) {
        if (joint.dormant() || joint.broken()) continue;
        const Side a(in, joint.body_a(), alpha), b(in, joint.body_b(), alpha);
        switch (joint.type()) {
            case physics::JointType::revolute:
                draw_angle_limits(physics::RevoluteJoint(&world, joint.id()), b,
                                  b.point(joint.anchor_b()), painter);
                break;
            case physics::JointType::distance:
                draw_length_limits(physics::DistanceJoint(&world, joint.id()),
                                   a.point(joint.anchor_a()), painter);
                break;
            case physics::JointType::prismatic:
                draw_sliding<physics::PrismaticJoint>(world, joint, a, painter);
                break;
            case physics::JointType::wheel:
                draw_sliding<physics::WheelJoint>(world, joint, a, painter);
                break;
            case physics::JointType::pin_slot:
                draw_sliding<physics::PinSlotJoint>(world, joint, a, painter);
                break;
            default:
                break;
        }
    }
}

}  // namespace fettle::physics_module
