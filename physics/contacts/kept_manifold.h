#pragma once

#include <state/limits.h>
#include <state/world_state.h>

// A manifold is kept while its bodies move little. Only its separations follow the bodies, to first
// order, as they do within a step (constraints/contact_constraint.h).
//
// This does not only save time. A contact gives way under load, so a tall stack is an elastic
// column. If the lever arms follow each lean of a box, the weight above acts on the leaning column
// as on any slender one: from about 22 boxes on (their weight times the cube of their number
// against the stiffness of a contact) it buckles, however small the first lean is. With the lever
// arms and normals of the manifold's making, the weight does not add to the lean, so the column
// stands.

namespace fettle::physics::detail {

/// A manifold is kept while neither body has turned by more than this (rad), and its points have
/// slipped, and approached or separated, by less than these parts of the distance between them.
/// So a body on a plank that tilts starts to slide at most three degrees late. A slender body would
/// be near its tipping angle before that: so the rotation may move its center of mass to the side
/// by less than `kept_lean` of that distance, too.
inline constexpr float kept_turn = 0.05f, kept_slip = 0.02f, kept_gap = 0.1f, kept_lean = 0.1f;

/// Two bodies that turn faster soon need a new manifold anyway, rad per step.
inline constexpr float slow_turn = 0.004f;

inline bool may_keep(const ObjectState& objects, const ContactRecord& c) {
    return std::fabs(objects.forms[c.shape_a].turn) + std::fabs(objects.forms[c.shape_b].turn) <=
           slow_turn;
}

/// True if the body is kinematic and turns. The lever arm on it would lag behind, by meters for
/// a large platform: a body on it would be moved along a tangent, and so outwards.
inline bool is_turning_kinematic(const ObjectState& objects, uint32_t shape, uint32_t body) {
    return objects.forms[shape].turn != 0.0f &&
           objects.bodies[body].mobility == Mobility::kinematic;
}

/// False for the border in double precision: the anchor on it is not from the center of a body.
inline bool has_both_anchors(const ObjectState& objects, const ContactRecord& c) {
    return !double_positions || objects.forms[c.shape_a].kind != FormKind::border;
}

/// Decides whether the new manifold may be kept, and stores the pose for which it was computed.
/// Only a manifold with two points is kept: two edges have no third point that could come into
/// contact meanwhile.
inline void keep_manifold(ObjectState& objects, uint32_t slot) {
    ContactRecord& c = objects.contacts[slot];
    c.kept = c.manifold.count == 2 && !c.sensor && has_both_anchors(objects, c);
    if (c.kept && objects.kinematic_bodies > 0)
        c.kept = !is_turning_kinematic(objects, c.shape_a, c.body_a) &&
                 !is_turning_kinematic(objects, c.shape_b, c.body_b);
    if (!c.kept) return;

    objects.manifold_poses[slot] = {
        objects.forms[c.shape_a].angle,
        objects.forms[c.shape_b].angle,
        {c.manifold.points[0].separation, c.manifold.points[1].separation}};
}

/// Moves the separations with the bodies. False if the manifold must be computed anew.
inline bool follow_bodies(const ObjectState& objects, uint32_t slot, ContactRecord& c) {
    if (!may_keep(objects, c)) return false;
    const ManifoldPose& pose = objects.manifold_poses[slot];
    const ShapeForm &a = objects.forms[c.shape_a], &b = objects.forms[c.shape_b];
    const float turn_a = a.angle - pose.angle_a, turn_b = b.angle - pose.angle_b;
    Manifold& m = c.manifold;
    ManifoldPoint &p = m.points[0], &q = m.points[1];
    // The anchors are the same point, seen from both centers of mass as they were then.
    const Vec2 shift = b.center - a.center - (p.anchor_a - p.anchor_b);
    const Vec2 move_p = shift + cross(turn_b, p.anchor_b) - cross(turn_a, p.anchor_a);
    const Vec2 move_q = shift + cross(turn_b, q.anchor_b) - cross(turn_a, q.anchor_a);
    const float slip = max(std::fabs(cross(m.normal, move_p)), std::fabs(cross(m.normal, move_q)));
    const float along_p = dot(m.normal, move_p), along_q = dot(m.normal, move_q);
    const float along = max(std::fabs(along_p), std::fabs(along_q));
    const float separation_p = pose.separations[0] + along_p;
    const float separation_q = pose.separations[1] + along_q;
    const float width = length_squared(q.anchor_a - p.anchor_a);
    const float turn = max(std::fabs(turn_a), std::fabs(turn_b));
    const float lean = max(std::fabs(turn_a * dot(m.normal, p.anchor_a)),
                           std::fabs(turn_b * dot(m.normal, p.anchor_b)));
    // Without branches, because tumbling bodies make them unpredictable for the processor.
    const bool little = (turn <= kept_turn) & (lean * lean <= kept_lean * kept_lean * width) &
                        (slip * slip <= kept_slip * kept_slip * width) &
                        (along * along <= kept_gap * kept_gap * width) &
                        (max(separation_p, separation_q) <= speculative_margin);
    if (!little) return false;
    p.separation = separation_p;
    q.separation = separation_q;
    return true;
}

}  // namespace fettle::physics::detail
