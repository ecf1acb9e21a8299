#include <joints/coordinate.h>
#include <joints/joint_handle.h>
#include <joints/joint_types.h>

// Drives b relative to a with a limited force and torque.
//
// The velocity of anchor b in the rotating frame of body a is driven to (u, w):
//
//     Ċ = v_b + ω_b×r_b - v_a - ω_a×(r_a + d) - u,   Ċ_θ = ω_b - ω_a - w,   d = p_b - p_a,
//
// (the arm of a extends to anchor b: both bodies are pushed at the same point) with impulses of at
// most max_force·h and max_torque·h. With a stiffness, springs also act on the offset from a (which
// rotates with a) and on the angle, within the same limits: then a position is driven. Such a
// spring is only a force, and the relax pass does not solve it.

namespace fettle::physics {
namespace detail {

struct MotorSettings {
    static constexpr JointType type = JointType::motor;
    Vec2 linear_velocity;  ///< of anchor b relative to anchor a, in the coordinates of body a
    float angular_velocity = 0.0f;
    float max_force = 0.0f, max_torque = 0.0f;
    Vec2 linear_offset;  ///< of anchor b from anchor a, in the coordinates of body a
    float angular_offset = 0.0f;
    Stiffness stiffness = {0.0f, 1.0f};

    void check() const {
        check_finite("linear_velocity", linear_velocity);
        check_finite("angular_velocity", angular_velocity);
        check_strength("max_force", max_force);
        check_strength("max_torque", max_torque);
        check_coordinates("linear_offset", linear_offset);
        check_finite("angular_offset", angular_offset);
        detail::check(stiffness);
    }
    bool gives_energy() const { return true; }
};

struct MotorConstraint {
    using Settings = MotorSettings;
    struct Impulses {
        Vec2 force;
        float torque = 0.0f;
        void scale(float s) { force = s * force, torque *= s; }
    };

    JointEnds ends;
    Impulses impulses;
    Vec2 speed, offset;  ///< at the start of the step, world axes
    float turn_speed = 0.0f, angle = 0.0f, angular_mass = 0.0f;
    float greatest_force = 0.0f, greatest_torque = 0.0f;
    bool springy = false;
    PointSpring spring;
    Spring turning_spring;

    void prepare(const Settings& settings, const JointFrame& frame, const JointStep& step,
                 const SolverBody& a, const SolverBody& b) {
        speed = rotate(frame.a, settings.linear_velocity);
        offset = rotate(frame.a, settings.linear_offset);
        turn_speed = settings.angular_velocity;
        angle = settings.angular_offset;
        angular_mass = inverse_or_zero(a.inverse_inertia + b.inverse_inertia);
        greatest_force = settings.max_force * step.h;
        greatest_torque = settings.max_torque * step.h;
        springy = settings.stiffness.is_spring();
        if (angular_mass == 0.0f) impulses.torque = 0.0f;
        follow(a, b);
        if (!springy) return;
        spring = PointSpring::make(settings.stiffness, step.h, ends.spring_mass(a, b),
                                   PointInverse::make(ends, a, b), ends.joints);
        turning_spring =
            Spring::make(settings.stiffness, step.h, angular_mass, angular_mass, ends.joints);
    }
    /// Rotates the levers with the bodies; returns the vector from anchor a to anchor b.
    Vec2 follow(const SolverBody& a, const SolverBody& b) {
        ends.follow(a, b);
        const Vec2 gap = ends.gap(a, b);
        ends.lever_a = ends.lever_a + gap;
        return gap;
    }
    void warm_start(SolverBody& a, SolverBody& b) const {
        ends.push(a, b, impulses.force);
        detail::twist(a, b, impulses.torque);
    }
    void solve(SolverBody& a, SolverBody& b, const JointStep&) { push(a, b, springy); }
    void relax(SolverBody& a, SolverBody& b, const JointStep&) {
        // A spring does not act here, but the next sub-step begins with its impulse.
        if (springy)
            follow(a, b);
        else
            push(a, b, false);
    }
    void write_rows(RowWriter& rows, const SolverBody& a, const SolverBody& b) {
        const Vec2 gap = follow(a, b);
        const Vec2 velocity = turned(speed, a.turn);
        const Jacobian turning = Jacobian::turning(ends);
        if (!springy) {
            rows.motor(turning, turn_speed, greatest_torque, impulses.torque);
            rows.motors(ends, velocity, greatest_force, impulses.force);
            return;
        }
        // A spring with a velocity relative to that of the motor: v - u + (push/resistance)·C.
        const auto& [push, resistance] = turning_spring;
        const float ahead = inverse_or_zero(push) * (resistance * turn_speed);
        DirectRow& torque = rows.spring(turning, turning_spring,
                                        ends.angle_now(a, b) - angle - ahead, impulses.torque);
        if (rows.biased()) {
            torque.low = -double(greatest_torque);
            torque.high = double(greatest_torque);
        }
        const Vec2 error = gap - turned(offset, a.turn) -
                           inverse_or_zero(spring.push) * (spring.resistance * velocity);
        rows.springs(ends, spring, error, greatest_force, impulses.force);
    }
    JointLoad load() const { return {impulses.force, impulses.torque}; }
    bool moves_bodies(const SolverBody& a, const SolverBody& b) const {
        const Vec2 wanted = turned(speed, a.turn);
        return (greatest_force > 0.0f &&
                follows(dot(wanted, ends.velocity(a, b)), dot(wanted, wanted))) ||
               (greatest_torque > 0.0f &&
                follows(b.angular_velocity - a.angular_velocity, turn_speed));
    }
    Drive drive() { return Drive::of_force(greatest_force, impulses.force); }

  private:
    void push(SolverBody& a, SolverBody& b, bool springs) {
        const Vec2 gap = follow(a, b);
        const float turning = b.angular_velocity - a.angular_velocity - turn_speed;
        float torque = -angular_mass * turning;
        if (springs) {
            torque = turning_spring.impulse(angular_mass, turning, ends.angle_now(a, b) - angle,
                                            impulses.torque);
        }
        const float turned_by = clamp(impulses.torque + torque, -greatest_torque, greatest_torque);
        detail::twist(a, b, turned_by - impulses.torque);
        impulses.torque = turned_by;

        const Vec2 moving = ends.velocity(a, b) - turned(speed, a.turn);
        Vec2 total = springs ? spring.impulse(PointInverse::make(ends, a, b), moving,
                                              gap - turned(offset, a.turn), impulses.force)
                             : impulses.force - PointMass::make(ends, a, b) * moving;
        const float size = length(total);
        if (size > greatest_force) total = (greatest_force / size) * total;
        ends.push(a, b, total - impulses.force);
        impulses.force = total;
    }
};

constinit const JointKind motor_joint = JointFunctions<MotorConstraint>::kind("motor");

}  // namespace detail

using namespace detail;

FETTLE_JOINT_VECTOR(Motor, linear_velocity, linear_velocity)
FETTLE_JOINT_NUMBER(Motor, angular_velocity, angular_velocity)
FETTLE_JOINT_NUMBER(Motor, max_force, max_force)
FETTLE_JOINT_NUMBER(Motor, max_torque, max_torque)
FETTLE_JOINT_VECTOR(Motor, linear_offset, linear_offset)
FETTLE_JOINT_NUMBER(Motor, angular_offset, angular_offset)
FETTLE_JOINT_NUMBER(Motor, hertz, stiffness.hertz)
FETTLE_JOINT_NUMBER(Motor, damping_ratio, stiffness.damping_ratio)

namespace {

void define(MotorSettings& settings, const MotorJointDef& def) {
    settings.linear_velocity = def.linear_velocity;
    settings.angular_velocity = def.angular_velocity;
    settings.max_force = def.max_force;
    settings.max_torque = def.max_torque;
    settings.linear_offset = def.linear_offset;
    settings.angular_offset = def.angular_offset.value_or(0.0f);
    settings.stiffness = {def.hertz, def.damping_ratio};
}

}  // namespace

FETTLE_CREATE_JOINT(Motor, create_motor_joint,
                    if (!def.angular_offset) joint.set_angular_offset(angle_between(joint)))

}  // namespace fettle::physics
