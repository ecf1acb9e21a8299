#include <joints/free_rows.h>
#include <joints/joint_handle.h>
#include <joints/joint_types.h>

// Holds two points together and lets the bodies rotate: freely, or with a spring, a motor and
// limits (`Coordinate`).
//
// Two rows hold the point. They are solved as one block, because the inertia couples them:
//
//     C = p_b - p_a,   Ċ = v_b + ω_b×r_b - v_a - ω_a×r_a,   λ = -K⁻¹·(Ċ + bias)   (`PointMass`).
//
// K is computed from the current levers in each pass: with K from the start of the step, light
// links that swing fast under a heavy load would gain energy. The rows about the angle θ = θ_b -
// θ_a - reference have Ċ = ω_b - ω_a and the effective mass 1/(I_a⁻¹ + I_b⁻¹): a spring to the
// target, a motor that drives a velocity with a maximum torque, and limits θ - lower >= 0, upper -
// θ >= 0. The spring and friction are solved first, by themselves, then the point, and then the
// motor and the limits, with the reactions of the point (`FreeTurn`).

namespace fettle::physics {
namespace detail {

struct RevoluteSettings {
    static constexpr JointType type = JointType::revolute;
    float reference_angle = 0.0f;
    CoordinateSettings angle;

    void check() const {
        check_finite("reference_angle", reference_angle);
        angle.check(CoordinateSettings::of_angle);
    }
    bool gives_energy() const { return angle.gives_energy(); }
};

struct RevoluteImpulses {
    Vec2 point;
    CoordinateImpulses angle;
    void scale(float s) { point = s * point, angle.scale(s); }
};

struct RevoluteConstraint {
    using Settings = RevoluteSettings;

    JointEnds ends;
    RevoluteImpulses impulses;
    FreeTurn free;  ///< for the current levers, if it is known
    bool free_is_known = false;
    bool pressed = false;  ///< at the start of the step
    PointMass mass;        ///< for the current levers; bodies rotate only between the two passes
    float angular_mass = 0.0f, reference = 0.0f;
    Coordinate angle;

    static float separation(const Settings&, const JointPlace& place) {
        return length(place.gap());
    }
    static bool holds(const Settings&) { return true; }
    static bool holds_point() { return true; }
    void prepare(const Settings& settings, const JointFrame&, const JointStep& step,
                 const SolverBody& a, const SolverBody& b) {
        angular_mass = inverse_or_zero(a.inverse_inertia + b.inverse_inertia);
        reference = settings.reference_angle;
        angle.prepare(settings.angle, impulses.angle, step.h, angular_mass, angular_mass,
                      ends.joints);
        mass = PointMass::make(ends, a, b);
        pressed = ends.is_pressed(a, b, ends.gap(a, b));
    }
    void warm_start(SolverBody& a, SolverBody& b) const {
        ends.push(a, b, impulses.point);
        detail::twist(a, b, load().twist);
    }
    void solve(SolverBody& a, SolverBody& b, const JointStep& step) {
        if (angle.springy) solve_alone<true>(a, b);
        // The bodies have not moved since the last relax pass, or since the start of the step.
        const Vec2 gap = ends.close_wide_gap(a, b, ends.gap(a, b), step);
        const Softness soft = step.softness(gap);
        const Vec2 wanted = pressed ? ends.buckled(gap) : gap;
        const Vec2 velocity = ends.velocity(a, b) + soft.bias_rate * wanted;
        Vec2 own = impulses.point;
        if (angle.has_reactions(impulses.angle))
            own = own - impulses.angle.sum() * free_turn(a, b).reaction;
        push_point(a, b, -(soft.mass_scale * (mass * velocity) + soft.impulse_scale * own));
        if (angle.bounded) solve_bounds<true>(a, b, step);
    }
    void relax(SolverBody& a, SolverBody& b, const JointStep& step) {
        if (angle.driven) solve_alone<false>(a, b);
        ends.follow(a, b);
        mass = PointMass::make(ends, a, b);
        push_point(a, b, -(mass * ends.velocity(a, b)));
        if (!angle.bounded) return;
        free_is_known = false;
        solve_bounds<false>(a, b, step);
    }
    void write_rows(RowWriter& rows, const SolverBody& a, const SolverBody& b) {
        ends.follow(a, b);
        angle.write_rows(impulses.angle, ends.angle_now(a, b) - reference, Jacobian::turning(ends),
                         rows);
        rows.hold_point(ends, ends.gap(a, b), impulses.point);
    }
    JointLoad load() const { return {impulses.point, impulses.angle.sum()}; }
    bool moves_bodies(const SolverBody& a, const SolverBody& b) const {
        return pressed || angle.moves_bodies(b.angular_velocity - a.angular_velocity);
    }
    Drive drive() {
        if (!angle.drives) return {};
        return {&angle.motor.greatest, impulses.angle.motor, {}, true, angle.limited};
    }

  private:
    const FreeTurn& free_turn(const SolverBody& a, const SolverBody& b) {
        if (!free_is_known) free = FreeTurn::make(ends, a, b);
        free_is_known = true;
        return free;
    }
    template <bool biased>
    void solve_alone(SolverBody& a, SolverBody& b) {
        angle.solve_alone<biased>(
            impulses.angle, angular_mass, ends.angle_now(a, b) - reference,
            [&] { return b.angular_velocity - a.angular_velocity; },
            [&](float p) { detail::twist(a, b, p); });
    }
    template <bool biased>
    void solve_bounds(SolverBody& a, SolverBody& b, const JointStep& step) {
        const auto velocity = [&] { return b.angular_velocity - a.angular_velocity; };
        const float place = ends.angle_now(a, b) - reference;
        if (!angle.is_bounded<biased>(impulses.angle, place, velocity(), step)) return;
        const FreeTurn& turn = free_turn(a, b);
        angle.solve_bounds<biased>(impulses.angle, turn.mass, place, step,
                                   ends.greatest_angle_gap(step), velocity, [&](float p) {
                                       detail::twist(a, b, p);
                                       push_point(a, b, p * turn.reaction);
                                   });
    }
    void push_point(SolverBody& a, SolverBody& b, Vec2 change) {
        impulses.point = impulses.point + change;
        ends.push(a, b, change);
    }
};

constinit const JointKind revolute_joint = JointFunctions<RevoluteConstraint>::kind("revolute");

}  // namespace detail

using namespace detail;

FETTLE_JOINT_ANGLE(Revolute)
FETTLE_JOINT_NUMBER(Revolute, lower_angle, angle.limits.lower)
FETTLE_JOINT_NUMBER(Revolute, upper_angle, angle.limits.upper)
FETTLE_JOINT_NUMBER(Revolute, motor_speed, angle.motor.speed)
FETTLE_JOINT_NUMBER(Revolute, max_motor_torque, angle.motor.greatest)
FETTLE_JOINT_NUMBER(Revolute, hertz, angle.stiffness.hertz)
FETTLE_JOINT_NUMBER(Revolute, damping_ratio, angle.stiffness.damping_ratio)
FETTLE_JOINT_NUMBER(Revolute, target_angle, angle.target)
FETTLE_JOINT_FORCE(Revolute, motor_torque, angle.motor)

namespace {

void define(RevoluteSettings& settings, const RevoluteJointDef& def) {
    settings.reference_angle = def.reference_angle.value_or(0.0f);
    settings.angle = {{def.lower_angle, def.upper_angle},
                      {def.motor_speed, def.max_motor_torque},
                      {def.hertz, def.damping_ratio},
                      def.target_angle};
}

}  // namespace

FETTLE_CREATE_JOINT(Revolute, create_revolute_joint,
                    if (!def.reference_angle) joint.set_reference_angle(angle_between(joint)))

}  // namespace fettle::physics
