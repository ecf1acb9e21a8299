#pragma once

#include <constraints/solver_body.h>

#include <cmath>
#include <cstdint>

// Data of all types of joints during solving. A joint has rows: directions in which it holds, or in
// which a spring or a motor pushes. Each sub-step solves them once with the bias that corrects
// positions and, after the bodies have moved, once without it (`relax`), so that the velocities of
// the correction do not remain. Levers rotate with the bodies, so both passes use the current
// levers. Then the soft correction of the first pass gives exactly the impulse that bends a
// straight path to a circle, and pendulums keep their energy.

namespace fettle::physics::detail {

/// Data for all joints during a step.
struct JointStep {
    float h = 0.0f;  ///< sub-step, s
    float inverse_h = 0.0f;
    float impulse_ratio = 1.0f;  ///< to the last sub-step: scales warm starting
    float contact_hertz = 0.0f;  ///< frequency of contacts under load
    Softness rigid;              ///< softness of rigid rows
    /// A wider gap is closed as fast as this one, m.
    float greatest_gap = 1e30f;
    /// The same for rows whose length or limit may be set in each step, as that of a winch, m.
    float greatest_length_gap = 1e30f;
    /// The same for angles, rad.
    float greatest_angle_gap = 1e30f;
    /// A gap that is wider than this, m, is closed by moving the bodies. Impacts hardly make such
    /// gaps, but edits do.
    float wide_gap = 1e30f;
    /// The part of the excess over `wide_gap` that one sweep removes.
    float wide_share = 0.0f;

    /// The softness with which a row closes a gap. If the gap is too wide, the correction and what
    /// the row yields are scaled alike: this limits the speed, and the force is still in proportion
    /// to the gap. If only the speed were limited, a greater force would pull the joint apart
    /// without end.
    Softness softness(float gap) const { return softness_up_to(greatest_gap, gap); }
    Softness softness(Vec2 gap) const { return softness(max(std::abs(gap.x), std::abs(gap.y))); }
    Softness length_softness(float gap) const { return softness_up_to(greatest_length_gap, gap); }
    /// The same for a row whose gaps that are wider than `greatest` close as fast as this one.
    Softness softness_up_to(float greatest, float gap) const {
        gap = std::abs(gap);
        if (gap <= greatest) return rigid;
        const float share = greatest / gap;
        return {share * rigid.bias_rate, rigid.mass_scale, share * rigid.impulse_scale};
    }
};

/// Rotates a vector by an angle in the Cayley form, c = (1-t²)/(1+t²), s = 2t/(1+t²) with t =
/// tan(θ/2) ≈ θ/2·(1+θ²/12). The error is below θ⁵/240 for rotations within a step, and the result
/// is a rotation for any angle.
inline Vec2 turned(Vec2 v, float angle) {
    const float t = 0.5f * angle * (1.0f + angle * angle * (1.0f / 12.0f));
    const float scale = 1.0f / (1.0f + t * t);
    const float versine = 2.0f * t * t * scale, s = 2.0f * t * scale;
    return {v.x - versine * v.x - s * v.y, v.y - versine * v.y + s * v.x};
}

inline Vec2 scaled(Vec2 by, Vec2 v) {
    return {by.x * v.x, by.y * v.y};
}

/// The two bodies of a joint and its anchors.
struct JointEnds {
    uint32_t a = 0, b = 0;  ///< solver bodies
    Vec2 start_a, start_b;  ///< from the centers of mass to the anchors at the start of the step
    Vec2 lever_a, lever_b;  ///< current vectors from the centers of mass to the anchors
    Vec2 apart;             ///< center of mass of b minus that of a at the start of the step
    float angle = 0.0f;     ///< of b relative to a at the start of the step
    Vec2 inverse_a, inverse_b;  ///< inverse masses along x and y: 0 along a locked axis
    float share = 1.0f;  ///< of its mass, with which it pushes: solver/joints/crowded_joints.h
    /// Of the speed at which an angle is corrected: solver/joints/long_levers.h
    float angle_share = 1.0f;
    /// A length or a translation that is wrong by more counts as wrong by this, m. See
    /// solver/joints/obstructed_joints.h.
    float greatest_error = infinity;
    /// The greatest impulse in a sub-step of a row that holds a length and yields, N s.
    float greatest_pull = infinity;
    uint32_t joints = 1;  ///< number of joints of its dynamic body that has more of them
    /// The side whose body obstacles hold, or -1. See solver/joints/obstructed_joints.h.
    int held = -1;

    void follow(const SolverBody& body_a, const SolverBody& body_b) {
        lever_a = turned(start_a, body_a.turn);
        lever_b = turned(start_b, body_b.turn);
    }
    /// Anchor b minus anchor a.
    Vec2 gap(const SolverBody& body_a, const SolverBody& body_b) const {
        return apart + (body_b.shift - body_a.shift) + (lever_b - lever_a);
    }
    float greatest_angle_gap(const JointStep& step) const {
        return angle_share * step.greatest_angle_gap;
    }
    Softness angle_softness(const JointStep& step, float error) const {
        return step.softness_up_to(greatest_angle_gap(step), error);
    }
    float bounded_error(float error) const { return clamp(error, -greatest_error, greatest_error); }
    /// What a rigid row of 60 Hz bears for the greatest error in a sub-step, N s. Without an
    /// obstacle it has no limit: only such rows pass an impact on (solver/joints/joint_response.h).
    float greatest_impulse(float mass, float h) const {
        constexpr float rate = 60.0f * two_pi<float>;
        return greatest_error < infinity ? mass * rate * rate * greatest_error * h : infinity;
    }
    float angle_now(const SolverBody& body_a, const SolverBody& body_b) const {
        return angle + (body_b.turn - body_a.turn);
    }
    /// The angle that a joint holds: its reference, or whole turns from it, whichever is within
    /// half a turn of the angle at the start of the step. What turned about itself while the joint
    /// did not act need not turn all the way back.
    float nearest(float reference) const {
        const float error = angle - reference;
        if (std::abs(error) <= 0.5f * two_pi<float>) return reference;
        return angle - std::remainder(error, two_pi<float>);
    }
    /// The mass that swings with the frequency of a spring along a line: the reduced mass of both
    /// bodies. It does not depend on the pose. Far from their centers, the anchors move the bodies
    /// with much less mass; the spring counts at most eight times that. Bodies that can only turn
    /// have a mass, too.
    float spring_mass(const SolverBody& body_a, const SolverBody& body_b) const {
        constexpr float most = 8.0f;
        const float inverse = max(inverse_a.x, inverse_a.y) + max(inverse_b.x, inverse_b.y);
        const float by_turn = body_a.inverse_inertia * length_squared(start_a) +
                              body_b.inverse_inertia * length_squared(start_b);
        if (!(inverse > 0.0f)) return inverse_or_zero(by_turn);
        return min(1.0f / inverse, most / (inverse + by_turn));
    }
    /// Velocity of anchor b relative to anchor a.
    Vec2 velocity(const SolverBody& body_a, const SolverBody& body_b) const {
        return (body_b.velocity + cross(body_b.angular_velocity, lever_b)) -
               (body_a.velocity + cross(body_a.angular_velocity, lever_a));
    }
    /// Applies an impulse at the anchors: `p` on b, its opposite on a.
    void push(SolverBody& body_a, SolverBody& body_b, Vec2 p) const {
        body_a.velocity = body_a.velocity - scaled(inverse_a, p);
        body_a.angular_velocity -= body_a.inverse_inertia * cross(lever_a, p);
        body_b.velocity = body_b.velocity + scaled(inverse_b, p);
        body_b.angular_velocity += body_b.inverse_inertia * cross(lever_b, p);
    }
    /// Moves the two bodies towards each other if the gap is wide. It gives them no velocity: a
    /// velocity that closes a gap of meters in a sub-step would have to be removed again, and
    /// bodies that turn meanwhile would keep a part of it. Returns the remaining gap.
    Vec2 close_wide_gap(SolverBody& body_a, SolverBody& body_b, Vec2 gap,
                        const JointStep& step) const {
        const float width = max(std::abs(gap.x), std::abs(gap.y));
        if (width <= step.wide_gap) return gap;
        const Vec2 closed = step.wide_share * (1.0f - step.wide_gap / width) * gap;
        const Vec2 by_a = {closed.x * share_of(inverse_a.x, inverse_b.x),
                           closed.y * share_of(inverse_a.y, inverse_b.y)};
        const Vec2 by_b = {closed.x * share_of(inverse_b.x, inverse_a.x),
                           closed.y * share_of(inverse_b.y, inverse_a.y)};
        body_a.shift = body_a.shift + by_a;
        body_b.shift = body_b.shift - by_b;
        return gap - (by_a + by_b);
    }
    /// The same for a gap along a direction.
    float close_wide_gap(SolverBody& body_a, SolverBody& body_b, Vec2 direction, float gap,
                         const JointStep& step) const {
        return dot(direction, close_wide_gap(body_a, body_b, gap * direction, step));
    }
    /// True if the two anchors are apart, and the joint does not bring them together now.
    bool stays_open(const SolverBody& body_a, const SolverBody& body_b) const {
        constexpr float wide = 0.01f, slow = 0.5f;  // m, m/s
        const Vec2 between = gap(body_a, body_b);
        const float square = length_squared(between);
        return square > wide * wide &&
               std::abs(dot(between, velocity(body_a, body_b))) < slow * std::sqrt(square);
    }
    /// True if a gap is open because the bodies are pressed together along the line between them. A
    /// straight chain that is pressed at its ends is in balance, although nothing holds it so.
    bool is_pressed(const SolverBody& body_a, const SolverBody& body_b, Vec2 gap) const {
        constexpr float wide = 0.01f, straight = 0.98f;  // m, cosine
        if (max(std::abs(gap.x), std::abs(gap.y)) <= wide) return false;
        const Vec2 centers = apart + (body_b.shift - body_a.shift);
        const float against = -dot(gap, centers);
        return against > 0.0f && against * against >= straight * straight * length_squared(gap) *
                                                          length_squared(centers);
    }
    /// The gap of a pin that is pressed, turned a little, because forces that are exactly along a
    /// straight chain would leave it straight and tear its pins apart. Neighbors in a chain usually
    /// turn to opposite sides.
    Vec2 buckled(Vec2 gap) const {
        constexpr float part = 0.05f;
        return gap + cross(b % 2 == 0 ? part : -part, gap);
    }
    float inverse_along(Vec2 d) const { return detail::inverse_along(d, inverse_a, inverse_b); }

  private:
    /// The part of a displacement that the first of two bodies with these inverse masses makes.
    static float share_of(float first, float second) {
        return first > 0.0f ? first / (first + second) : 0.0f;
    }
};

/// Additional data for some joints at the start of the step: rotation of body a, and both centers
/// of mass.
struct JointFrame {
    Rotation a;
    Position center_a, center_b;
    Position anchor_a;  ///< in the coordinates of body a
    double angle_a = 0.0, angle_b = 0.0;
};

/// Applies an angular impulse: `p` on b, its opposite on a.
inline void twist(SolverBody& a, SolverBody& b, float p) {
    a.angular_velocity -= a.inverse_inertia * p;
    b.angular_velocity += b.inverse_inertia * p;
}

}  // namespace fettle::physics::detail
