#include <schedule/serial_criteria.h>

namespace fettle::physics::detail {
namespace {

/// A path with a smaller bend in a step counts as straight, m.
constexpr float negligible_bend = 5e-5f;

}  // namespace

/// The distance of the cores from the anchors along the normal is half the gap plus the radius.
Corner corner_of(const ObjectState& objects, const ContactRecord& record) {
    const Manifold& m = record.manifold;
    const ManifoldPoint& point = m.points[0];
    const Vec2 t = right_perp(m.normal);
    const float half_gap = 0.5f * point.separation;
    return {m.corner, cross(point.anchor_a, t) + objects.forms[record.shape_a].radius + half_gap,
            cross(point.anchor_b, t) - objects.forms[record.shape_b].radius - half_gap};
}

bool passes_corner(const ObjectState& objects, const BodyScratch& bodies,
                   const ContactRecord& record, float dt) {
    const Manifold& m = record.manifold;
    if (m.corner == 0.0f) return false;
    const ShapeForm &form_a = objects.forms[record.shape_a],
                    &form_b = objects.forms[record.shape_b];
    if (form_a.count == 1 && form_b.count == 1) return false;
    if (form_a.radius + form_b.radius == 0.0f) return false;
    const Corner corner = corner_of(objects, record);
    const SolverBody& a = bodies.solver_bodies[bodies.solver_ends[record.body_a].index()];
    const SolverBody& b = bodies.solver_bodies[bodies.solver_ends[record.body_b].index()];
    const float u =
        dt * (dot(right_perp(m.normal), b.velocity - a.velocity) +
              corner.lever_b * b.angular_velocity - corner.lever_a * a.angular_velocity);
    return u * u > 2.0f * corner.distance * negligible_bend;
}

}  // namespace fettle::physics::detail
