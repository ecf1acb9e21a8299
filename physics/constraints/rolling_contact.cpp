#include <collision/ellipse.h>
#include <collision/large_polygon.h>
#include <constraints/rolling_contact.h>

#include <cmath>

namespace fettle::physics::detail {
namespace {

/// A face counts as a circle with this radius, m.
constexpr float face_radius = 1e6f;
/// The contact follows until its normal has turned by this, rad. The second order is not exact
/// enough beyond.
constexpr double greatest_angle = 0.5;

}  // namespace

float radius_of_curvature(const Solid& shape, Vec2 normal) {
    if (shape.kind == FormKind::border) return face_radius;
    if (shape.kind == FormKind::ellipse) {
        // ρ = a²b²/h³.
        const EllipseForm e = ellipse_of(shape.form);
        const float ratio = e.first * e.second / e.reach(normal);
        return ratio * ratio / e.reach(normal);
    }
    constexpr float along = 1.0f - 1e-5f;
    if (shape.kind == FormKind::large) {
        const Vec2 d = unrotate(shape.rotation, normal);
        const int vertex = farthest_vertex(shape.form, d);
        const int before = vertex > 0 ? vertex - 1 : shape.form.count - 1;
        const bool face = dot(shape.form.normals[vertex], d) > along ||
                          dot(shape.form.normals[before], d) > along;
        return face ? face_radius : shape.form.radius;
    }
    for (int i = 0; shape.form.count > 1 && i < shape.form.count; ++i)
        if (dot(shape.form.normals[i], normal) > along) return face_radius;
    return shape.form.radius;
}

RollingContact::RollingContact(const ContactConstraint& start, float radius_a, float radius_b)
    : normal_(start.normal), start_(start.points[0]) {
    // The tangent levers are -h_a and h_b: the reach along the normal, half the gap included.
    const double reach_a = -double(start_.tangent_lever_a);
    const double reach_b = double(start_.tangent_lever_b);
    const double half = 0.5 * double(start_.separation);
    second_a_ = double(radius_a) + half - reach_a;
    second_b_ = double(radius_b) + half - reach_b;
    // Deeply overlapping surfaces have no rolling contact.
    const double sum = double(start_.separation) + double(radius_a) + double(radius_b);
    const double least = 0.1 * (double(radius_a) + double(radius_b));
    sum_ = sum > least ? sum : (least > 0.0 ? least : 1e-6);
}

void RollingContact::follow(ContactConstraint& c, const SolverBody& a, const SolverBody& b) const {
    const Vec2 across = -right_perp(normal_);
    Vec2 shift = b.shift - a.shift;
    double turn_a = double(a.turn), turn_b = double(b.turn);
    double phi = (double(dot(across, shift)) + second_a_ * turn_a + second_b_ * turn_b) / sum_;
    if (std::fabs(phi) > greatest_angle) {
        // All four are limited by the same part. With the angle alone, the second order would hold
        // for no pose, and for a face, whose radius is a million meters, be a million times too
        // large.
        const double part = greatest_angle / std::fabs(phi);
        shift = float(part) * shift;
        turn_a *= part;
        turn_b *= part;
        phi *= part;
    }
    const double gap =
        double(start_.separation) + double(dot(normal_, shift)) -
        double(start_.normal_lever_a) * turn_a + double(start_.normal_lever_b) * turn_b +
        0.5 * (sum_ * phi * phi - second_a_ * turn_a * turn_a - second_b_ * turn_b * turn_b);
    const auto angle = float(phi);
    c.normal = normalized(normal_ + angle * across);
    const Vec2 tangent = right_perp(c.normal);
    ConstraintPoint& p = c.points[0];
    p.normal_lever_a = float(double(start_.normal_lever_a) + second_a_ * (turn_a - phi));
    p.normal_lever_b = float(double(start_.normal_lever_b) - second_b_ * (turn_b - phi));
    p.tangent_lever_a = start_.tangent_lever_a + start_.normal_lever_a * float(phi - turn_a);
    p.tangent_lever_b = start_.tangent_lever_b + start_.normal_lever_b * float(phi - turn_b);
    p.normal_mass = inverse_or_zero(c.inverse_along(c.normal) +
                                    a.inverse_inertia * p.normal_lever_a * p.normal_lever_a +
                                    b.inverse_inertia * p.normal_lever_b * p.normal_lever_b);
    p.tangent_mass = inverse_or_zero(c.inverse_along(tangent) +
                                     a.inverse_inertia * p.tangent_lever_a * p.tangent_lever_a +
                                     b.inverse_inertia * p.tangent_lever_b * p.tangent_lever_b);
    // The passes add the motion of the bodies to first order.
    p.separation = float(gap) - dot(c.normal, shift) - p.normal_lever_b * float(turn_b) +
                   p.normal_lever_a * float(turn_a);
}

}  // namespace fettle::physics::detail
