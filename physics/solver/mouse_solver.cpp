#include <solver/mouse_solver.h>

namespace fettle::physics::detail {

/// Effective mass of a point: K = m⁻¹·1 + I⁻¹·(r⊥ r⊥ᵀ), inverted.
void MouseConstraint::prepare(const SolverBody& b) {
    const float xx = b.inverse_mass + b.inverse_inertia * lever.y * lever.y;
    const float yy = b.inverse_mass + b.inverse_inertia * lever.x * lever.x;
    const float xy = -b.inverse_inertia * lever.x * lever.y;
    const float determinant = xx * yy - xy * xy;
    const float inverse = determinant > 0.0f ? 1.0f / determinant : 0.0f;
    mass_xx = inverse * yy;
    mass_yy = inverse * xx;
    mass_xy = -inverse * xy;
}

void MouseConstraint::apply(SolverBody& b, V2 p) const {
    b.velocity = b.velocity + b.inverse_mass * p;
    b.angular_velocity += b.inverse_inertia * cross(lever, p);
}

void MouseConstraint::warm_start(SolverBody& b) const {
    apply(b, impulse);
}

void MouseConstraint::solve(SolverBody& b) {
    const V2 error = gap + b.shift + cross(b.turn, lever);
    const V2 velocity = b.velocity + cross(b.angular_velocity, lever) + softness.bias_rate * error;
    V2 wanted = {-(mass_xx * velocity.x + mass_xy * velocity.y),
                 -(mass_xy * velocity.x + mass_yy * velocity.y)};
    wanted = softness.mass_scale * wanted - softness.impulse_scale * impulse;
    V2 total = impulse + wanted;
    const float size = length(total);
    if (size > greatest_impulse) total = (greatest_impulse / size) * total;
    apply(b, total - impulse);
    impulse = total;
}

}  // namespace fettle::physics::detail
