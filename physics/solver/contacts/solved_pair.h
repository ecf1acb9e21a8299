#pragma once

#include <constraints/contact_constraint.h>

namespace fettle::physics::detail {

/// Velocities of the two bodies of a contact; they stay in registers while it is solved.
struct SolvedPair {
    Vec2 va, vb;
    float wa, wb;
    Vec2 ma, mb;
    float ia, ib;

    SolvedPair(const ContactConstraint& c, const SolverBody& a, const SolverBody& b)
        : va(a.velocity),
          vb(b.velocity),
          wa(a.angular_velocity),
          wb(b.angular_velocity),
          ma(c.inverse_a),
          mb(c.inverse_b),
          ia(a.inverse_inertia),
          ib(b.inverse_inertia) {}

    /// Applies impulse `p` along `direction`, with the angular impulses of the lever arms.
    void apply(Vec2 direction, float p, float angular_a, float angular_b) {
        va.x -= ma.x * p * direction.x;
        va.y -= ma.y * p * direction.y;
        wa -= ia * angular_a;
        vb.x += mb.x * p * direction.x;
        vb.y += mb.y * p * direction.y;
        wb += ib * angular_b;
    }
    /// Does not write a body that no impulse moves, because other threads may read it.
    void store(SolverBody& a, SolverBody& b) const {
        if (moves(a)) {
            a.velocity = va;
            a.angular_velocity = wa;
        }
        if (moves(b)) {
            b.velocity = vb;
            b.angular_velocity = wb;
        }
    }
};

}  // namespace fettle::physics::detail
