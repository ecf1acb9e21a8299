#include "joint_stage.h"

namespace fettle::physics_module::testing {
namespace {

void breaking_cases(Cases& cases) {
    cases["Joint.break_force"] = flung("WeldJoint", {}, 1, fell);
    cases["Joint.break_torque"] = flung("WeldJoint", {}, 1, fell, fling_with("torque", 5));
    cases["Joint.broken"] = flung("WeldJoint", {}, true, fell);
    const auto loaded = [](Stage& s) {
        return !s.game.physics.world(s.world).events().joint_loaded.empty();
    };
    cases["Joint.report_force"] = flung("WeldJoint", {}, 1, loaded, fling, 10);
    cases["Joint.report_torque"] = flung("WeldJoint", {}, 1, loaded, fling_with("torque", 5), 10);
}

/// How fast a weld brings a body back that was put a meter away.
void stiffness_cases(Cases& cases) {
    const auto put_aside = [](Stage& s) {
        fling(s);
        s.game.set(s.body, "position", Vec2(1, 4));
    };
    const auto is_late = [](Stage& s) { return s.game.x(s.body) > 0.6; };
    cases["Joint.constraint_hertz"] = flung("WeldJoint", {}, 1, is_late, put_aside, 20);
    cases["Joint.constraint_damping_ratio"] =
        flung("WeldJoint", {{"constraint_hertz", 10}}, 50, is_late, put_aside, 20);
}

void rotary_limit_cases(Cases& cases) {
    const char* of = "RotaryLimitJoint";
    cases["RotaryLimitJoint.upper_angle"] = flung(
        of, {}, 0.1, [](Stage& s) { return !turned(s); }, fling_with("angular_velocity", 1), 30);
    cases["RotaryLimitJoint.lower_angle"] = flung(
        of, {{"upper_angle", 2}}, 0.9, [](Stage& s) { return angle_of(s) > 0.85; }, fling, 40);
    cases["RotaryLimitJoint.reference_angle"] =
        flung(of, {{"lower_angle", 0}, {"upper_angle", 0}}, 1, turned, fling, 40);
}

void weld_cases(Cases& cases) {
    const char* of = "WeldJoint";
    cases["WeldJoint.reference_angle"] = flung(of, {}, 1, turned);
    cases["WeldJoint.hertz"] = flung(of, {}, 0, fell);
    cases["WeldJoint.damping_ratio"] =
        flung(of, {{"hertz", 1}}, 30, stayed_put, fling_with("velocity", Vec2(4, 0)), 15);
    cases["WeldJoint.angular_hertz"] = flung(of, {}, 0, turned, fling_with("angular_velocity", 1));
    cases["WeldJoint.angular_damping_ratio"] = flung(
        of, {{"angular_hertz", 1}}, 30, [](Stage& s) { return !turned(s); },
        fling_with("angular_velocity", 4), 15);
}

void motor_cases(Cases& cases) {
    const char* of = "MotorJoint";
    cases["MotorJoint.max_force"] = flung(of, {{"linear_velocity", Vec2(2, 0)}}, 1000, went_right);
    cases["MotorJoint.max_torque"] = flung(of, {{"angular_velocity", 2}}, 1000, turned, fling, 40);
    cases["MotorJoint.linear_velocity"] = flung(of, {{"max_force", 1000}}, Vec2(2, 0), went_right);
    cases["MotorJoint.angular_velocity"] = flung(of, {{"max_torque", 1000}}, 2, turned, fling, 40);
    cases["MotorJoint.linear_offset"] =
        flung(of, {{"max_force", 1000}, {"hertz", 2}}, Vec2(2, 0), went_right);
    cases["MotorJoint.angular_offset"] =
        flung(of, {{"max_torque", 1000}, {"hertz", 2}}, 1, turned, fling, 40);
    cases["MotorJoint.hertz"] =
        flung(of, {{"max_force", 1000}, {"linear_offset", Vec2(2, 0)}}, 2, went_right);
    // Undamped, the body swings to 4 / 2π = 0.64 m after a quarter of a second; damped, to a third
    // of that.
    cases["MotorJoint.damping_ratio"] = flung(
        of, {{"max_force", 1e6}, {"hertz", 1}}, 0, [](Stage& s) { return s.game.x(s.body) > 0.45; },
        fling_with("velocity", Vec2(4, 0)), 15);
}

/// The rope is 5 m long from the world to its wheel, and 4.5 m from the other wheel down to the
/// body.
void pulley_cases(Cases& cases) {
    const auto rope = [](Value value) {
        return joint_case(
            tie("PulleyJoint", Vec2(3, 0),
                {{"ground_a", Vec2(3, 5)}, {"ground_b", Vec2(0, 5)}, {"length", 9.5}}),
            std::move(value), 90, rose);
    };
    cases["PulleyJoint.length"] = rope(7);
    cases["PulleyJoint.ratio"] = rope(2);
    cases["PulleyJoint.ground_a"] = rope(Vec2(3, 8));
    cases["PulleyJoint.ground_b"] = rope(Vec2(0, 9));
}

void turning_cases(Cases& cases) {
    const auto geared = [](JointSettings settings) {
        return [values = std::vector(settings)](Stage& s) {
            const Handle rotor = s.game.body("Circle", Vec2(8, 8), "kinematic");
            tie("GearJoint", Vec2(0, 0), {{"body_a", rotor}})(s);
            for (const auto& [property, value] : values) s.game.set(s.other, property, value);
        };
    };
    const auto run_rotor = [](Stage& s) {
        s.game.set(s.body, "position", Vec2(0, 4));
        s.game.set(s.game.get(s.other, "body_a").reference(), "angular_velocity", 1);
    };
    Case& ratio = cases["GearJoint.ratio"] = flung("GearJoint", {}, 1, turned, run_rotor, 40);
    ratio.prepare = geared({{"ratio", 0}});
    Case& phase = cases["GearJoint.phase"] = flung("GearJoint", {}, 1, turned, fling, 40);
    phase.prepare = geared({});

    const char* of = "RatchetJoint";
    cases["RatchetJoint.backwards"] =
        flung(of, {}, true, turned, fling_with("angular_velocity", -1), 40);
    const auto wind_back = [](Stage& s) {
        fling(s);
        s.game.set(s.body, "angle", 0.9);
        s.game.set(s.body, "angular_velocity", -3);
    };
    cases["RatchetJoint.tooth"] = flung(
        of, {}, 1, [](Stage& s) { return angle_of(s) < 0.3; }, wind_back, 40);
    cases["RatchetJoint.reference_angle"] = flung(
        of, {{"tooth", 1}}, 0.5, [](Stage& s) { return angle_of(s) > 0.4; }, wind_back, 40);
}

}  // namespace

void coupling_joint_cases(Cases& cases) {
    breaking_cases(cases);
    stiffness_cases(cases);
    rotary_limit_cases(cases);
    weld_cases(cases);
    motor_cases(cases);
    pulley_cases(cases);
    turning_cases(cases);
}

}  // namespace fettle::physics_module::testing
