#include <contacts/contact_list.h>
#include <contacts/reports.h>
#include <state/limits.h>

#include <bit>
#include <cmath>

// If shapes request hit events, several threads examine every touching contact in every step. The
// events are then sorted into the order of the contacts.

namespace fettle::physics::detail {
namespace {

/// Number of words, of 64 contacts each, in a task of a thread.
constexpr size_t words_at_a_time = 8;

/// True for a contact with the border whose first anchor is not from the origin of the world, where
/// the body of the border is, but from the center of b: so it is precise far from the origin.
bool is_border(const ObjectState& objects, const ContactRecord& c) {
    return double_positions && objects.forms[c.shape_a].kind == FormKind::border;
}

/// A point of a manifold in the world, from its two anchors.
Position point_of(const ObjectState& objects, const ContactRecord& c, Vec2 anchor_a,
                  Vec2 anchor_b) {
    if (is_border(objects, c)) return objects.bodies[c.body_b].center + anchor_b;
    return objects.bodies[c.body_a].center + anchor_a;
}

/// True if a point of a touching contact touches, or is as near as the nearest one: shapes that
/// meet within a step were apart at its beginning.
bool meets(const Manifold& m, int k) {
    return m.points[k].normal_impulse > 0.0f ||
           m.points[k].separation <= max(nearest_separation(m), 0.0f) + touch_distance;
}

/// A velocity of a body, or a change of it.
struct Moving {
    Vec2 velocity;
    float turn = 0.0f;
};

/// How fast a approaches b along the normal at a point.
float closing(const ObjectState& objects, const ContactRecord& c, const Position& point,
              const Moving& a, const Moving& b) {
    const auto at_point = [&](uint32_t body, const Moving& moving) {
        return moving.velocity + cross(moving.turn, point - objects.bodies[body].center);
    };
    return dot(c.manifold.normal, at_point(c.body_a, a) - at_point(c.body_b, b));
}

/// The same with the velocities in the states. Until the poses are finished, these are the
/// velocities before the step.
float closing_before(const ObjectState& objects, const Columns& columns, const ContactRecord& c,
                     const Position& point) {
    const BodyState &a = columns.states[c.body_a], &b = columns.states[c.body_b];
    return closing(objects, c, point, {a.velocity, a.angular_velocity},
                   {b.velocity, b.angular_velocity});
}

}  // namespace

std::optional<ContactHitEvent> hit_of(const Touching& touching, float threshold, uint32_t contact,
                                      const ContactExtra* extra) {
    const ObjectState& objects = touching.objects;
    const Columns& columns = touching.columns;
    const ContactRecord& record = objects.contacts[contact];
    if (!record.hit_events || !record.touching) return {};
    // The solver may take two steps to end an approach; the second one is no hit of its own.
    if (objects.contact_links[contact].began + 1 == touching.step) return {};
    float speed = 0.0f;
    Position point;
    for (int k = 0; k < record.manifold.count; ++k) {
        const ManifoldPoint& p = record.manifold.points[k];
        const bool met =
            meets(record.manifold, k) || (extra != nullptr && extra->greatest[k] > 0.0f);
        const Position here = point_of(objects, record, p.anchor_a, p.anchor_b);
        const float approach = met ? meeting_speed(touching, record, here, p.separation) : 0.0f;
        if (approach <= speed) continue;
        speed = approach;
        point = here;
    }
    if (!(speed > threshold) || !reports_for_pair(objects, contact)) return {};
    const float impulse =
        extra != nullptr ? extra->total[0] + extra->total[1] : impact_impulse(touching, record);
    return ContactHitEvent{shape_id(objects, columns, record.shape_a),
                           shape_id(objects, columns, record.shape_b),
                           body_id(columns, record.body_a),
                           body_id(columns, record.body_b),
                           point,
                           record.manifold.normal,
                           speed,
                           impulse,
                           record.friction,
                           record.restitution,
                           objects.part_number(record.shape_a),
                           objects.part_number(record.shape_b),
                           objects.shapes[record.shape_a].surface.material,
                           objects.shapes[record.shape_b].surface.material};
}

void report_wide_hits(const Touching& touching, float threshold, ContactScratch& scratch,
                      ThreadPool* threads) {
    const ObjectState& objects = touching.objects;
    const std::vector<uint64_t>& reported = scratch.reported;
    const auto visit = [&](size_t begin, size_t end, auto&& act) {
        for (size_t word = begin; word < end; ++word) {
            for (uint64_t left = reported[word]; left != 0; left &= left - 1)
                act(scratch.acting[word * 64 + size_t(std::countr_zero(left))]);
        }
    };
    scratch.hits.resize((reported.size() + words_at_a_time - 1) / words_at_a_time);
    parallel_for(threads, reported.size(), words_at_a_time, [&](size_t begin, size_t end) {
        auto& found = scratch.hits[begin / words_at_a_time];
        found.clear();
        visit(begin, end, [&](const ActingContact& c) { objects.contacts[c.slot].prefetch(); });
        visit(begin, end, [&](const ActingContact& c) {
            if (!c.hit_events()) return;
            if (const auto hit = hit_of(touching, threshold, c.slot, nullptr))
                found.push_back(*hit);
        });
    });
    for (const auto& found : scratch.hits)
        touching.events.contact_hit.insert(touching.events.contact_hit.end(), found.begin(),
                                           found.end());
}

void report_persisting(const ObjectState& objects, const Columns& columns,
                       const ActiveLists& active, uint32_t step, int substeps, Events& events) {
    for (const uint32_t slot : active.awake_contacts) {
        const ContactRecord& c = objects.contacts[slot];
        if (!c.touching || !c.begin_reported || c.sensor ||
            objects.contact_links[slot].began == step || c.manifold.count == 0)
            continue;
        if (!reports_for_pair(objects, slot)) continue;
        const Position point = middle_of(objects, c);
        float impulse = 0.0f;
        for (int k = 0; k < c.manifold.count; ++k)
            impulse += c.manifold.points[k].normal_impulse * float(substeps);
        events.contact_persist.push_back(
            {shape_id(objects, columns, c.shape_a), shape_id(objects, columns, c.shape_b),
             body_id(columns, c.body_a), body_id(columns, c.body_b), point, c.manifold.normal,
             approach_speed(objects, columns, c, point), impulse, c.friction, c.restitution,
             objects.part_number(c.shape_a), objects.part_number(c.shape_b),
             objects.shapes[c.shape_a].surface.material,
             objects.shapes[c.shape_b].surface.material});
    }
}

Contact view_of(const ObjectState& objects, const Columns& columns, float substep,
                const ContactRecord& c) {
    Contact contact;
    contact.body_a = body_id(columns, c.body_a);
    contact.body_b = body_id(columns, c.body_b);
    contact.shape_a = shape_id(objects, columns, c.shape_a);
    contact.shape_b = shape_id(objects, columns, c.shape_b);
    contact.normal = c.manifold.normal;
    contact.point_count = c.manifold.count;
    contact.friction = c.friction;
    contact.restitution = c.restitution;
    contact.part_a = objects.part_number(c.shape_a);
    contact.part_b = objects.part_number(c.shape_b);
    contact.material_a = objects.shapes[c.shape_a].surface.material;
    contact.material_b = objects.shapes[c.shape_b].surface.material;
    // The velocity of the contact point on each body: on the ground, the point stays behind when a
    // body slides.
    const BodyRecord &a = objects.bodies[c.body_a], &b = objects.bodies[c.body_b];
    const bool a_moves = a.mobility != Mobility::fixed, b_moves = b.mobility != Mobility::fixed;
    const float share_a = a_moves == b_moves ? 0.5f : a_moves ? 1.0f : 0.0f;
    for (int k = 0; k < c.manifold.count; ++k) {
        const ManifoldPoint& p = c.manifold.points[k];
        const Position on_b = b.center + p.anchor_b;
        const Position on_a = is_border(objects, c) ? on_b : a.center + p.anchor_a;
        contact.points[size_t(k)] = {on_b + share_a * (on_a - on_b), p.separation, p.normal_impulse,
                                     p.tangent_impulse, uint16_t(p.feature)};
        if (substep > 0.0f) contact.normal_force += p.normal_impulse / substep;
    }
    return contact;
}

Position middle_of(const ObjectState& objects, const ContactRecord& c) {
    const ManifoldPoint* const points = c.manifold.points;
    if (c.manifold.count != 2) return point_of(objects, c, points[0].anchor_a, points[0].anchor_b);
    return point_of(objects, c, 0.5f * (points[0].anchor_a + points[1].anchor_a),
                    0.5f * (points[0].anchor_b + points[1].anchor_b));
}

float nearest_separation(const Manifold& m) {
    return m.count == 2 ? min(m.points[0].separation, m.points[1].separation)
                        : m.points[0].separation;
}

float approach_speed(const ObjectState& objects, const Columns& columns, const ContactRecord& c,
                     const Position& point) {
    return max(0.0f, closing_before(objects, columns, c, point));
}

float meeting_speed(const Touching& touching, const ContactRecord& c, const Position& point,
                    float separation) {
    const ObjectState& objects = touching.objects;
    const float before = closing_before(objects, touching.columns, c, point);
    if (!(touching.substep > 0.0f)) return max(0.0f, before);
    const SolverForce &a = touching.forces[objects.bodies[c.body_a].solver_index],
                      &b = touching.forces[objects.bodies[c.body_b].solver_index];
    const float acceleration =
        closing(objects, c, point, {a.change, a.turn_change}, {b.change, b.turn_change}) /
        touching.substep;
    // v² grows by twice the work of the acceleration; forces act for one step at most. Fast shapes
    // may have met within the last step: then the separation is negative, and the forces acted for
    // too long. A deeper overlap is older and does not count.
    const float way = separation > -before * touching.length ? separation : 0.0f;
    const float square = max(before * before + 2.0f * acceleration * way, 0.0f);
    const float later = max(0.0f, before + acceleration * touching.length);
    if (acceleration > 0.0f) return min(std::sqrt(square), later);
    return before > 0.0f ? max(std::sqrt(square), later) : 0.0f;
}

float impact_impulse(const Touching& touching, const ContactRecord& c) {
    const ObjectState& objects = touching.objects;
    const BodyRecord &a = objects.bodies[c.body_a], &b = objects.bodies[c.body_b];
    const Manifold& m = c.manifold;
    float lever_a[2] = {}, lever_b[2] = {}, speed[2] = {};
    int count = 0;
    for (int k = 0; k < m.count; ++k) {
        if (!meets(m, k)) continue;
        const Position point = point_of(objects, c, m.points[k].anchor_a, m.points[k].anchor_b);
        lever_a[count] = cross(point - a.center, m.normal);
        lever_b[count] = cross(point - b.center, m.normal);
        speed[count] = meeting_speed(touching, c, point, m.points[k].separation);
        count += speed[count] > 0.0f;
    }
    if (count == 0) return 0.0f;
    const auto response = [&](int i, int k) {
        return a.inverse_mass + b.inverse_mass + a.inverse_inertia * lever_a[i] * lever_a[k] +
               b.inverse_inertia * lever_b[i] * lever_b[k];
    };
    const auto alone = [&](int k) {
        return response(k, k) > 0.0f ? speed[k] / response(k, k) : 0.0f;
    };
    const float bounce =
        1.0f + (max(speed[0], speed[1]) > touching.restitution_threshold ? c.restitution : 0.0f);
    if (count == 1) return bounce * alone(0);
    // Both points stop together, if each of them pushes.
    const float k11 = response(0, 0), k22 = response(1, 1), k12 = response(0, 1);
    const float determinant = k11 * k22 - k12 * k12;
    const float first = k22 * speed[0] - k12 * speed[1], second = k11 * speed[1] - k12 * speed[0];
    if (determinant > 1e-4f * k11 * k22 && first >= 0.0f && second >= 0.0f)
        return bounce * (first + second) / determinant;
    return bounce * alone(speed[0] < speed[1] ? 1 : 0);
}

}  // namespace fettle::physics::detail
