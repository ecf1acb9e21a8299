#include <contacts/mixing.h>
#include <geometry/vector.h>
#include <state/limits.h>

#include <cmath>

namespace fettle::physics::detail {
namespace {

float mixed(MixRule rule, float a, float b) {
    switch (rule) {
        case MixRule::average:
            return 0.5f * (a + b);
        case MixRule::minimum:
            return min(a, b);
        case MixRule::maximum:
            return max(a, b);
        case MixRule::multiply:
            return a * b;
        default:
            return std::sqrt(a * b);
    }
}

/// The radius on which a shape rolls, m; 0 for flat shapes. An ellipse rolls like a circle of the
/// same area.
float rolling_radius(const ObjectState& objects, uint32_t shape) {
    if (objects.forms[shape].kind != FormKind::ellipse) return objects.forms[shape].radius;
    const Ellipse ellipse = objects.shapes[shape].figure.as<Ellipse>();
    return std::sqrt(ellipse.radius_x * ellipse.radius_y);
}

}  // namespace

void remix(const ObjectState& objects, const WorldDef& settings, ContactRecord& c) {
    const ShapeDef& a = objects.shapes[c.shape_a].surface;
    const ShapeDef& b = objects.shapes[c.shape_b].surface;
    // Limited like the results of callbacks, because the product of two large numbers may be
    // infinite.
    c.friction = bounded(mixed(settings.friction_mix, a.friction, b.friction), greatest_grip);
    c.restitution = mixed(settings.restitution_mix, a.restitution, b.restitution);
    // On a flat shape, the other one rolls.
    const float radius_a = rolling_radius(objects, c.shape_a),
                radius_b = rolling_radius(objects, c.shape_b);
    c.rolling_resistance =
        bounded(max(a.rolling_resistance * (radius_a > 0.0f ? radius_a : radius_b),
                    b.rolling_resistance * (radius_b > 0.0f ? radius_b : radius_a)),
                greatest_grip);
    c.surface_speed = bounded(a.surface_speed + b.surface_speed, greatest_speed);
    c.hit_events = a.hit_events || b.hit_events;
    c.special = c.restitution > 0.0f || c.rolling_resistance > 0.0f || c.surface_speed != 0.0f;
}

void remix_shape(ObjectState& objects, const WorldDef& settings, uint32_t shape) {
    objects.for_each_contact_of(
        shape, [&](uint32_t contact) { remix(objects, settings, objects.contacts[contact]); });
}

}  // namespace fettle::physics::detail
