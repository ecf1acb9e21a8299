#include <cmath>
#include <limits>

#include "joint_stage.h"

namespace fettle::physics_module::testing {
namespace {

/// A mouse joint that pulls the body to `target`.
std::function<void(Stage&)> joint(const Vec2& target,
                                  std::initializer_list<std::pair<const char*, Value>> more = {}) {
    return [target, values = std::vector(more)](Stage& s) {
        s.other = s.game.make("MouseJoint", s.world,
                              {{"body", s.body}, {"anchor", Vec2(0, 0)}, {"target", target}});
        for (const auto& [property, value] : values) s.game.set(s.other, property, value);
    };
}

double infinite() {
    return std::numeric_limits<double>::infinity();
}

void lift_by_a_meter(Stage& s) {
    s.game.set(s.body, "position", Vec2(0, 4));
}

void pair_cases(Cases& cases) {
    const Vec2 above(0, 3);
    // A rod of 2.5 m to (0, 3) pulls only after it becomes shorter or its end moves up.
    cases["PairJoint.anchor_a"] = joint_case(tie("DistanceJoint", above), Vec2(0, 5), 60, rose);
    cases["PairJoint.anchor_b"] = joint_case(tie("DistanceJoint", above), Vec2(0, -2), 60, rose);
    Case& body_a = cases["PairJoint.body_a"] =
        joint_case(tie("DistanceJoint", Vec2(0, 0)), Value(), 60, rose);
    body_a.value = [](Stage& s) {
        const Handle beam = s.game.body("Circle", Vec2(0, 7), "static");
        s.game.set(s.other, "length", 3);
        return Value(beam);
    };
    body_a.prepare = [](Stage& s) {
        tie("DistanceJoint", Vec2(0, 0), {{"length", 0.5}, {"min_length", 0.2}})(s);
    };
    Case& body_b = cases["PairJoint.body_b"] =
        joint_case(tie("DistanceJoint", above), Value(), 60, rose);
    body_b.prepare = [](Stage& s) {
        tie("DistanceJoint", Vec2(0, 3), {{"length", 1}, {"body_b", Value()}})(s);
    };
    body_b.value = [](Stage& s) { return Value(s.body); };
    // A joint with a body that hovers in the path of a thrown body.
    Case& collide = cases["PairJoint.collide"] = joint_case(
        {}, true, 60, [](Stage& s) { return s.fastest_rise > 1 && s.game.y(s.body) < 1.5; });
    collide.prepare = [](Stage& s) {
        const Handle lid = s.game.body("Box", Vec2(0, 2), "static");
        tie("DistanceJoint", Vec2(0, 0), {{"body_a", lid}, {"hertz", 0}})(s);
    };
    collide.then = [](Stage& s) { s.game.set(s.body, "velocity", Vec2(0, 20)); };
    collide.steps = 15;
}

void distance_cases(Cases& cases) {
    const Vec2 above(0, 3);
    cases["DistanceJoint.length"] = joint_case(tie("DistanceJoint", above), 1, 60, rose);
    cases["DistanceJoint.max_length"] =
        joint_case(tie("DistanceJoint", above, {{"hertz", 0}}), 1, 60, rose);
    cases["DistanceJoint.min_length"] =
        joint_case(tie("DistanceJoint", Vec2(0, 0), {{"hertz", 0}}), 2, 60, rose);
    cases["DistanceJoint.hertz"] = joint_case(
        tie("DistanceJoint", above, {{"hertz", 0}, {"length", 1}}), infinite(), 60, rose);
    cases["DistanceJoint.damping_ratio"] = joint_case(
        tie("DistanceJoint", Vec2(0, 6), {{"hertz", 1}, {"length", 2.5}, {"damping_ratio", 1}}), 0,
        120, [](Stage& s) { return s.turns > 2; });
    cases["DistanceJoint.damping_ratio"].then = lift_by_a_meter;
    const auto spring = [](const Vec2& to, double length, const char* limit) {
        return tie("DistanceJoint", to,
                   {{"hertz", 2}, {"damping_ratio", 1}, {"length", length}, {limit, 0}});
    };
    cases["DistanceJoint.lower_spring_force"] =
        joint_case(spring(above, 1, "lower_spring_force"), -infinite(), 60, rose);
    cases["DistanceJoint.upper_spring_force"] =
        joint_case(spring(Vec2(0, 0), 3, "upper_spring_force"), infinite(), 60, rose);
    cases["DistanceJoint.motor_speed"] = joint_case(
        tie("DistanceJoint", above, {{"hertz", 0}, {"max_motor_force", 1000}}), -1, 60, rose);
    cases["DistanceJoint.max_motor_force"] = joint_case(
        tie("DistanceJoint", above, {{"hertz", 0}, {"motor_speed", -1}}), 1000, 60, rose);
}

/// The body is pinned at its center and can turn. `fling` and `spin` move both up into the air.
Case pin_case(std::initializer_list<std::pair<const char*, Value>> settings, Value value,
              std::function<bool(Stage&)> effect) {
    return joint_case(tie("RevoluteJoint", Vec2(0, 0.5), settings), std::move(value), 60,
                      std::move(effect));
}

void revolute_cases(Cases& cases) {
    const auto angle = angle_of;
    const auto spin = [](Stage& s) {
        s.game.set(s.other, "anchor_a", Vec2(0, 4));
        s.game.set(s.body, "position", Vec2(0, 4));
        s.game.set(s.body, "angular_velocity", 1);
    };
    const auto add = [&](const char* name,
                         std::initializer_list<std::pair<const char*, Value>> with, Value value,
                         std::function<bool(Stage&)> effect, std::function<void(Stage&)> then) {
        Case& one = cases[std::string("RevoluteJoint.") + name] =
            pin_case(with, std::move(value), std::move(effect));
        one.then = std::move(then);
    };
    const auto held = [](Stage& s) { return !turned(s); };
    add("upper_angle", {}, 0.1, held, spin);
    add(
        "lower_angle", {{"upper_angle", 2}}, 0.9, [=](Stage& s) { return angle(s) > 0.85; }, fling);
    add("reference_angle", {{"lower_angle", 0}, {"upper_angle", 0}}, 1, turned, fling);
    add("motor_speed", {{"max_motor_torque", 100}}, 2, turned, fling);
    add("max_motor_torque", {{"motor_speed", 2}}, 100, turned, fling);
    add("hertz", {{"target_angle", 1}}, 0.5, turned, fling);
    add("target_angle", {{"hertz", 2}, {"damping_ratio", 1}}, 1, turned, fling);
    add("damping_ratio", {{"hertz", 1}}, 30, held, [spin](Stage& s) {
        spin(s);
        s.game.set(s.body, "angular_velocity", 4);
    });
    // Undamped, a spring of 1 Hz swings to 4 / 2π = 0.64 rad after a quarter of a second.
    cases["RevoluteJoint.damping_ratio"].steps = 15;
}

}  // namespace

Cases joint_cases() {
    const Vec2 here(0, 0.5), above(0, 3);
    Cases cases;
    cases["Joint.enabled"] = joint_case(joint(above, {{"enabled", false}}), true, 60, rose);
    cases["MouseJoint.target"] = joint_case(joint(here), above, 60, rose);
    cases["MouseJoint.anchor"] =
        joint_case(joint(here), Vec2(0.4, 0), 60, [](Stage& s) { return s.game.x(s.body) < -0.1; });
    cases["MouseJoint.frequency"] = joint_case(joint(above, {{"frequency", 0}}), 5, 60, rose);
    cases["MouseJoint.max_force"] = joint_case(joint(above, {{"max_force", 1}}),
                                               std::numeric_limits<double>::infinity(), 60, rose);
    cases["MouseJoint.damping_ratio"] =
        joint_case(joint(here), 0, 120, [](Stage& s) { return s.turns > 10; });
    cases["MouseJoint.damping_ratio"].then = [](Stage& s) {
        s.game.set(s.other, "target", Vec2(0, 5));
        s.game.set(s.body, "position", Vec2(0, 6));
    };
    Case& body = cases["MouseJoint.body"] = joint_case(joint(above), Value(), 60, rose);
    body.prepare = [](Stage& s) {
        const Handle second = s.game.body("Box", Vec2(4, 0.5));
        joint(Vec2(0, 3))(s);
        s.game.set(s.other, "max_force", 100);
        s.game.set(s.other, "body", second);
        s.game.set(second, "type", "static");
    };
    body.value = [](Stage& s) { return Value(s.body); };
    pair_cases(cases);
    distance_cases(cases);
    revolute_cases(cases);
    sliding_joint_cases(cases);
    coupling_joint_cases(cases);
    return cases;
}

}  // namespace fettle::physics_module::testing
