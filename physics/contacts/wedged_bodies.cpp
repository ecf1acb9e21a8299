#include <contacts/wedged_bodies.h>

namespace fettle::physics::detail {
namespace {

/// Bodies are wedged if two opposing overlaps add up to this part of the smaller width. A pin that
/// is a little too wide for its slot stays in it.
constexpr float wedged_share = 0.5f;
/// The maximum of the cosine of the angle between the normals of two opposing contacts.
constexpr float opposed = -0.5f;

float overlap_of(const Manifold& m) {
    const float first = m.points[0].separation;
    return -(m.count == 2 ? min(first, m.points[1].separation) : first);
}

/// The normal towards `body`.
Vec2 push_on(uint32_t body, const ContactRecord& c) {
    return body == c.body_b ? c.manifold.normal : -c.manifold.normal;
}

}  // namespace

void part_wedged(const Touching& touching, uint32_t contact) {
    ObjectState& objects = touching.objects;
    ContactRecord& c = objects.contacts[contact];
    const BodyRecord &a = objects.bodies[c.body_a], &b = objects.bodies[c.body_b];
    if (c.skipped == Skipped::wedged) c.skipped = Skipped::no;
    if (!c.acts() || a.mobility != Mobility::dynamic || b.mobility != Mobility::dynamic) return;
    const bool a_has_fewer = a.lists.contact_count < b.lists.contact_count;
    const uint32_t body = a_has_fewer ? c.body_a : c.body_b;
    const uint32_t other = a_has_fewer ? c.body_b : c.body_a;
    const Vec2 push = push_on(body, c);
    const float depth = overlap_of(c.manifold);
    const float least = wedged_share * 2.0f * min(a.thickness, b.thickness);
    uint32_t skipped = none;
    objects.any_contact(objects.bodies[body].lists.first_contact, none, [&](uint32_t i) {
        ContactRecord& opposing = objects.contacts[i];
        if (i == contact || !opposing.acts() || objects.other_body(i, body) != other ||
            dot(push_on(body, opposing), push) > opposed)
            return false;
        const float opposing_depth = overlap_of(opposing.manifold);
        if (!(opposing_depth > 0.0f && depth + opposing_depth > least)) return false;
        // They balanced each other.
        c.clear_impulses();
        opposing.clear_impulses();
        skipped = opposing_depth > depth ? i : contact;
        return true;
    });
    if (skipped != none) skip_contact(touching, skipped, Skipped::wedged);
}

}  // namespace fettle::physics::detail
