#include <world/world_data.h>

// Contacts that are solved one at a time: where a body is locked along an axis, where surfaces
// roll, bounce, move or bend, and what found no color. Constraints are written once a step in the
// order of the nodes they belong to, and their impulses are read back.

namespace fettle::physics::detail {
namespace {

/// Contacts that a thread takes at a time.
constexpr size_t contacts_at_a_time = 64;

/// What is known of one when it is prepared, and when it is stored.
enum PreparedNote : uint8_t { needs_extra = 1, passes = 2, rolls = 4 };
enum StoredNote : uint8_t { touches = 1, is_news = 2, may_hit = 4 };

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

V2 inverse_masses(const BodyRecord& record, const SolverBody& body) {
    return {record.locked_x ? 0.0f : body.inverse_mass, record.locked_y ? 0.0f : body.inverse_mass};
}

}  // namespace

/// What is solved one at a time, in the order of the nodes.
void WorldData::list_serial() {
    serial_acting.clear();
    serial_nodes.clear();
    for (const ActingPiece& piece : acting_pieces) {
        if (piece.serially == 0) continue;
        for (uint32_t i = piece.begin; i < piece.end(); ++i) {
            if (!acting[i].serially) continue;
            serial_acting.push_back(i);
            serial_nodes.count(acting[i].node);
        }
    }
    serial_nodes.sum_up();
    auto next = serial_nodes.places();
    serial_contacts.resize(serial_acting.size());
    for (const uint32_t i : serial_acting) serial_contacts[next[acting[i].node]++] = acting[i].slot;
}

void WorldData::prepare_serial(float dt, float ratio, const ContactStiffness& stiffness) {
    const size_t count = serial_contacts.size();
    constraints.resize(count);
    serial_notes.resize(count);
    share_out_range(threads, count, contacts_at_a_time, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
            const ContactRecord& record = contacts[serial_contacts[i]];
            ContactConstraint& c = constraints[i];
            c.contact = serial_contacts[i];
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
            const bool corner = !record.curved && passes_corner(record, dt);
            serial_notes[i] =
                uint8_t((record.special ? needs_extra : 0) | (corner ? needs_extra | passes : 0) |
                        (record.curved ? needs_extra | rolls : 0));
        }
    });
    give_extras();
    share_out_range(threads, count, contacts_at_a_time, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i)
            if (constraints[i].extra != 0) prepare_extra_of(i, ratio);
    });
}

/// A place for what only special contacts need, one after the other.
void WorldData::give_extras() {
    extras.clear();
    uint32_t rolling = 0;
    for (size_t i = 0; i < serial_notes.size(); ++i) {
        constraints[i].extra = 0;
        if (serial_notes[i] == 0) continue;
        ContactExtra& extra = extras.emplace_back();
        if ((serial_notes[i] & rolls) != 0) extra.rolling = ++rolling;
        constraints[i].extra = uint32_t(extras.size());
    }
    rolling_contacts.resize(rolling);
}

void WorldData::prepare_extra_of(size_t serial, float ratio) {
    const ContactConstraint& c = constraints[serial];
    const ContactRecord& record = contacts[c.contact];
    ContactExtra& extra = extras[c.extra - 1];
    prepare_extra(record, c, solver_bodies[c.a], solver_bodies[c.b], ratio, extra);
    if ((serial_notes[serial] & passes) != 0) extra.corner = corner_of(record);
    if (extra.rolling == 0) return;
    rolling_contacts[extra.rolling - 1] = {c, bend_of(solid(record.shape_a), c.normal),
                                           bend_of(solid(record.shape_b), -c.normal)};
}

void WorldData::store_serial() {
    share_out_range(threads, constraints.size(), contacts_at_a_time, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) serial_notes[i] = store_constraint(constraints[i]);
    });
    for (size_t i = 0; i < constraints.size(); ++i) {
        const ContactConstraint& c = constraints[i];
        const uint8_t note = serial_notes[i];
        if ((note & is_news) != 0) set_touching(c.contact, (note & touches) != 0);
        if ((note & may_hit) == 0) continue;
        const ContactExtra* const extra = c.extra != 0 ? &extras[c.extra - 1] : nullptr;
        if (const auto hit = hit_of(c.contact, extra)) events.contact_hit.push_back(*hit);
    }
}

uint8_t WorldData::store_constraint(const ContactConstraint& c) {
    ContactRecord& record = contacts[c.contact];
    // A bounce is over within one step and never looks near: its impulse, in some sub-step, tells.
    bool pushed = false;
    if (c.extra != 0) {
        const ContactExtra& extra = extras[c.extra - 1];
        record.rolling_impulse = bounded(extra.rolling_impulse, greatest_impulse);
        pushed = extra.greatest[0] + extra.greatest[1] > 0.0f;
    }
    float nearest = infinity;
    for (int k = 0; k < record.manifold.count; ++k) {
        ManifoldPoint& point = record.manifold.points[k];
        // What overflowed would begin the next step, and so last for ever.
        point.normal_impulse = bounded(c.points[k].normal_impulse, greatest_impulse);
        point.tangent_impulse = bounded(c.points[k].tangent_impulse, greatest_impulse);
        pushed |= point.normal_impulse > 0.0f;
        nearest = min(nearest, point.separation);
    }
    // Twice the distance ends a touch, so that nothing flickers at the limit.
    const bool touching = pushed || nearest <= (record.touching ? 2.0f : 1.0f) * touch_distance;
    return uint8_t((touching ? touches : 0) | (touching != record.touching ? is_news : 0) |
                   (record.hit_events ? may_hit : 0));
}

}  // namespace fettle::physics::detail
