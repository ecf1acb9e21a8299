#pragma once

#include <constraints/solver_body.h>

#include <cstdint>

// Data of the solver. They are contiguous: gathered from the records before the sub-steps and
// stored back after them.

namespace fettle::physics::detail {

/// The greatest impulse of a contact that is stored from step to step, N s.
inline constexpr float greatest_impulse = 1e30f;

/// A contact is unsettled if a relax pass changes the velocity at one of its points by more than
/// this, m/s: then other contacts of its bodies are not solved any more.
inline constexpr float unsettling_change = 0.2f;

/// The normal impulses of the two points of a contact are solved together, with this share of
/// their coupling. With all of it, nothing would decide how two points of a body that cannot turn
/// share the impulse. An impact leaves half of the rest, 1/2000 of its velocity.
inline constexpr float coupled_share = 0.999f;

/// What the last relax pass did to a contact.
enum class Relaxed : uint8_t { left_out, settled, unsettled };

/// One point of a contact. The rows of the Jacobian are stored as their lever arms: r×n and r×t of
/// both bodies. The separation follows the bodies to first order, s = s₀ + n·Δd + (r_b×n)·Δθ_b -
/// (r_a×n)·Δθ_a. This is exact for rolling circles and needs the same dot products as the velocity.
struct ConstraintPoint {
    float normal_lever_a, normal_lever_b;
    float tangent_lever_a, tangent_lever_b;
    float separation;
    float normal_mass, tangent_mass;
    float normal_impulse, tangent_impulse;
};

struct ContactConstraint {
    uint32_t a, b;  ///< solver bodies
    Vec2 normal;
    float friction;
    uint32_t contact;       ///< record to store into
    uint32_t extra;         ///< index + 1 of the data of special contacts; 0: none
    uint16_t count;         ///< points
    bool anisotropic;       ///< a body is locked along an axis: solved one at a time
    bool pushed;            ///< in some sub-step
    uint16_t fixed;         ///< 1: one side does not move, so the contact is stiffer
    float coupling_normal;  ///< of point 2, for a unit impulse at point 1
    float coupling_tangent;
    Softness soft;
    Vec2 inverse_a, inverse_b;  ///< inverse masses along x and y: 0 along a locked axis
    ConstraintPoint points[2];

    float inverse_along(Vec2 d) const { return detail::inverse_along(d, inverse_a, inverse_b); }
};

/// Data of a contact at a corner. To first order the gap is s₀ + u_n. The actual gap of a shape
/// that passes the corner along the tangent is larger: the cores have the distance √((d + u_n)² +
/// u_t²). Without this correction, the corner of the next tile kicks a circle that rolls over flush
/// tiles before the circle reaches it.
struct Corner {
    float distance = 0.0f;                 ///< d of the cores at the start, m; 0: no corner
    float lever_a = 0.0f, lever_b = 0.0f;  ///< of the cores along the tangent, m
};

/// The velocities of the two bodies of a contact.
struct PairMotion {
    Vec2 va, vb;
    float wa, wb;

    PairMotion(const SolverBody& a, const SolverBody& b)
        : va(a.velocity), vb(b.velocity), wa(a.angular_velocity), wb(b.angular_velocity) {}
};

/// What the path around a corner adds to the gap along the normal.
struct CornerPath {
    float gap;      ///< m, now
    float opening;  ///< m, by the end of a sub-step: the velocity along the normal may close it
};

/// `opened`: increase of the separation of the cores since the start of the step, m; `velocity`:
/// its rate; `h`: length of a sub-step. `motion` contains the velocities va, wa of a and vb, wb of
/// b.
CornerPath path_around(const Corner& corner, Vec2 n, const SolverBody& a, const SolverBody& b,
                       const auto& motion, float opened, float velocity, float h) {
    const Vec2 t = right_perp(n);
    const float moved =
        dot(t, b.shift - a.shift) + (corner.lever_b * b.turn - corner.lever_a * a.turn);
    const float slip =
        dot(t, motion.vb - motion.va) + (corner.lever_b * motion.wb - corner.lever_a * motion.wa);
    const auto gap_after = [&](float ahead) {
        const float u = moved + ahead * slip;
        const float reach = max(corner.distance + (opened + ahead * velocity), 0.0f);
        return u * u / (std::sqrt(reach * reach + u * u) + reach + 1e-12f);
    };
    const float gap = gap_after(0.0f);
    return {gap, gap_after(h) - gap};
}

/// What impacts before the sub-steps gave the bodies of a contact, as they were at the impact.
struct BounceSum {
    float normal[2] = {};                  ///< impulses of the points along the normal
    Vec2 impulse;                          ///< of b
    float twist_a = 0.0f, twist_b = 0.0f;  ///< angular impulses; that of a is -twist_a
};

struct ContactExtra {
    Corner corner;
    uint32_t rolling = 0;  ///< index + 1 of a contact of curved surfaces; 0: none
    float restitution = 0.0f;
    bool in_impact = false;  ///< its impact is computed before the sub-steps
    bool supported = false;  ///< in an impact: one of its bodies is at a face of something else
    float rolling_resistance =
        0.0f;  ///< m: the greatest angular impulse divided by the normal impulse
    float rolling_mass = 0.0f;
    float rolling_impulse = 0.0f;
    float surface_speed = 0.0f;
    float impact[2] = {};    ///< normal impulse of an impact, for a sub-step: friction follows it
    float approach[2] = {};  ///< relative normal velocity before the step
    float greatest[2] = {};  ///< greatest normal impulse of the sub-steps
    float total[2] = {};     ///< sum of normal impulses over the sub-steps
    BounceSum bounced;

    /// Records the impulses of a sub-step for events and restitution.
    void record(const ContactConstraint& c) {
        for (int k = 0; k < c.count; ++k) {
            greatest[k] = max(greatest[k], c.points[k].normal_impulse);
            total[k] += c.points[k].normal_impulse;
        }
    }
};

/// The impacts of a body in a pass that come first.
struct FirstImpact {
    float time = 1.0f;  ///< as a share of the step
    uint32_t count = 0;
};

}  // namespace fettle::physics::detail
