#pragma once

#include <collision/solid.h>
#include <constraints/contact_constraint.h>

namespace fettle::physics::detail {

/// Radius of curvature (m) of the surface of a shape at the point with the outward normal `normal`:
/// of the ellipse there, of the circle, or of the rounding of a corner; nearly infinite for a face.
float radius_of_curvature(const Solid& shape, Vec2 normal);

/// Change of a contact of curved surfaces while the bodies turn, to second order. Direction, levers
/// and gap of a contact are computed at the beginning of the step, which is exact enough for faces
/// and circles. On a rolling ellipse the contact moves along the rim, and levers of the step before
/// would add energy until the ellipse tumbles.
///
/// Let φ be the angle of the normal, h(φ - θ) the reach of a body from its center of mass along the
/// normal, and c the vector from center to center. The gap is s = n(φ)·c - h_a(φ - θ_a) - h_b(φ + π
/// - θ_b). It is greatest at the contact: ∂s/∂φ = 0. The radius of curvature is ρ = h + h'', so
/// ∂²s/∂φ² = -(s + ρ_a + ρ_b). When the bodies have moved by δc, δθ_a, δθ_b, the normal has turned
/// by
///
///     φ = (n⊥·δc + h_a''·δθ_a + h_b''·δθ_b) / (s + ρ_a + ρ_b),
///
/// the gap is
///
///     s + n·δc - l_a·δθ_a + l_b·δθ_b + ½ [(s + ρ_a + ρ_b)·φ² - h_a''·δθ_a² - h_b''·δθ_b²],
///
/// and the levers, l = r × n, are those of the new normal in the turned bodies:
/// l_a + h_a''·(δθ_a - φ) and l_b - h_b''·(δθ_b - φ).
class RollingContact {
  public:
    RollingContact() = default;
    RollingContact(const ContactConstraint& start, float radius_a, float radius_b);

    /// Writes direction, levers, masses and gap into the constraint, for the current poses of the
    /// bodies.
    void follow(ContactConstraint& c, const SolverBody& a, const SolverBody& b) const;
    bool acts() const { return sum_ > 0.0; }

  private:
    Vec2 normal_;
    ConstraintPoint start_ = {};
    double second_a_ = 0.0, second_b_ = 0.0;  // h''
    double sum_ = 0.0;                        // s + ρ_a + ρ_b
};

}  // namespace fettle::physics::detail
