#include <contacts/reports.h>
#include <schedule/serial_criteria.h>
#include <solver/contacts/serial_contacts.h>
#include <state/limits.h>

#include <bit>

namespace fettle::physics::detail {
namespace {

/// Number of contacts in a task of a thread.
constexpr size_t contacts_at_a_time = 64;

/// Flags of a prepared contact and of a stored one.
enum PreparedFlag : uint8_t { needs_extra = 1, passes = 2, rolls = 4 };
enum StoredFlag : uint8_t { touches = 1, is_changed = 2, may_hit = 4 };

/// d·(M_a⁻¹ + M_b⁻¹)·d; along a locked axis a body is infinitely heavy.
float inverse_along(const ContactConstraint& c, Vec2 d, const SolverBody& a, const SolverBody& b) {
    if (!c.anisotropic) return a.inverse_mass + b.inverse_mass;
    return c.inverse_along(d);
}

void prepare_point(const ManifoldPoint& m, const ContactConstraint& c, Vec2 t, const SolverBody& a,
                   const SolverBody& b, float impulse_ratio, ConstraintPoint& p) {
    const Vec2 n = c.normal;
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
    // Without resistance, nothing would change the impulse of the last step again.
    extra.rolling_impulse =
        record.rolling_resistance > 0.0f ? record.rolling_impulse * impulse_ratio : 0.0f;
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
    const Vec2 t = right_perp(m.normal);
    for (int k = 0; k < m.count; ++k) {
        prepare_point(m.points[k], c, t, a, b, impulse_ratio, c.points[k]);
    }
    if (m.count < 2) {
        // The second point has no mass, so solving it has no effect.
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

Vec2 inverse_masses(const BodyRecord& record, const SolverBody& body) {
    return {record.flags.locked_x ? 0.0f : body.inverse_mass,
            record.flags.locked_y ? 0.0f : body.inverse_mass};
}

/// Assigns an index in `extras` to each contact that needs one.
void assign_extras(SingleContacts& contacts) {
    contacts.extras.clear();
    uint32_t rolling = 0;
    for (size_t i = 0; i < contacts.flags.size(); ++i) {
        const uint8_t flag_bits = contacts.flags[i];
        contacts.constraints[i].extra = 0;
        if (flag_bits == 0) continue;
        ContactExtra& extra = contacts.extras.emplace_back();
        if ((flag_bits & rolls) != 0) extra.rolling = ++rolling;
        contacts.constraints[i].extra = uint32_t(contacts.extras.size());
    }
    contacts.rolling_contacts.resize(rolling);
}

/// True if a dynamic body of the contact is at a face of something else, too.
bool is_supported(const ObjectState& objects, uint32_t contact) {
    const auto is_beside_more = [&](uint32_t body) {
        if (objects.bodies[body].mobility != Mobility::dynamic) return false;
        return objects.any_contact(objects.bodies[body].lists.first_contact, none,
                                   [&](uint32_t other) {
                                       const ContactRecord& c = objects.contacts[other];
                                       return other != contact && !c.sensor &&
                                              c.manifold.count > 0 && c.manifold.corner == 0.0f;
                                   });
    };
    const ContactRecord& c = objects.contacts[contact];
    return is_beside_more(c.body_a) || is_beside_more(c.body_b);
}

void prepare_extra_of(size_t single, const ObjectState& objects, const Columns& columns,
                      std::span<const SolverBody> bodies, bool in_impact, SingleContacts& contacts,
                      float ratio) {
    const ContactConstraint& c = contacts.constraints[single];
    const ContactRecord& record = objects.contacts[c.contact];
    ContactExtra& extra = contacts.extras[c.extra - 1];
    prepare_extra(record, c, bodies[c.a], bodies[c.b], ratio, extra);
    extra.in_impact = in_impact;
    if ((contacts.flags[single] & passes) != 0) {
        extra.corner = corner_of(objects, record);
        // Only a bounce reads it, and the walk through the contacts takes long.
        extra.supported = in_impact && extra.restitution > 0.0f && is_supported(objects, c.contact);
    }
    if (extra.rolling == 0) return;
    const auto radius = [&](uint32_t shape, Vec2 normal) {
        return radius_of_curvature(solid_of(objects, columns, shape), normal);
    };
    contacts.rolling_contacts[extra.rolling - 1] = {c, radius(record.shape_a, c.normal),
                                                    radius(record.shape_b, -c.normal)};
}

/// Stores the impulses of a constraint in its contact; returns its flags, `StoredFlag`.
uint8_t store_constraint(const ContactConstraint& c, std::span<const ContactExtra> extras,
                         ContactRecord& record) {
    // A bounce takes less than one step, and the shapes are apart before and after it. An impulse
    // in one of the sub-steps shows that they touched.
    bool pushed = c.pushed;
    if (c.extra != 0) {
        const ContactExtra& extra = extras[c.extra - 1];
        record.rolling_impulse = bounded(extra.rolling_impulse, greatest_impulse);
        pushed = extra.greatest[0] + extra.greatest[1] > 0.0f;
    }
    float nearest = infinity;
    for (int k = 0; k < record.manifold.count; ++k) {
        ManifoldPoint& point = record.manifold.points[k];
        // An overflow would never disappear, because the next step begins with this impulse.
        point.normal_impulse = bounded(c.points[k].normal_impulse, greatest_impulse);
        point.tangent_impulse = bounded(c.points[k].tangent_impulse, greatest_impulse);
        pushed |= point.normal_impulse > 0.0f;
        nearest = min(nearest, point.separation);
    }
    // A touch ends only at twice the distance, so that it does not begin and end repeatedly at the
    // limit.
    const bool touching = pushed || nearest <= (record.touching ? 2.0f : 1.0f) * touch_distance;
    return uint8_t((touching ? touches : 0) | (touching != record.touching ? is_changed : 0) |
                   (record.hit_events ? may_hit : 0));
}

void prepare(const ObjectState& objects, const Columns& columns, const BodyScratch& bodies,
             std::span<const ActingContact> acting, SingleContacts& contacts,
             const ContactStiffness& stiffness, float dt, float ratio, ThreadPool* threads) {
    const size_t count = contacts.acting.size();
    contacts.constraints.resize(count);
    contacts.flags.resize(count);
    contacts.relaxed.assign(count, Relaxed::left_out);
    parallel_for(threads, count, contacts_at_a_time, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
            const uint32_t slot = acting[contacts.acting[i]].slot;
            const ContactRecord& record = objects.contacts[slot];
            ContactConstraint& c = contacts.constraints[i];
            c.contact = slot;
            c.a = bodies.solver_ends[record.body_a].index();
            c.b = bodies.solver_ends[record.body_b].index();
            const SolverBody &a = bodies.solver_bodies[c.a], &b = bodies.solver_bodies[c.b];
            c.inverse_a = {a.inverse_mass, a.inverse_mass};
            c.inverse_b = {b.inverse_mass, b.inverse_mass};
            c.anisotropic = on_locked_axis(objects, bodies, record);
            if (c.anisotropic) {
                c.inverse_a = inverse_masses(objects.bodies[record.body_a], a);
                c.inverse_b = inverse_masses(objects.bodies[record.body_b], b);
            }
            prepare_constraint(record, a, b, ratio, c);
            c.pushed = false;
            c.soft = stiffness.of(c.fixed, c.points[0].normal_impulse + c.points[1].normal_impulse,
                                  max(a.inverse_mass, b.inverse_mass),
                                  min(gyration_of(a), gyration_of(b)));
            const bool corner = !record.curved && passes_corner(objects, bodies, record, dt);
            contacts.flags[i] = uint8_t(
                (record.special || acting[contacts.acting[i]].takes_impacts() ? needs_extra : 0) |
                (corner ? needs_extra | passes : 0) | (record.curved ? needs_extra | rolls : 0));
        }
    });
    assign_extras(contacts);
    parallel_for(threads, count, contacts_at_a_time, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i)
            if (contacts.constraints[i].extra != 0)
                prepare_extra_of(i, objects, columns, bodies.solver_bodies,
                                 acting[contacts.acting[i]].takes_impacts(), contacts, ratio);
    });
}

void store_serial(SingleContacts& contacts, const Touching& touching, float hit_threshold,
                  ThreadPool* threads) {
    const std::vector<ContactConstraint>& constraints = contacts.constraints;
    std::vector<uint8_t>& flags = contacts.flags;
    ObjectState& objects = touching.objects;
    parallel_for(threads, constraints.size(), contacts_at_a_time, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i)
            flags[i] = store_constraint(constraints[i], contacts.extras,
                                        objects.contacts[constraints[i].contact]);
    });
    for (size_t i = 0; i < constraints.size(); ++i) {
        const ContactConstraint& c = constraints[i];
        if ((flags[i] & is_changed) != 0)
            set_touching(touching, c.contact, (flags[i] & touches) != 0);
        if ((flags[i] & may_hit) == 0) continue;
        const ContactExtra* const extra = c.extra != 0 ? &contacts.extras[c.extra - 1] : nullptr;
        const auto hit = hit_of(touching, hit_threshold, c.contact, extra);
        if (hit) touching.events.contact_hit.push_back(*hit);
    }
}

/// Contacts that passed an impact on have touched, even if they are apart after the step.
void mark_passed_impacts(ContactScratch& scratch) {
    for (const ContactConstraint& constraint : scratch.passing.constraints) {
        const ContactExtra& extra = scratch.passing.extras[constraint.extra - 1];
        if (!(extra.greatest[0] + extra.greatest[1] > 0.0f)) continue;
        const size_t index = size_t(&constraint - scratch.passing.constraints.data());
        const ActingContact& c = scratch.acting[scratch.passing.acting[index]];
        const auto lane = uint16_t(1u << c.place % group_size);
        GroupResult& result = scratch.group_results[c.place / group_size];
        result.touches |= lane;
        result.reported |= lane;
    }
}

/// Reports touches of wide contacts that begin or end, in the order of the acting contacts instead
/// of the colors.
void report_wide(ContactScratch& scratch, const Touching& touching, float hit_threshold,
                 ThreadPool* threads) {
    const std::vector<GroupResult>& results = scratch.group_results;
    std::vector<uint64_t>& reported = scratch.reported;
    reported.assign((scratch.acting.size() + 63) / 64, 0);
    for (size_t group = 0; group < results.size(); ++group) {
        for (uint32_t left = results[group].reported; left != 0; left &= left - 1) {
            const uint32_t i =
                scratch.lane_contacts[group * group_size + size_t(std::countr_zero(left))];
            reported[i / 64] |= uint64_t{1} << i % 64;
        }
    }
    bool any_hits = false;
    for (size_t word = 0; word < reported.size(); ++word) {
        for (uint64_t left = reported[word]; left != 0; left &= left - 1) {
            const ActingContact& c = scratch.acting[word * 64 + size_t(std::countr_zero(left))];
            const bool touches =
                (results[c.place / group_size].touches >> c.place % group_size & 1) != 0;
            if (touches != c.touching()) set_touching(touching, c.slot, touches);
            any_hits |= c.hit_events();
        }
    }
    if (any_hits) report_wide_hits(touching, hit_threshold, scratch, threads);
}

}  // namespace

void prepare_serial(const ObjectState& objects, const Columns& columns, const BodyScratch& bodies,
                    ContactScratch& scratch, const ContactStiffness& stiffness, float dt,
                    float ratio, ThreadPool* threads) {
    for (SingleContacts* const contacts : {&scratch.serial, &scratch.passing})
        prepare(objects, columns, bodies, scratch.acting, *contacts, stiffness, dt, ratio, threads);
}

void store_contacts(ContactScratch& contacts, const Touching& touching, float hit_threshold,
                    ThreadPool* threads) {
    mark_passed_impacts(contacts);
    report_wide(contacts, touching, hit_threshold, threads);
    store_serial(contacts.serial, touching, hit_threshold, threads);
}

}  // namespace fettle::physics::detail
