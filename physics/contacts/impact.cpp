#include <contacts/reports.h>

namespace fettle::physics::detail {

V2 middle_of(const ObjectState& objects, const ContactRecord& c) {
    const Manifold& m = c.manifold;
    V2 middle = m.points[0].anchor_a;
    if (m.count == 2) middle = 0.5f * (m.points[0].anchor_a + m.points[1].anchor_a);
    return objects.bodies[c.body_a].center + middle;
}

float approach_speed(const ObjectState& objects, const Columns& columns, const ContactRecord& c,
                     V2 point) {
    const auto velocity_of = [&](uint32_t body) {
        const BodyState& state = columns.states[body];
        return to_v2(state.velocity) +
               cross(state.angular_velocity, point - objects.bodies[body].center);
    };
    return max(0.0f, dot(c.manifold.normal, velocity_of(c.body_a) - velocity_of(c.body_b)));
}

float impact_mass(const ObjectState& objects, const ContactRecord& c, V2 point) {
    const BodyRecord &a = objects.bodies[c.body_a], &b = objects.bodies[c.body_b];
    const float lever_a = cross(point - a.center, c.manifold.normal);
    const float lever_b = cross(point - b.center, c.manifold.normal);
    const float inverse = a.inverse_mass + b.inverse_mass + a.inverse_inertia * lever_a * lever_a +
                          b.inverse_inertia * lever_b * lever_b;
    return inverse > 0.0f ? (1.0f + c.restitution) / inverse : 0.0f;
}

}  // namespace fettle::physics::detail
