#include <solver/joints/direct_row.h>
#include <solver/solvers.h>

#include <cmath>

// Rows of contacts for the direct solver. Rows of joints are in the files of the joints.

namespace fettle::physics::detail {
namespace {

/// Speed along the normal at which a point may approach, or must separate, m/s.
struct NormalBias {
    double whole = 0.0;
    double correction = 0.0;  ///< the part of it that removes an overlap
};

NormalBias normal_bias(const RowWriter& rows, const ContactConstraint& c, const ConstraintPoint& p,
                       const ContactExtra* extra, const SolverBody& a, const SolverBody& b,
                       float push_speed) {
    const float opened =
        dot(c.normal, b.shift - a.shift) + (p.normal_lever_b * b.turn - p.normal_lever_a * a.turn);
    float separation = p.separation + opened;
    double bias = 0.0;
    if (extra != nullptr && extra->corner.distance != 0.0f) {
        const PairMotion motion(a, b);
        const float velocity = dot(c.normal, motion.vb - motion.va) +
                               (p.normal_lever_b * motion.wb - p.normal_lever_a * motion.wa);
        const CornerPath path =
            path_around(extra->corner, c.normal, a, b, motion, opened, velocity, float(rows.h()));
        bias += double(path.opening) / rows.h();
        separation += path.gap;
    }
    if (separation > 0.0f) return {bias + double(separation) / rows.h()};
    if (!rows.biased()) return {bias};
    const double correction =
        std::max(double(direct_correction * separation) / rows.h(), -double(push_speed));
    return {bias + correction, correction};
}

}  // namespace

std::vector<MassScale> mass_scales(const SolverInput& input) {
    const std::vector<SolverBody>& bodies = input.bodies.solver_bodies;
    std::vector<MassScale> scales(bodies.size());
    for (size_t i = 1; i < bodies.size() && i <= input.active.awake_bodies.size(); ++i) {
        const BodyRecord& record = input.objects.bodies[input.active.awake_bodies[i - 1]];
        const double linear = std::sqrt(double(bodies[i].inverse_mass));
        scales[i] = {record.flags.locked_x ? 0.0 : linear, record.flags.locked_y ? 0.0 : linear,
                     std::sqrt(double(bodies[i].inverse_inertia))};
    }
    return scales;
}

void write_rows(RowWriter& rows, ContactConstraint& c, ContactExtra* extra, const SolverBody& a,
                const SolverBody& b, float push_speed, float restitution_threshold) {
    const auto first = uint32_t(rows.size());
    for (int k = 0; k < c.count; ++k) {
        ConstraintPoint& p = c.points[k];
        NormalBias bias = normal_bias(rows, c, p, extra, a, b, push_speed);
        if (rows.pass() == DirectPass::bounced && extra != nullptr &&
            extra->approach[k] <= -restitution_threshold && extra->greatest[k] > 0.0f)
            bias = {double(extra->restitution) * double(extra->approach[k])};
        DirectRow& row =
            rows.rigid(Jacobian::along(c.a, c.b, c.normal, p.normal_lever_a, p.normal_lever_b),
                       bias.whole, p.normal_impulse);
        row.low = 0.0;
        row.correction = row.stiffness * bias.correction;
    }
    const auto bear = [&](DirectRow& row, uint32_t bearer, uint32_t bearers, float friction) {
        row.bearer = bearer;
        row.bearers = bearers;
        row.friction = double(friction);
    };
    if (extra != nullptr && extra->rolling_resistance > 0.0f) {
        const Jacobian turning = {c.a, c.b, {0.0, 0.0, -1.0}, {0.0, 0.0, 1.0}};
        bear(rows.rigid(turning, 0.0, extra->rolling_impulse), first, c.count,
             extra->rolling_resistance);
    }
    const Vec2 t = right_perp(c.normal);
    const double surface_speed = extra != nullptr ? double(extra->surface_speed) : 0.0;
    for (int k = 0; k < c.count; ++k) {
        ConstraintPoint& p = c.points[k];
        bear(rows.rigid(Jacobian::along(c.a, c.b, t, p.tangent_lever_a, p.tangent_lever_b),
                        surface_speed, p.tangent_impulse),
             first + uint32_t(k), 1, c.friction);
    }
}

}  // namespace fettle::physics::detail
