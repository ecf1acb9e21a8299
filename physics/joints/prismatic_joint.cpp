#include <joints/prismatic_joint.h>

// Across the axis and about the angle two rows are solved as one block, since the levers s_a = R×n
// and s_b = r_b×n of the first couple them:
//
//     C₁ = n·d,   C₂ = θ_b - θ_a - reference
//     K = | nᵀ(M_a⁻¹ + M_b⁻¹)n + I_a⁻¹s_a² + I_b⁻¹s_b²    I_a⁻¹s_a + I_b⁻¹s_b |
//         | I_a⁻¹s_a + I_b⁻¹s_b                            I_a⁻¹ + I_b⁻¹       |
//
// Solved one after the other, a drawer pulled at its corner would jam. Along the axis: see `Rail`.

namespace fettle::physics::detail {

void PrismaticConstraint::prepare(const Data& data, const JointFrame& frame, const JointStep& step,
                                  const SolverBody& a, const SolverBody& b) {
    reference = data.reference_angle;
    rail.prepare(data.rail, impulses.rail, ends, frame, step, a, b);
}

void PrismaticConstraint::warm_start(SolverBody& a, SolverBody& b) const {
    rail.push_both(impulses.rail, ends, a, b);
    detail::twist(a, b, impulses.angle);
}

template <bool biased>
void PrismaticConstraint::solve_block(SolverBody& a, SolverBody& b, const JointStep& step) {
    const Line& across = rail.across;
    const float ia = a.inverse_inertia, ib = b.inverse_inertia;
    const float k11 = ends.inverse_along(across.direction) + ia * across.lever_a * across.lever_a +
                      ib * across.lever_b * across.lever_b;
    const float k12 = ia * across.lever_a + ib * across.lever_b;
    // Neither turns: the row about the angle has nothing to do, and must not spoil the other.
    const float k22 = ia + ib > 0.0f ? ia + ib : 1.0f;
    float v1 = across.velocity(a, b), v2 = b.angular_velocity - a.angular_velocity;
    float scale = 1.0f, rest = 0.0f;
    if (biased) {
        v1 += step.rigid.bias_rate * rail.offset;
        v2 += step.rigid.bias_rate * (ends.angle_now(a, b) - reference);
        scale = step.rigid.mass_scale;
        rest = step.rigid.impulse_scale;
    }
    const float inverse = inverse_or_zero(k11 * k22 - k12 * k12);
    const float p1 = -scale * inverse * (k22 * v1 - k12 * v2) - rest * impulses.rail.across;
    const float p2 =
        ia + ib > 0.0f ? -scale * inverse * (k11 * v2 - k12 * v1) - rest * impulses.angle : 0.0f;
    impulses.rail.across += p1;
    impulses.angle += p2;
    across.push(ends, a, b, p1);
    detail::twist(a, b, p2);
}

void PrismaticConstraint::solve(SolverBody& a, SolverBody& b, const JointStep& step) {
    rail.follow(ends, a, b);
    if (rail.acts_along()) rail.solve_along<true>(impulses.rail, ends, a, b, step);
    solve_block<true>(a, b, step);
}

void PrismaticConstraint::relax(SolverBody& a, SolverBody& b, const JointStep& step) {
    rail.follow(ends, a, b);
    if (rail.driven || rail.limited) rail.solve_along<false>(impulses.rail, ends, a, b, step);
    solve_block<false>(a, b, step);
}

}  // namespace fettle::physics::detail
