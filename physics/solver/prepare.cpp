#include <world/world_data.h>

// Between the records and the solver: constraints are written once a step in the order of the awake
// contacts, and their impulses are read back.

namespace fettle::physics::detail {
namespace {

float inverse_or_zero(float k) {
    return k > 0.0f ? 1.0f / k : 0.0f;
}

void prepare_point(const ManifoldPoint& m, V2 n, V2 t, const SolverBody& a, const SolverBody& b,
                   float impulse_ratio, ConstraintPoint& p) {
    p.normal_lever_a = cross(m.anchor_a, n);
    p.normal_lever_b = cross(m.anchor_b, n);
    p.tangent_lever_a = cross(m.anchor_a, t);
    p.tangent_lever_b = cross(m.anchor_b, t);
    p.separation = m.separation;
    const float k = a.inverse_mass + b.inverse_mass;
    p.normal_mass = inverse_or_zero(k + a.inverse_inertia * p.normal_lever_a * p.normal_lever_a +
                                    b.inverse_inertia * p.normal_lever_b * p.normal_lever_b);
    p.tangent_mass = inverse_or_zero(k + a.inverse_inertia * p.tangent_lever_a * p.tangent_lever_a +
                                     b.inverse_inertia * p.tangent_lever_b * p.tangent_lever_b);
    p.normal_impulse = m.normal_impulse * impulse_ratio;
    p.tangent_impulse = m.tangent_impulse * impulse_ratio;
}

void prepare_extra(const ContactRecord& record, const ContactConstraint& c, const SolverBody& a,
                   const SolverBody& b, float impulse_ratio, ContactExtra& extra) {
    extra.restitution = record.restitution;
    extra.surface_speed = record.surface_speed;
    extra.rolling_resistance = record.rolling_resistance;
    extra.rolling_mass = inverse_or_zero(a.inverse_inertia + b.inverse_inertia);
    extra.rolling_impulse = record.rolling_impulse * impulse_ratio;
    for (int k = 0; k < c.count; ++k) {
        const ConstraintPoint& p = c.points[k];
        extra.approach[k] = dot(c.normal, b.velocity - a.velocity) +
                            p.normal_lever_b * b.angular_velocity -
                            p.normal_lever_a * a.angular_velocity;
    }
}

}  // namespace

void WorldData::prepare_contacts(float h) {
    constraints.clear();
    extras.clear();
    const float ratio = last_substep > 0.0f ? h / last_substep : 1.0f;
    for (uint32_t slot : awake_contacts) {
        const ContactRecord& record = contacts[slot];
        const Manifold& m = record.manifold;
        if (m.count == 0 || record.sensor) continue;
        const uint32_t ia = bodies[record.body_a].solver_index;
        const uint32_t ib = bodies[record.body_b].solver_index;
        const SolverBody& a = solver_bodies[ia];
        const SolverBody& b = solver_bodies[ib];
        ContactConstraint& c = constraints.emplace_back();
        c.a = ia;
        c.b = ib;
        c.normal = m.normal;
        c.friction = record.friction;
        c.contact = slot;
        c.count = uint16_t(m.count);
        c.fixed = (a.inverse_mass == 0.0f) | (b.inverse_mass == 0.0f) ? 1 : 0;
        const V2 t = right_perp(m.normal);
        for (int k = 0; k < m.count; ++k)
            prepare_point(m.points[k], m.normal, t, a, b, ratio, c.points[k]);
        if (m.count == 2) {
            const ConstraintPoint &p = c.points[0], &q = c.points[1];
            const float inverse = a.inverse_mass + b.inverse_mass;
            c.coupling_normal = inverse + a.inverse_inertia * p.normal_lever_a * q.normal_lever_a +
                                b.inverse_inertia * p.normal_lever_b * q.normal_lever_b;
            c.coupling_tangent = inverse +
                                 a.inverse_inertia * p.tangent_lever_a * q.tangent_lever_a +
                                 b.inverse_inertia * p.tangent_lever_b * q.tangent_lever_b;
        }
        c.extra = 0;
        if (record.special) {
            prepare_extra(record, c, a, b, ratio, extras.emplace_back());
            c.extra = uint32_t(extras.size());
        }
    }
}

void WorldData::store_contacts() {
    for (const ContactConstraint& c : constraints) {
        ContactRecord& record = contacts[c.contact];
        Manifold& m = record.manifold;
        float impulse = 0.0f, nearest = m.points[0].separation;
        for (int k = 0; k < c.count; ++k) {
            m.points[k].normal_impulse = c.points[k].normal_impulse;
            m.points[k].tangent_impulse = c.points[k].tangent_impulse;
            impulse += c.points[k].normal_impulse;
            nearest = min(nearest, m.points[k].separation);
        }
        if (c.extra != 0) {
            const ContactExtra& extra = extras[c.extra - 1];
            record.rolling_impulse = extra.rolling_impulse;
            impulse += extra.greatest[0] + extra.greatest[1];
        }
        // A bounce is over within one step and never looks near: its impulse tells. Twice the
        // distance ends a touch, so that nothing flickers at the limit.
        const bool touching =
            impulse > 0.0f || nearest <= (record.touching ? 2.0f : 1.0f) * touch_distance;
        if (touching != record.touching) set_touching(c.contact, touching);
        if (!record.hit_events || c.extra == 0) continue;
        const ContactExtra& extra = extras[c.extra - 1];
        float speed = 0.0f, total = 0.0f;
        V2 point;
        for (int k = 0; k < c.count; ++k) {
            total += extra.total[k];
            if (extra.greatest[k] > 0.0f && -extra.approach[k] > speed) {
                speed = -extra.approach[k];
                point = bodies[record.body_a].center + m.points[k].anchor_a;
            }
        }
        if (speed > settings.hit_threshold) {
            events.contact_hit.push_back({shape_id(record.shape_a), shape_id(record.shape_b),
                                          body_id(record.body_a), body_id(record.body_b),
                                          to_vec2(point), to_vec2(m.normal), speed, total});
        }
    }
}

}  // namespace fettle::physics::detail
