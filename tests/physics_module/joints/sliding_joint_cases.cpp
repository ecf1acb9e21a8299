#include "joint_stage.h"

namespace fettle::physics_module::testing {
namespace {

void slide_cases(Cases& cases, const char* of) {
    const auto add = [&](const char* name, Case one) {
        cases[std::string(of) + "." + name] = std::move(one);
    };
    const auto pushed = [](double speed) { return fling_with("velocity", Vec2(speed, 0)); };
    const auto right = [](Stage& s) { return s.game.x(s.body) > -0.3; };
    const auto left = [](Stage& s) { return s.game.x(s.body) < 0.3; };
    add("axis", flung(of, {}, Vec2(0, 1), fell));
    add("lower_translation", flung(of, {}, -0.1, right, pushed(-2)));
    add("upper_translation", flung(of, {}, 0.1, left, pushed(2)));
    add("motor_speed", flung(of, {{"max_motor_force", 1000}}, 2, went_right));
    add("max_motor_force", flung(of, {{"motor_speed", 2}}, 1000, went_right));
    add("hertz", flung(of, {{"target_translation", 1}, {"damping_ratio", 1}}, 2, went_right));
    add("target_translation", flung(of, {{"hertz", 2}, {"damping_ratio", 1}}, 1, went_right));
    // Undamped, a spring of 1 Hz swings to 4 / 2π = 0.64 m after a quarter of a second.
    add("damping_ratio", flung(of, {{"hertz", 1}}, 30, stayed_put, pushed(4), 15));
}

void wheel_cases(Cases& cases) {
    const char* of = "WheelJoint";
    const auto add = [&](const char* name, Case one) {
        cases[std::string("WheelJoint.") + name] = std::move(one);
    };
    add("axis", flung(of, {{"hertz", 0}}, Vec2(1, 0), stayed_up));
    add("hertz", flung(of, {}, 0, fell));
    add("damping_ratio",
        flung(
            of, {{"hertz", 1}}, 30, [](Stage& s) { return std::fabs(s.game.y(s.body) - 4) < 0.15; },
            fling_with("velocity", Vec2(0, -4)), 15));
    add("lower_translation", flung(of, {{"hertz", 0}}, -0.2, stayed_up));
    add("upper_translation",
        flung(
            of, {{"hertz", 0}}, 0.1, [](Stage& s) { return s.game.y(s.body) < 4.4; },
            fling_with("velocity", Vec2(0, 20)), 15));
    add("motor_speed", flung(of, {{"max_motor_torque", 100}}, 2, turned));
    add("max_motor_torque", flung(of, {{"motor_speed", 2}}, 100, turned));
}

}  // namespace

void sliding_joint_cases(Cases& cases) {
    slide_cases(cases, "PrismaticJoint");
    slide_cases(cases, "PinSlotJoint");
    cases["PrismaticJoint.reference_angle"] = flung("PrismaticJoint", {}, 1, turned);
    cases["GrooveJoint.groove_end"] =
        flung("GrooveJoint", {{"groove_end", Vec2(0.1, 4)}}, Vec2(3, 4), went_right,
              fling_with("velocity", Vec2(2, 0)));
    wheel_cases(cases);
}

}  // namespace fettle::physics_module::testing
