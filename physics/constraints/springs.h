#pragma once

#include <constraints/joint_ends.h>

#include <cmath>

// Springs of joints, as rows. The force is -k·C - d·v with the position before the sub-step and the
// velocity after it. This conserves energy while h·ω is small, so a spring swings with the
// frequency and the damping of its settings. Above that (h·ω > ½), the stiffness increasingly uses
// the position after the sub-step. This damps, and is stable for one spring of any stiffness. Each
// sub-step solves a spring once, though, so springs in a row pass on what they push one after the
// other: from h·ω = 1.5 on, such a row breaks apart. A stiffer spring therefore has the stiffness
// of `greatest_turn`. On a body with many joints, each spring is softer and damps less.
//
// k follows from the frequency and a mass that does not depend on the pose of the bodies
// (`JointEnds::spring_mass`). With the mass that the row moves at present, the stiffness would
// change as the bodies turn. Such a force has no potential: undamped springs beside the centers of
// their bodies gained energy without end. d follows from the damping ratio and
// the mass that the row moves.

namespace fettle::physics::detail {

/// Stiffness of a spring. 0 Hz: no spring; infinity, if a joint allows it: rigid.
struct Stiffness {
    float hertz = 0.0f, damping_ratio = 0.0f;

    bool is_rigid() const { return hertz == infinity; }
    bool is_spring() const { return !is_rigid() && hertz > 0.0f; }
};

/// How a point of b moves relative to a point of a for an impulse on both: v = K·λ.
struct PointInverse {
    float xx = 0.0f, xy = 0.0f, yy = 0.0f;

    static PointInverse make(const JointEnds& e, const SolverBody& a, const SolverBody& b) {
        const float ia = a.inverse_inertia, ib = b.inverse_inertia;
        return {e.inverse_a.x + e.inverse_b.x + ia * e.lever_a.y * e.lever_a.y +
                    ib * e.lever_b.y * e.lever_b.y,
                -ia * e.lever_a.x * e.lever_a.y - ib * e.lever_b.x * e.lever_b.y,
                e.inverse_a.y + e.inverse_b.y + ia * e.lever_a.x * e.lever_a.x +
                    ib * e.lever_b.x * e.lever_b.x};
    }
    Vec2 operator*(Vec2 p) const { return {xx * p.x + xy * p.y, xy * p.x + yy * p.y}; }
    /// K^(-½), where K is at least `least` in each direction.
    PointInverse inverse_root(float least) const {
        const float x = xx + least, y = yy + least, det = x * y - xy * xy;
        const float root = std::sqrt(max(det, 0.0f)), sum = std::sqrt(x + y + 2.0f * root);
        const float scale = inverse_or_zero(root * sum);
        return {scale * (y + root), -scale * xy, scale * (x + root)};
    }
    /// In the direction in which the point moves most easily.
    float greatest() const {
        const float half = 0.5f * (xx - yy);
        return 0.5f * (xx + yy) + std::sqrt(half * half + xy * xy);
    }
};

/// What the springs of a joint have in common.
struct SpringTurn {
    static constexpr float greatest_turn = 1.25f;  ///< h·ω
    /// On a body with more joints, each spring is softer and damps less: all act on it at once.
    static constexpr float usual_joints = 3.0f;

    float turn;      ///< h·ω of the mass of the spring
    float crowd;     ///< 1, or the number of joints of the body in `usual_joints`
    float implicit;  ///< share of the position after the sub-step

    /// `mass`: the one that has the frequency; `moved`: the least one that the rows move at
    /// present, which limits the stiffness; both above 0.
    static SpringTurn make(float hertz, float h, float mass, float moved, uint32_t joints) {
        const float crowd = max(1.0f, float(joints) / usual_joints);
        const float faster = std::sqrt(crowd * mass / moved);
        const float turn = min(two_pi<float> * hertz * h, greatest_turn / faster);
        return {turn, crowd, clamp(turn * faster - 0.5f, 0.0f, 1.0f)};
    }
    float push(float h, float mass) const { return mass * turn * turn / h; }
    float damping(const Stiffness& of) const { return 2.0f * of.damping_ratio * turn / crowd; }
    float implicit_resistance(float mass) const { return implicit * mass * turn * turn; }
};

/// A spring along a row.
struct Spring {
    float push = 0.0f;        ///< h·k: impulse for an error of 1, N s/m or N s
    float resistance = 0.0f;  ///< impulse for a velocity of 1 after the sub-step, kg or kg m²

    /// `mass` and `moved`: as in `SpringTurn::make`; 0: there is no spring.
    static Spring make(const Stiffness& stiffness, float h, float mass, float moved,
                       uint32_t joints) {
        if (!(mass > 0.0f) || !(moved > 0.0f)) return {};
        const SpringTurn of = SpringTurn::make(stiffness.hertz, h, mass, moved, joints);
        const float damping = of.damping(stiffness) * std::sqrt(mass * moved);
        return {of.push(h, mass), damping + of.implicit_resistance(mass)};
    }
    /// The change of the impulse `so_far`. `moved`: the mass that the row moves.
    float impulse(float moved, float velocity, float error, float so_far) const {
        if (!(moved > 0.0f)) return -so_far;
        const float rest = moved / (moved + resistance);
        return -rest * (resistance * velocity + push * error + so_far);
    }
};

/// A spring between two points.
struct PointSpring {
    float push = 0.0f;        ///< h·k, N s/m
    PointInverse resistance;  ///< a symmetric matrix: impulse for a velocity after the sub-step, kg

    /// `mass`: as in `SpringTurn::make`; `k`: of the points.
    static PointSpring make(const Stiffness& stiffness, float h, float mass, const PointInverse& k,
                            uint32_t joints) {
        const float greatest = k.greatest();
        if (!(mass > 0.0f) || !(greatest > 0.0f)) return {};
        const SpringTurn of = SpringTurn::make(stiffness.hertz, h, mass, 1.0f / greatest, joints);
        const float damping = of.damping(stiffness) * std::sqrt(mass);
        const PointInverse root = k.inverse_root(1e-3f / mass);
        const float implicit = of.implicit_resistance(mass);
        return {of.push(h, mass),
                {damping * root.xx + implicit, damping * root.xy, damping * root.yy + implicit}};
    }
    /// The new impulse.
    Vec2 impulse(const PointInverse& k, Vec2 velocity, Vec2 error, Vec2 so_far) const {
        const PointInverse& d = resistance;
        const Vec2 free = d * (k * so_far - velocity) - push * error;
        // (1 + d·k)·λ = free
        const float xx = 1.0f + (d.xx * k.xx + d.xy * k.xy), xy = d.xx * k.xy + d.xy * k.yy;
        const float yx = d.xy * k.xx + d.yy * k.xy, yy = 1.0f + (d.xy * k.xy + d.yy * k.yy);
        const float inverse = inverse_or_zero(xx * yy - xy * yx);
        return {inverse * (yy * free.x - xy * free.y), inverse * (xx * free.y - yx * free.x)};
    }
};

}  // namespace fettle::physics::detail
