#include <joints/joint_types.h>
#include <joints/rail.h>

// A wheel (b) that rotates freely or by a motor, with a suspension along an axis of a: a point of b
// on a line of a (`Rail`), the suspension as the spring along the line, and a motor about the axle:
// Ċ = ω_b - ω_a - speed with at most max_motor_torque, effective mass 1/(I_a⁻¹ + I_b⁻¹).

namespace fettle::physics {
namespace detail {

struct WheelSettings {
    static constexpr JointType type = JointType::wheel;
    RailSettings rail = {.axis = {0.0f, 1.0f}, .along = {{}, {}, {4.0f, 0.7f}}};
    Motor motor;

    void check() const {
        rail.check();
        check_finite("motor_speed", motor.speed);
        check_strength("max_motor_torque", motor.greatest);
    }
    bool gives_energy() const { return rail.gives_energy() || motor.gives_energy(); }
};

struct WheelImpulses {
    RailImpulses rail;
    float motor = 0.0f;
    void scale(float s) { rail.scale(s), motor *= s; }
};

struct WheelConstraint {
    using Settings = WheelSettings;

    JointEnds ends;
    WheelImpulses impulses;
    Rail rail;
    Motor motor;
    float angular_mass = 0.0f;
    bool driven = false;

    static float separation(const Settings& settings, const JointPlace& place) {
        return settings.rail.separation(place);
    }
    void prepare(const Settings& settings, const JointFrame& frame, const JointStep& step,
                 const SolverBody& a, const SolverBody& b) {
        rail.prepare(settings.rail, impulses.rail, ends, frame, step, a, b);
        angular_mass = inverse_or_zero(a.inverse_inertia + b.inverse_inertia);
        driven = angular_mass > 0.0f && settings.motor.greatest > 0.0f;
        motor = {settings.motor.speed, settings.motor.greatest * step.h};
        if (!driven) impulses.motor = 0.0f;
    }
    void warm_start(SolverBody& a, SolverBody& b) const {
        rail.warm_start(impulses.rail, ends, a, b);
        detail::twist(a, b, impulses.motor);
    }
    template <bool biased>
    void pass(SolverBody& a, SolverBody& b, const JointStep& step) {
        if (!biased && driven) {
            const float velocity = b.angular_velocity - a.angular_velocity;
            detail::twist(
                a, b,
                push_motor(impulses.motor, angular_mass, velocity, motor.speed, motor.greatest));
        }
        rail.follow(ends, a, b);
        rail.solve_turning<biased>(impulses.rail, ends, a, b, step);
    }
    void write_rows(RowWriter& rows, const SolverBody& a, const SolverBody& b) {
        rail.follow(ends, a, b);
        if (driven)
            rows.motor(Jacobian::turning(ends), motor.speed, motor.greatest, impulses.motor);
        rail.write_rows(impulses.rail, ends, rows);
    }
    JointLoad load() const { return {rail.force(impulses.rail), impulses.motor}; }
    bool moves_bodies(const SolverBody& a, const SolverBody& b) const {
        return driven && motor.moves_bodies(b.angular_velocity - a.angular_velocity);
    }
    Drive drive() {
        if (!driven || motor.speed == 0.0f) return {};
        return {&motor.greatest, impulses.motor, {}, true};
    }
};

constinit const JointKind wheel_joint = JointFunctions<WheelConstraint>::kind("wheel");

}  // namespace detail

using namespace detail;

FETTLE_RAIL(Wheel)
FETTLE_JOINT_NUMBER(Wheel, motor_speed, motor.speed)
FETTLE_JOINT_NUMBER(Wheel, max_motor_torque, motor.greatest)
FETTLE_JOINT_FORCE(Wheel, motor_torque, motor)

namespace {

void define(WheelSettings& settings, const WheelJointDef& def) {
    settings.rail.axis = def.axis;
    settings.rail.along.limits = {def.lower_translation, def.upper_translation};
    settings.rail.along.stiffness = {def.hertz, def.damping_ratio};
    settings.motor = {def.motor_speed, def.max_motor_torque};
}

}  // namespace

FETTLE_CREATE_JOINT(Wheel, create_wheel_joint, )

}  // namespace fettle::physics
