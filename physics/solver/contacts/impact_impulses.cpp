#include <solver/contacts/impact_impulses.h>

#include <cmath>

namespace fettle::physics::detail {
namespace {

/// A body that joints hold completely keeps a little mobility, so that no number is divided by 0.
constexpr float least_mobility = 1e-5f;
/// Two rows whose determinant is a smaller part of the product of their mobilities are one.
constexpr float least_determinant = 1e-4f;

float determinant_of(const ImpactResponse& r) {
    return r.of_first * r.of_second - r.between * r.between;
}

bool are_one_place(const ImpactResponse& r) {
    return !(determinant_of(r) > least_determinant * r.of_first * r.of_second);
}

/// The impulses along the normal without friction.
void bounce(const ImpactResponse& response, const ImpactGoal& goal, float (&impulses)[2]) {
    const float k11 = response.of_first, k22 = response.of_second, k12 = response.between;
    const float(&wanted)[2] = goal.change;
    const bool(&meets)[2] = goal.meets;
    if (meets[0]) impulses[0] = wanted[0] / k11;
    if (meets[1]) impulses[1] = wanted[1] / k22;
    if (!meets[0] || !meets[1]) return;
    // Solves both points together. Solved one after the other, the first would make the body
    // spin.
    if (are_one_place(response)) {
        for (float& impulse : impulses) impulse *= 0.5f;
        return;
    }
    const float determinant = determinant_of(response);
    const float p1 = (k22 * wanted[0] - k12 * wanted[1]) / determinant,
                p2 = (k11 * wanted[1] - k12 * wanted[0]) / determinant;
    if (p1 >= 0.0f && p2 >= 0.0f) {
        impulses[0] = p1;
        impulses[1] = p2;
    } else {
        // The impulse of the other point also reverses the slower one.
        impulses[wanted[0] > wanted[1] ? 1 : 0] = 0.0f;
    }
}

/// Some points of an impact with friction. An impulse x along the tangent changes the velocities
/// of the points, too, so the impulses along the normal that change them as wanted depend on it:
/// they are `alone` - `less`·x.
class RubbingPoints {
  public:
    RubbingPoints(const ImpactResponse& response, const ImpactGoal& goal, const bool (&which)[2])
        : around_{goal.around[0], goal.around[1]}, slip_(goal.slip) {
        const float(&by)[2] = response.by_friction;
        if (which[0] && which[1]) {
            const float k11 = response.of_first, k22 = response.of_second, k12 = response.between;
            const float inverse = 1.0f / determinant_of(response);
            const auto solve = [&](const float(&v)[2], float(&to)[2]) {
                to[0] = (k22 * v[0] - k12 * v[1]) * inverse;
                to[1] = (k11 * v[1] - k12 * v[0]) * inverse;
            };
            solve(goal.change, alone_);
            solve(by, less_);
        } else {
            const int k = which[0] ? 0 : 1;
            alone_[k] = goal.change[k] / response.of(k);
            less_[k] = by[k] / response.of(k);
        }
        const float given = by[0] * alone_[0] + by[1] * alone_[1];
        mobility_ = response.slip - (by[0] * less_[0] + by[1] * less_[1]);
        if (mobility_ > least_determinant * response.slip)
            ending_ = (goal.end_of_slip - given) / mobility_;
        tangent_ = within_energy(within_cone(goal.friction));
    }
    float tangent() const { return tangent_; }
    float normal(int k) const { return alone_[k] - less_[k] * tangent_; }

  private:
    /// Coulomb's law: the impulse ends the slip, or is friction times the one along the normal.
    float within_cone(float friction) const {
        const float sum = alone_[0] + alone_[1], less = less_[0] + less_[1];
        const float size = std::fabs(ending_);
        if (size <= friction * (sum - less * ending_)) return ending_;
        const float sign = ending_ < 0.0f ? -1.0f : 1.0f;
        const float share = 1.0f + sign * friction * less;
        if (!(sum > 0.0f && share > 0.0f)) return 0.0f;
        return sign * min(friction * sum / share, size);
    }
    /// Where friction pushes a point along, the impulse along the normal that its restitution then
    /// needs may give more energy than friction takes. This is the greatest impulse with which the
    /// two bodies gain none. Twice the change of energy is the sum over all impulses of impulse
    /// times velocities before and after: c + b·x + m·x² with the mobility m.
    float within_energy(float x) const {
        const float c = min(alone_[0] * around_[0] + alone_[1] * around_[1], 0.0f);
        const float sign = x < 0.0f ? -1.0f : 1.0f, size = std::fabs(x);
        const float b =
            sign * (slip_ - mobility_ * ending_ - (less_[0] * around_[0] + less_[1] * around_[1]));
        if (!(c + size * (b + mobility_ * size) > 0.0f)) return x;
        const float root = std::sqrt(b * b - 4.0f * mobility_ * c);
        const float greatest = b > 0.0f ? -2.0f * c / (b + root) : (root - b) / (2.0f * mobility_);
        return sign * min(greatest, size);
    }

    float around_[2];  ///< see ImpactGoal
    float slip_;
    float alone_[2] = {}, less_[2] = {};
    float mobility_ = 0.0f;  ///< of the slip, while the points keep their velocities
    float ending_ = 0.0f;    ///< the impulse that ends the slip
    float tangent_ = 0.0f;
};

}  // namespace

ImpactResponse::ImpactResponse(const ContactConstraint& c)
    : of_first(inverse_or_zero(c.points[0].normal_mass)),
      of_second(inverse_or_zero(c.points[1].normal_mass)),
      between(c.coupling_normal) {}

void ImpactResponse::add_friction(const ContactConstraint& c, const bool (&meets)[2],
                                  const SolverBody& a, const SolverBody& b) {
    const float share = meets[0] && meets[1] ? 0.5f : 1.0f;
    lever_a = lever_b = 0.0f;
    for (int k = 0; k < c.count; ++k) {
        if (!meets[k]) continue;
        lever_a += share * c.points[k].tangent_lever_a;
        lever_b += share * c.points[k].tangent_lever_b;
    }
    const Vec2 n = c.normal, t = right_perp(n);
    const Vec2 inverse = c.inverse_a + c.inverse_b;
    const float across = n.x * inverse.x * t.x + n.y * inverse.y * t.y;
    const float turn_a = a.inverse_inertia * lever_a, turn_b = b.inverse_inertia * lever_b;
    slip = c.inverse_along(t) + turn_a * lever_a + turn_b * lever_b;
    for (int k = 0; k < c.count; ++k)
        by_friction[k] =
            across + turn_a * c.points[k].normal_lever_a + turn_b * c.points[k].normal_lever_b;
}

float ImpactResponse::slip_of(const ContactConstraint& c, float surface_speed, const SolverBody& a,
                              const SolverBody& b) const {
    return dot(right_perp(c.normal), b.velocity - a.velocity) + surface_speed +
           (lever_b * b.angular_velocity - lever_a * a.angular_velocity);
}

JointedResponse::JointedResponse(const ContactConstraint& c, JointResponse* joints)
    : ImpactResponse(c) {
    for (int k = 0; k < c.count; ++k) {
        const ConstraintPoint& p = c.points[k];
        reactions[k] = joints->reaction_to(
            Jacobian::along(c.a, c.b, c.normal, p.normal_lever_a, p.normal_lever_b));
    }
    of_first =
        max(of_first - float(reactions[0].reduction(reactions[0])), least_mobility * of_first);
    if (c.count < 2) return;
    of_second =
        max(of_second - float(reactions[1].reduction(reactions[1])), least_mobility * of_second);
    between -= float(reactions[0].reduction(reactions[1]));
}

ImpactImpulses::ImpactImpulses(const ImpactResponse& response, const ImpactGoal& goal) {
    if (!(goal.friction > 0.0f && response.slip > 0.0f)) {
        bounce(response, goal, normal);
        return;
    }
    bool which[2] = {goal.meets[0], goal.meets[1]};
    const bool one_place = which[0] && which[1] && are_one_place(response);
    if (one_place) which[goal.change[0] > goal.change[1] ? 1 : 0] = false;
    RubbingPoints points(response, goal, which);
    if (which[0] && which[1] && (points.normal(0) < 0.0f || points.normal(1) < 0.0f)) {
        // The impulse of the other point also reverses this one.
        which[points.normal(0) < points.normal(1) ? 0 : 1] = false;
        points = RubbingPoints(response, goal, which);
    }
    const float sum = points.normal(0) + points.normal(1);
    if (!(sum > 0.0f)) return;
    for (int k = 0; k < 2; ++k) normal[k] = one_place ? 0.5f * sum : points.normal(k);
    tangent = points.tangent();
}

void ImpactImpulses::add_to(BounceSum& sum, const ContactConstraint& c,
                            const ImpactResponse& response) const {
    sum.impulse = sum.impulse + (normal[0] + normal[1]) * c.normal + tangent * right_perp(c.normal);
    sum.twist_a += response.lever_a * tangent;
    sum.twist_b += response.lever_b * tangent;
    for (int k = 0; k < c.count; ++k) {
        sum.normal[k] += normal[k];
        sum.twist_a += c.points[k].normal_lever_a * normal[k];
        sum.twist_b += c.points[k].normal_lever_b * normal[k];
    }
}

float ImpactImpulses::at_point(const ImpactResponse& response, int point) const {
    return response.of(point) * normal[point] + response.between * normal[1 - point] +
           response.by_friction[point] * tangent;
}

float ImpactImpulses::along_tangent(const ImpactResponse& response) const {
    return response.by_friction[0] * normal[0] + response.by_friction[1] * normal[1] +
           response.slip * tangent;
}

}  // namespace fettle::physics::detail
