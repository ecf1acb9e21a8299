#pragma once

#include <joints/coordinate.h>

// The motion that the rigid rows of a joint leave free, as a limit or a motor of the joint meets
// it.
//
// If a limit is solved by itself, it pushes the body off the pin, and the pin, solved next, throws
// the body back from the limit: each leaves a part of the velocity. So the rigid rows come first,
// and each impulse of a limit or a motor comes with the reaction of the rigid rows that keeps their
// velocities as they are. Then both are exact at the same time, and the rigid rows, which are soft
// where they correct positions, do not yield to the part of their impulse that is a reaction: after
// an impact at a limit it would turn a slide that may not turn. With the rigid rows r and the free
// row f,
//
//     reaction = -K_rr⁻¹·k_rf,   effective mass = 1 / (k_ff - k_rfᵀ·K_rr⁻¹·k_rf).
//
// The mass is written as a quotient of two determinants whose terms are never negative: the
// difference would lose all digits for a small ball on a long arm. The springs of a joint are not
// such rows: they have the stiffness of their settings for the mass that they move by themselves,
// and are solved before the rigid rows.

namespace fettle::physics::detail {

inline double quotient_or_zero(double over, double under) {
    return under > 0.0 ? over / under : 0.0;
}

/// vᵀ·adj(diag(m))·v
inline double around(Vec2 m, Vec2 v) {
    return double(m.y) * v.x * v.x + double(m.x) * v.y * v.y;
}

/// The inverse masses of both bodies of a joint, and what its rows have in common.
struct PairMass {
    double ia = 0.0, ib = 0.0;  ///< inverse inertias
    Vec2 m;                     ///< inverse masses along x and y

    PairMass(const JointEnds& e, const SolverBody& a, const SolverBody& b)
        : ia(a.inverse_inertia), ib(b.inverse_inertia), m(e.inverse_a + e.inverse_b) {}

    double turning() const { return ia + ib; }
    /// det(diag(m) + ia·a·aᵀ + ib·b·bᵀ)
    double determinant(Vec2 a, Vec2 b) const {
        const double both = double(a.x) * b.y - double(a.y) * b.x;
        return double(m.x) * m.y + ia * around(m, a) + ib * around(m, b) + ia * ib * both * both;
    }
    /// The same with a third row, that about the angle.
    double determinant_with_turning(Vec2 a, Vec2 b) const {
        return turning() * m.x * m.y + ia * ib * around(m, a - b);
    }
    /// k of two lines, without the levers.
    double between(const Line& one, const Line& other) const {
        return double(m.x) * one.direction.x * other.direction.x +
               double(m.y) * one.direction.y * other.direction.y;
    }
    /// k of a line and the angle.
    double with_turning(const Line& line) const { return ia * line.lever_a + ib * line.lever_b; }
};

/// Turns two bodies about the point that two rows hold.
struct FreeTurn {
    float mass = 0.0f;
    Vec2 reaction;  ///< of the point, for an impulse of 1

    static FreeTurn make(const JointEnds& e, const SolverBody& body_a, const SolverBody& body_b) {
        const PairMass pair(e, body_a, body_b);
        const Vec2 a = cross(1.0f, e.lever_a), b = cross(1.0f, e.lever_b), d = cross(1.0f, a - b);
        const double held = pair.determinant(a, b);
        if (!(held > 0.0)) return {float(quotient_or_zero(1.0, pair.turning())), {}};
        const double share = e.share / held, kx = pair.ia * a.x + pair.ib * b.x,
                     ky = pair.ia * a.y + pair.ib * b.y;
        const double both = pair.ia * pair.ib * (double(a.x) * b.y - double(a.y) * b.x);
        double inverse = share * pair.determinant_with_turning(a, b);
        if (e.share < 1.0f) inverse += pair.turning() * (1.0 - e.share);
        return {inverse_or_zero(float(inverse)),
                {float(-share * (pair.m.y * kx + both * d.x)),
                 float(-share * (pair.m.x * ky + both * d.y))}};
    }
};

/// Moves two bodies along one line; a row holds them across it, and another row may hold the angle.
struct FreeSlide {
    float mass = 0.0f;
    float across = 0.0f, turning = 0.0f;  ///< reactions, for an impulse of 1

    static FreeSlide make(const JointEnds& e, const Line& along, const Line& across,
                          const SolverBody& body_a, const SolverBody& body_b, bool holds_angle) {
        const PairMass pair(e, body_a, body_b);
        const double ia = pair.ia, ib = pair.ib, sum = pair.turning();
        const auto lever = [&](float l, float c) {
            return l * along.direction + c * across.direction;
        };
        double nn = pair.between(across, across), un = pair.between(along, across),
               uu = pair.between(along, along), all = 0.0;
        if (holds_angle) {
            const double shared = quotient_or_zero(ia * ib, sum);
            const double l = along.lever_a - along.lever_b, c = across.lever_a - across.lever_b;
            nn += shared * c * c, un += shared * l * c, uu += shared * l * l;
            all = double(pair.m.x) * pair.m.y + shared * around(pair.m, lever(float(l), float(c)));
        } else {
            const double la = along.lever_a, lb = along.lever_b, ca = across.lever_a,
                         cb = across.lever_b;
            nn += ia * ca * ca + ib * cb * cb;
            un += ia * la * ca + ib * lb * cb;
            uu += ia * la * la + ib * lb * lb;
            all = pair.determinant(lever(along.lever_a, across.lever_a),
                                   lever(along.lever_b, across.lever_b));
        }
        FreeSlide free;
        free.mass = float(nn > 0.0 ? quotient_or_zero(nn, all) : quotient_or_zero(1.0, uu));
        const double reaction = -quotient_or_zero(un, nn);
        free.across = float(reaction);
        if (holds_angle)
            free.turning = float(-quotient_or_zero(
                pair.with_turning(along) + pair.with_turning(across) * reaction, sum));
        return free;
    }
};

}  // namespace fettle::physics::detail
