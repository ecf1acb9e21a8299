#include <world/world_data.h>

#include <bit>

// Between the records and the solver: constraints are written once a step in the order of the awake
// contacts, and their impulses are read back.

namespace fettle::physics::detail {
namespace {

float inverse_or_zero(float k) {
    return k > 0.0f ? 1.0f / k : 0.0f;
}

/// d·(M_a⁻¹ + M_b⁻¹)·d: along a locked axis a body is infinitely heavy.
float inverse_along(const ContactConstraint& c, V2 d, const SolverBody& a, const SolverBody& b) {
    if (!c.anisotropic) return a.inverse_mass + b.inverse_mass;
    return d.x * d.x * (c.inverse_a.x + c.inverse_b.x) +
           d.y * d.y * (c.inverse_a.y + c.inverse_b.y);
}

void prepare_point(const ManifoldPoint& m, const ContactConstraint& c, V2 t, const SolverBody& a,
                   const SolverBody& b, float impulse_ratio, ConstraintPoint& p) {
    const V2 n = c.normal;
    p.normal_lever_a = cross(m.anchor_a, n);
    p.normal_lever_b = cross(m.anchor_b, n);
    p.tangent_lever_a = cross(m.anchor_a, t);
    p.tangent_lever_b = cross(m.anchor_b, t);
    p.separation = m.separation;
    const float k_n = inverse_along(c, n, a, b), k_t = inverse_along(c, t, a, b);
    p.normal_mass = inverse_or_zero(k_n + a.inverse_inertia * p.normal_lever_a * p.normal_lever_a +
                                    b.inverse_inertia * p.normal_lever_b * p.normal_lever_b);
    p.tangent_mass =
        inverse_or_zero(k_t + a.inverse_inertia * p.tangent_lever_a * p.tangent_lever_a +
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

void prepare_constraint(const ContactRecord& record, const SolverBody& a, const SolverBody& b,
                        float impulse_ratio, ContactConstraint& c) {
    const Manifold& m = record.manifold;
    c.normal = m.normal;
    c.friction = record.friction;
    c.count = uint16_t(m.count);
    c.fixed = uint16_t(a.inverse_mass == 0.0f || b.inverse_mass == 0.0f);
    c.extra = 0;
    const V2 t = right_perp(m.normal);
    for (int k = 0; k < m.count; ++k) {
        prepare_point(m.points[k], c, t, a, b, impulse_ratio, c.points[k]);
    }
    if (m.count < 2) {
        // A second point of no mass: whoever solves both alike adds nothing for it.
        c.points[1] = {};
        c.coupling_normal = c.coupling_tangent = 0.0f;
        return;
    }
    const ConstraintPoint &p = c.points[0], &q = c.points[1];
    c.coupling_normal = inverse_along(c, m.normal, a, b) +
                        a.inverse_inertia * p.normal_lever_a * q.normal_lever_a +
                        b.inverse_inertia * p.normal_lever_b * q.normal_lever_b;
    c.coupling_tangent = inverse_along(c, t, a, b) +
                         a.inverse_inertia * p.tangent_lever_a * q.tangent_lever_a +
                         b.inverse_inertia * p.tangent_lever_b * q.tangent_lever_b;
}

/// The cores are half a radius and a bit away from the anchors, along the normal.
Corner corner_of(const ContactRecord& record, const ShapeForm& form_a, const ShapeForm& form_b) {
    const Manifold& m = record.manifold;
    const ManifoldPoint& point = m.points[0];
    const V2 t = right_perp(m.normal);
    const float half_gap = 0.5f * point.separation;
    return {m.corner, cross(point.anchor_a, t) + form_a.radius + half_gap,
            cross(point.anchor_b, t) - form_b.radius - half_gap};
}

V2 inverse_masses(const BodyRecord& record, const SolverBody& body) {
    return {record.locked_x ? 0.0f : body.inverse_mass, record.locked_y ? 0.0f : body.inverse_mass};
}

/// A path that bends by less in a step is straight, m.
constexpr float negligible_bend = 5e-5f;

}  // namespace

/// Passing a corner so fast that the bend of the way shows within the step. Two circles do without:
/// they meet in piles, where all move slowly. So do bare corners: they have no way round.
bool WorldData::passes_corner(const ContactRecord& record, float dt) const {
    const Manifold& m = record.manifold;
    if (m.corner == 0.0f) return false;
    const ShapeForm &form_a = forms[record.shape_a], &form_b = forms[record.shape_b];
    if (form_a.count == 1 && form_b.count == 1) return false;
    if (form_a.radius + form_b.radius == 0.0f) return false;
    const Corner corner = corner_of(record, form_a, form_b);
    const SolverBody& a = solver_bodies[solver_ends[record.body_a].index()];
    const SolverBody& b = solver_bodies[solver_ends[record.body_b].index()];
    const float u =
        dt * (dot(right_perp(m.normal), b.velocity - a.velocity) +
              corner.lever_b * b.angular_velocity - corner.lever_a * a.angular_velocity);
    return u * u > 2.0f * corner.distance * negligible_bend;
}

/// Of a body that is locked along one axis. Most worlds have none: their records are not touched.
bool WorldData::on_locked_axis(const ContactRecord& contact) const {
    if (!axes_locked) return false;
    const BodyRecord &a = bodies[contact.body_a], &b = bodies[contact.body_b];
    return a.locked_x || a.locked_y || b.locked_x || b.locked_y;
}

void WorldData::prepare_contacts(float dt, float h, const ContactStiffness& stiffness) {
    find_acting(dt);
    color_contacts();
    const float ratio = last_substep > 0.0f ? h / last_substep : 1.0f;
    auto prepare = [&](uint32_t slot, ContactConstraint& c) {
        const ContactRecord& record = contacts[slot];
        c.contact = slot;
        c.a = solver_ends[record.body_a].index();
        c.b = solver_ends[record.body_b].index();
        const SolverBody &a = solver_bodies[c.a], &b = solver_bodies[c.b];
        c.inverse_a = {a.inverse_mass, a.inverse_mass};
        c.inverse_b = {b.inverse_mass, b.inverse_mass};
        c.anisotropic = on_locked_axis(record);
        if (c.anisotropic) {
            c.inverse_a = inverse_masses(bodies[record.body_a], a);
            c.inverse_b = inverse_masses(bodies[record.body_b], b);
        }
        prepare_constraint(record, a, b, ratio, c);
        c.soft = stiffness.of(c.fixed, c.points[0].normal_impulse + c.points[1].normal_impulse,
                              max(a.inverse_mass, b.inverse_mass));
    };
    constraints.clear();
    extras.clear();
    rolling_contacts.clear();
    for (uint32_t slot : serial_contacts) {
        ContactConstraint& serial = constraints.emplace_back();
        prepare(slot, serial);
        const ContactRecord& record = contacts[slot];
        const bool corner = !record.curved && passes_corner(record, dt);
        if (!record.special && !record.curved && !corner) continue;
        ContactExtra& extra = extras.emplace_back();
        prepare_extra(record, serial, solver_bodies[serial.a], solver_bodies[serial.b], ratio,
                      extra);
        if (corner) extra.corner = corner_of(record, forms[record.shape_a], forms[record.shape_b]);
        if (record.curved) {
            const V2 n = serial.normal;
            rolling_contacts.emplace_back(serial, bend_of(solid(record.shape_a), n),
                                          bend_of(solid(record.shape_b), -n));
            extra.rolling = uint32_t(rolling_contacts.size());
        }
        serial.extra = uint32_t(extras.size());
    }
}

/// What came of the wide contacts is told in the order of the records, not of the colors.
void WorldData::tell_of_groups() {
    told.assign((acting.size() + 63) / 64, 0);
    for (size_t group = 0; group < news.size(); ++group) {
        for (uint32_t left = news[group].told; left != 0; left &= left - 1) {
            const uint32_t i = lane_contacts[group * lanes + size_t(std::countr_zero(left))];
            told[i / 64] |= uint64_t{1} << i % 64;
        }
    }
    bool any_hits = false;
    for (size_t word = 0; word < told.size(); ++word) {
        for (uint64_t left = told[word]; left != 0; left &= left - 1) {
            const ActingContact& c = acting[word * 64 + size_t(std::countr_zero(left))];
            const bool touching = (news[c.place / lanes].touches >> c.place % lanes & 1) != 0;
            if (touching != c.touching) set_touching(c.slot, touching);
            any_hits |= c.hit_events;
        }
    }
    if (any_hits) tell_hits();
}

void WorldData::store_contacts() {
    tell_of_groups();
    for (const ContactConstraint& c : constraints) {
        Manifold& m = contacts[c.contact].manifold;
        for (int k = 0; k < m.count; ++k) {
            m.points[k].normal_impulse = c.points[k].normal_impulse;
            m.points[k].tangent_impulse = c.points[k].tangent_impulse;
        }
        if (c.extra == 0) {
            update_touch(c.contact, false);
            if (const auto hit = hit_of(c.contact, nullptr)) events.contact_hit.push_back(*hit);
            continue;
        }
        const ContactExtra& extra = extras[c.extra - 1];
        contacts[c.contact].rolling_impulse = extra.rolling_impulse;
        update_touch(c.contact, extra.greatest[0] + extra.greatest[1] > 0.0f);
        if (const auto hit = hit_of(c.contact, &extra)) events.contact_hit.push_back(*hit);
    }
}

/// `pushed`: an impulse flowed in some sub-step, even if none is left.
void WorldData::update_touch(uint32_t contact, bool pushed) {
    ContactRecord& record = contacts[contact];
    float nearest = infinity;
    for (int k = 0; k < record.manifold.count; ++k) {
        const ManifoldPoint& point = record.manifold.points[k];
        pushed |= point.normal_impulse > 0.0f;
        nearest = min(nearest, point.separation);
    }
    // A bounce is over within one step and never looks near: its impulse tells. Twice the distance
    // ends a touch, so that nothing flickers at the limit.
    const bool touching = pushed || nearest <= (record.touching ? 2.0f : 1.0f) * touch_distance;
    if (touching != record.touching) set_touching(contact, touching);
}

}  // namespace fettle::physics::detail
