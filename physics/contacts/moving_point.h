#pragma once

#include <state/world_state.h>

#include <cmath>

// The point of contact of a body that rocks or rolls moves along the surfaces within the step, and
// so do the normal and the lever arms. The solver computes with one geometry in the whole step.
// With that of the beginning, impulses lag behind the motion and give energy to it: a plank that
// rocked on a log doubled its amplitude in a minute. So the geometry is continued to a later
// moment, as it changed in the last step.

namespace fettle::physics::detail {

/// Geometry of a contact with one point. It is stored as the four numbers of a ManifoldPose, which
/// only contacts with two points use otherwise.
struct PointGeometry {
    Vec2 normal;
    float lever_a = 0.0f, lever_b = 0.0f;  ///< r × n of the bodies, m

    static PointGeometry from(const ManifoldPose& stored) {
        return {{stored.angle_a, stored.angle_b}, stored.separations[0], stored.separations[1]};
    }
    ManifoldPose stored() const { return {normal.x, normal.y, {lever_a, lever_b}}; }
};

/// The moment of the geometry, as a part of the step, with which a swing keeps its energy. In n
/// sub-steps an acceleration a moves a body by (n + 1) / (2 n) · a · dt², and the swing keeps its
/// energy if this factor and the part sum up to 1.
inline float moment_of_geometry(int substeps) {
    return 0.5f * float(substeps - 1) / float(substeps);
}

/// If the normal turned by more than this in the last step (rad), the contact point is at another
/// place of the shapes.
inline constexpr float greatest_turn_of_normal = 0.1f;

/// True for a contact whose geometry may be continued: one point under load, which does not follow
/// the bodies within the step by itself.
inline bool has_moving_point(const ContactRecord& c) {
    return c.manifold.count == 1 && !c.curved && c.manifold.points[0].normal_impulse > 0.0f;
}

/// Continues the geometry of a contact with a moving point by the part `moment` of the step, and
/// stores the geometry of now for the next step. `continues`: the geometry of the last step is
/// stored, of the same corner. A contact that slides is not continued: its point does not move
/// because of a rotation.
inline void continue_point(ObjectState& objects, uint32_t slot, bool continues, float moment) {
    ContactRecord& c = objects.contacts[slot];
    Manifold& m = c.manifold;
    ManifoldPoint& p = m.points[0];
    const PointGeometry before = PointGeometry::from(objects.manifold_poses[slot]);
    const PointGeometry now = {m.normal, cross(p.anchor_a, m.normal), cross(p.anchor_b, m.normal)};
    objects.manifold_poses[slot] = now.stored();
    c.kept = true;

    const bool sticks = std::fabs(p.tangent_impulse) < c.friction * p.normal_impulse;
    const Vec2 turn = now.normal - before.normal;
    if (!continues || !sticks ||
        length_squared(turn) > greatest_turn_of_normal * greatest_turn_of_normal)
        return;
    m.normal = normalized(now.normal + moment * turn);
    const Vec2 along = right_perp(m.normal);
    const auto move = [&](Vec2& anchor, float lever, float lever_before) {
        const float later = lever + moment * (lever - lever_before);
        anchor = anchor + (later - cross(anchor, m.normal)) * along;
    };
    move(p.anchor_a, now.lever_a, before.lever_a);
    move(p.anchor_b, now.lever_b, before.lever_b);
}

}  // namespace fettle::physics::detail
