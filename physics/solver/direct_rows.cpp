#include <solver/direct_rows.h>

// What joints and contacts ask for, as rows for the direct solver. The equations are above each
// type of joint in its own file; here is which of them are written, with which bounds.

namespace fettle::physics::detail {
namespace {

void write_rail(RowWriter& rows, const Rail& rail, RailImpulses& impulses, const JointEnds& ends) {
    const Line& line = rail.along;
    const Jacobian along = Jacobian::along(ends, line.direction, line.lever_a, line.lever_b);
    if (rail.springy)
        rows.spring(along, rail.spring, line.mass, rail.translation - rail.target, impulses.spring);
    if (rail.driven) rows.motor(along, rail.motor_speed, rail.greatest_motor, impulses.motor);
    if (rail.lower > -infinity) rows.limit(along, rail.translation - rail.lower, impulses.lower);
    if (rail.upper < infinity)
        rows.limit(along.opposite(), rail.upper - rail.translation, impulses.upper);
    const Line& across = rail.across;
    rows.hold(Jacobian::along(ends, across.direction, across.lever_a, across.lever_b), rail.offset,
              impulses.across);
}

void hold_point(RowWriter& rows, const JointEnds& ends, V2 gap, V2& impulse) {
    rows.hold(Jacobian::at_anchors(ends, {1.0f, 0.0f}), gap.x, impulse.x);
    rows.hold(Jacobian::at_anchors(ends, {0.0f, 1.0f}), gap.y, impulse.y);
}

}  // namespace

void write_rows(RowWriter& rows, MouseConstraint& c, SolverBody& a, SolverBody& b) {
    // Its softness in the form of a spring: λ = -m·(mass_scale·v + mass_scale·bias_rate·C).
    const Softness& soft = c.softness;
    const Spring spring = {soft.mass_scale * soft.bias_rate, soft.mass_scale, soft.impulse_scale};
    const V2 gap = c.ends.gap(a, b) + cross(b.turn, c.ends.lever_b);
    // A slack one has no mass; its softness would be rigid.
    const bool slack = !(soft.impulse_scale > 0.0f);
    rows.springs(c.ends, slack ? Spring{} : spring, c.mass, gap, c.greatest, c.impulses.pull);
}

void write_rows(RowWriter& rows, DistanceConstraint& c, SolverBody& a, SolverBody& b) {
    const float distance = c.follow(a, b);
    const Jacobian along = Jacobian::along(c.ends, c.axis, c.lever_a, c.lever_b);
    const float error = distance - c.length;
    if (c.springy)
        rows.spring(along, c.spring, c.mass, error, c.impulses.along);
    else if (c.rigid)
        rows.hold(along, error, c.impulses.along);
    if (!c.limited) return;
    if (c.lower > 0.0f) rows.limit(along, distance - c.lower, c.impulses.lower);
    if (c.upper < infinity) rows.limit(along.opposite(), c.upper - distance, c.impulses.upper);
}

void write_rows(RowWriter& rows, RevoluteConstraint& c, SolverBody& a, SolverBody& b) {
    c.ends.follow(a, b);
    const Jacobian turning = Jacobian::turning(c.ends);
    const float angle = c.ends.angle_now(a, b) - c.reference;
    if (c.springy)
        rows.spring(turning, c.spring, c.angular_mass, angle - c.target, c.impulses.spring);
    if (c.driven) rows.motor(turning, c.motor_speed, c.greatest_motor, c.impulses.motor);
    if (c.limited && c.lower > -infinity) rows.limit(turning, angle - c.lower, c.impulses.lower);
    if (c.limited && c.upper < infinity)
        rows.limit(turning.opposite(), c.upper - angle, c.impulses.upper);
    hold_point(rows, c.ends, c.ends.gap(a, b), c.impulses.point);
}

void write_rows(RowWriter& rows, PrismaticConstraint& c, SolverBody& a, SolverBody& b) {
    c.rail.follow(c.ends, a, b);
    write_rail(rows, c.rail, c.impulses.rail, c.ends);
    rows.hold(Jacobian::turning(c.ends), c.ends.angle_now(a, b) - c.reference, c.impulses.angle);
}

void write_rows(RowWriter& rows, WheelConstraint& c, SolverBody& a, SolverBody& b) {
    c.rail.follow(c.ends, a, b);
    if (c.driven)
        rows.motor(Jacobian::turning(c.ends), c.motor_speed, c.greatest_motor, c.impulses.motor);
    write_rail(rows, c.rail, c.impulses.rail, c.ends);
}

void write_rows(RowWriter& rows, WeldConstraint& c, SolverBody& a, SolverBody& b) {
    c.ends.follow(a, b);
    const Jacobian turning = Jacobian::turning(c.ends);
    const float angle = c.ends.angle_now(a, b) - c.reference;
    const V2 gap = c.ends.gap(a, b);
    if (c.rigid_angle)
        rows.hold(turning, angle, c.impulses.angle);
    else if (c.springy_angle)
        rows.spring(turning, c.angle_spring, c.angular_mass, angle, c.impulses.angle);
    if (c.rigid_point)
        hold_point(rows, c.ends, gap, c.impulses.point);
    else if (c.springy_point)
        rows.springs(c.ends, c.point_spring, PointMass::make(c.ends, a, b), gap, infinity,
                     c.impulses.point);
}

void write_rows(RowWriter& rows, MotorConstraint& c, SolverBody& a, SolverBody& b) {
    const V2 gap = c.follow(a, b);
    const V2 speed = turned(c.speed, a.turn);
    const Jacobian turning = Jacobian::turning(c.ends);
    if (!c.springy) {
        rows.motor(turning, c.turn_speed, c.greatest_torque, c.impulses.torque);
        rows.motors(c.ends, speed, c.greatest_force, c.impulses.force);
        return;
    }
    // A spring whose velocity counts from that of the motor: v - u + (push/mass_scale)·C.
    const auto ahead = [&c](float wanted) {
        return c.spring.push > 0.0f ? wanted * c.spring.mass_scale / c.spring.push : 0.0f;
    };
    DirectRow& torque =
        rows.spring(turning, c.spring, c.angular_mass,
                    c.ends.angle_now(a, b) - c.angle - ahead(c.turn_speed), c.impulses.torque);
    if (rows.biased()) {
        torque.low = -double(c.greatest_torque);
        torque.high = double(c.greatest_torque);
    }
    const V2 error = gap - turned(c.offset, a.turn) - V2{ahead(speed.x), ahead(speed.y)};
    rows.springs(c.ends, c.spring, PointMass::make(c.ends, a, b), error, c.greatest_force,
                 c.impulses.force);
}

void write_rows(RowWriter& rows, PulleyConstraint& c, SolverBody& a, SolverBody& b) {
    c.follow(a, b);
    const auto pulled = [](const PulleyConstraint::Side& side, float times, double(&on)[3]) {
        on[0] = -double(times) * double(side.direction.x);
        on[1] = -double(times) * double(side.direction.y);
        on[2] = -double(times) * double(side.lever);
    };
    Jacobian rope = {c.ends.a, c.ends.b, {}, {}};
    pulled(c.side_a, 1.0f, rope.on_a);
    pulled(c.side_b, c.ratio, rope.on_b);
    rows.limit(rope, c.length - c.side_a.length - c.ratio * c.side_b.length, c.impulses.tension);
}

void write_rows(RowWriter& rows, GearConstraint& c, SolverBody& a, SolverBody& b) {
    rows.hold(Jacobian::turning(c.ends, c.ratio), c.start + (b.turn - c.ratio * a.turn),
              c.impulses.angle);
}

void write_rows(RowWriter& rows, PinSlotConstraint& c, SolverBody& a, SolverBody& b) {
    c.rail.follow(c.ends, a, b);
    write_rail(rows, c.rail, c.impulses.rail, c.ends);
}

void write_rows(RowWriter& rows, RatchetConstraint& c, SolverBody& a, SolverBody& b) {
    const Jacobian turning = Jacobian::turning(c.ends);
    const float room = c.way * (c.ends.angle_now(a, b) - c.reference) - c.impulses.caught;
    rows.limit(c.way > 0.0f ? turning : turning.opposite(), room, c.impulses.pawl);
}

namespace {

struct Motion {
    V2 va, vb;
    float wa, wb;
};

/// Speed along the normal at which a point may approach, or must part.
double normal_bias(const RowWriter& rows, const ContactConstraint& c, const ConstraintPoint& p,
                   const ContactExtra* extra, const SolverBody& a, const SolverBody& b,
                   float push_speed) {
    const float opened =
        dot(c.normal, b.shift - a.shift) + (p.normal_lever_b * b.turn - p.normal_lever_a * a.turn);
    float separation = p.separation + opened;
    double bias = 0.0;
    if (extra != nullptr && extra->corner.distance != 0.0f) {
        // As fast as the way round the corner opens the gap, it may be closed along the normal.
        const Motion motion = {a.velocity, b.velocity, a.angular_velocity, b.angular_velocity};
        const float h = float(rows.h());
        const float velocity = dot(c.normal, motion.vb - motion.va) +
                               (p.normal_lever_b * motion.wb - p.normal_lever_a * motion.wa);
        const float gap = corner_gap(extra->corner, c.normal, a, b, motion, opened, 0.0f);
        const float later =
            corner_gap(extra->corner, c.normal, a, b, motion, opened + h * velocity, h);
        bias += double(later - gap) / rows.h();
        separation += gap;
    }
    if (separation > 0.0f) return bias + double(separation) / rows.h();
    if (!rows.biased()) return bias;
    return bias + std::max(double(direct_correction * separation) / rows.h(), -double(push_speed));
}

}  // namespace

void write_rows(RowWriter& rows, ContactConstraint& c, ContactExtra* extra, const SolverBody& a,
                const SolverBody& b, float push_speed, float restitution_threshold) {
    const auto first = uint32_t(rows.size());
    for (int k = 0; k < c.count; ++k) {
        ConstraintPoint& p = c.points[k];
        double bias = normal_bias(rows, c, p, extra, a, b, push_speed);
        if (rows.pass() == DirectPass::bounced && extra != nullptr &&
            extra->approach[k] <= -restitution_threshold && extra->greatest[k] > 0.0f)
            bias = double(extra->restitution) * double(extra->approach[k]);
        rows.rigid(Jacobian::along(c.a, c.b, c.normal, p.normal_lever_a, p.normal_lever_b), bias,
                   p.normal_impulse)
            .low = 0.0;
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
    const V2 t = right_perp(c.normal);
    const double surface_speed = extra != nullptr ? double(extra->surface_speed) : 0.0;
    for (int k = 0; k < c.count; ++k) {
        ConstraintPoint& p = c.points[k];
        bear(rows.rigid(Jacobian::along(c.a, c.b, t, p.tangent_lever_a, p.tangent_lever_b),
                        surface_speed, p.tangent_impulse),
             first + uint32_t(k), 1, c.friction);
    }
}

}  // namespace fettle::physics::detail
