#include <contacts/overlaps/overlaps.h>
#include <contacts/overlaps/wedged_bodies.h>
#include <state/joint_kind.h>
#include <state/limits.h>

#include <algorithm>

namespace fettle::physics::detail {
namespace {

/// Bodies are wedged if two opposing overlaps add up to this part of the smaller width. A pin that
/// is a little too wide for its slot stays in it.
constexpr float wedged_share = 0.5f, welded_share = 0.25f;
/// And to this part of the smaller extent: the spikes of stars in a heap are thin and hook into
/// each other.
constexpr float extent_share = 0.25f;
/// Joints have priority over contacts in which the overlap is more than this part of the smaller
/// width. No load presses bodies together that much.
constexpr float held_share = 0.125f;
/// And they are listed as pressed together from this part on.
constexpr float listed_share = 0.05f;
/// The maximum of the cosine of the angle between the normals of two opposing contacts.
constexpr float opposed = -0.5f;
/// Maximum number of bodies through which welds are followed.
constexpr size_t most_welded = 16;

/// True if rigid welds join two bodies, directly or through others.
bool are_welded(const ObjectState& objects, uint32_t a, uint32_t b) {
    if (objects.bodies[b].lists.first_joint == none) return false;
    uint32_t group[most_welded] = {a};
    size_t count = 1;
    bool found = false;
    for (size_t i = 0; i < count && !found; ++i) {
        objects.for_each_joint(group[i], [&](uint32_t slot, uint32_t side) {
            const JointRecord& joint = objects.joints[slot];
            const uint32_t next = joint.bodies[1 - side];
            if (joint.type != JointType::weld || !joint.acts() ||
                !joint_kind(joint.type).holds(joint) || next == 0)
                return;
            found = found || next == b;
            if (count < most_welded && std::find(group, group + count, next) == group + count)
                group[count++] = next;
        });
    }
    return found;
}

/// True if the shape is all of its body: the body has no others, and the shape has no parts.
bool is_whole_body(const ObjectState& objects, uint32_t shape) {
    const BodyLists& lists = objects.bodies[objects.forms[shape].body].lists;
    return lists.first_shape == shape && lists.last_shape == shape;
}

/// The contact that opposes `contact`, of a body and the other one or what is welded to it.
uint32_t opposing_contact(const ObjectState& objects, uint32_t contact, uint32_t body) {
    const ContactRecord& c = objects.contacts[contact];
    const uint32_t other = objects.other_body(contact, body);
    // Most bodies have one shape. Two of them have no other contact with each other.
    if (objects.bodies[other].lists.first_joint == none && is_whole_body(objects, c.shape_a) &&
        is_whole_body(objects, c.shape_b))
        return none;
    const Vec2 push = normal_towards(body, c);
    const float depth = overlap_of(c.manifold);
    const float width = min(objects.bodies[body].thickness, objects.bodies[other].thickness);
    const float extent = min(objects.bodies[body].extent, objects.bodies[other].extent);
    uint32_t found = none;
    objects.any_contact(objects.bodies[body].lists.first_contact, none, [&](uint32_t i) {
        const ContactRecord& opposing = objects.contacts[i];
        if (i == contact || !opposing.acts() || dot(normal_towards(body, opposing), push) > opposed)
            return false;
        const uint32_t third = objects.other_body(i, body);
        const float opposing_depth = overlap_of(opposing.manifold);
        const bool same = third == other;
        const float share = same ? wedged_share : welded_share;
        const float least = max(share * 2.0f * min(width, objects.bodies[third].thickness),
                                same ? extent_share * extent : 0.0f);
        const float touches = same ? 0.0f : -touch_distance;
        if (!(opposing_depth > touches && depth + opposing_depth > least)) return false;
        if (third != other && !are_welded(objects, third, other)) return false;
        found = i;
        return true;
    });
    return found;
}

/// True if the overlap is more than this part of the smaller width.
bool is_deep(const ObjectState& objects, const ContactRecord& c, float share) {
    const BodyRecord &a = objects.bodies[c.body_a], &b = objects.bodies[c.body_b];
    return overlap_of(c.manifold) > share * 2.0f * min(a.thickness, b.thickness);
}

/// True if a rigid joint connects the body with one that is not dynamic, or with the world.
bool is_held(const ObjectState& objects, uint32_t body) {
    bool held = false;
    objects.for_each_joint(body, [&](uint32_t slot, uint32_t side) {
        const JointRecord& joint = objects.joints[slot];
        const auto holds = joint_kind(joint.type).holds;
        held = held || (joint.acts() && holds != nullptr && holds(joint) &&
                        objects.bodies[joint.bodies[1 - side]].mobility != Mobility::dynamic);
    });
    return held;
}

}  // namespace

bool is_pressed(const ObjectState& objects, const ContactRecord& c) {
    const BodyRecord &a = objects.bodies[c.body_a], &b = objects.bodies[c.body_b];
    return a.mobility == Mobility::dynamic && b.mobility == Mobility::dynamic &&
           is_deep(objects, c, listed_share);
}

bool is_pinned(const ObjectState& objects, const ContactRecord& c) {
    const BodyRecord &a = objects.bodies[c.body_a], &b = objects.bodies[c.body_b];
    return c.acts() && a.mobility == Mobility::dynamic && b.mobility == Mobility::dynamic &&
           is_deep(objects, c, held_share) && is_held(objects, c.body_a) &&
           is_held(objects, c.body_b);
}

void part_wedged(const Touching& touching, uint32_t contact) {
    ObjectState& objects = touching.objects;
    ContactRecord& c = objects.contacts[contact];
    if (c.skipped == Skipped::wedged) c.skipped = Skipped::no;
    const BodyRecord &a = objects.bodies[c.body_a], &b = objects.bodies[c.body_b];
    if (!c.acts() || a.mobility != Mobility::dynamic || b.mobility != Mobility::dynamic) return;
    const bool jointed = a.lists.first_joint != none && b.lists.first_joint != none;
    if (jointed && is_deep(objects, c, held_share) && are_welded(objects, c.body_a, c.body_b)) {
        skip_contact(touching, contact, Skipped::wedged);
        return;
    }
    // Contacts with what is welded to the other body are in one of the two lists only.
    const bool a_has_fewer = a.lists.contact_count < b.lists.contact_count;
    const uint32_t bodies[] = {a_has_fewer ? c.body_a : c.body_b,
                               a_has_fewer ? c.body_b : c.body_a};
    uint32_t opposing = opposing_contact(objects, contact, bodies[0]);
    if (opposing == none && (a.lists.first_joint != none || b.lists.first_joint != none))
        opposing = opposing_contact(objects, contact, bodies[1]);
    if (opposing == none) return;
    // They balanced each other.
    ContactRecord& o = objects.contacts[opposing];
    c.clear_impulses();
    o.clear_impulses();
    const bool deeper = overlap_of(c.manifold) < overlap_of(o.manifold);
    skip_contact(touching, deeper ? opposing : contact, Skipped::wedged);
}

}  // namespace fettle::physics::detail
