#include <cmath>

#include "stage.h"

namespace fettle::physics_module::testing {
namespace {

const property::Color tomato{1, 0, 0, 1};

Case body_case(
    Value value, int steps, std::function<bool(Stage&)> effect,
    std::function<void(Stage&)> then = [](Stage&) {}) {
    Case one;
    one.value = to(std::move(value));
    one.steps = steps;
    one.effect = std::move(effect);
    one.then = std::move(then);
    return one;
}

void lift(Stage& stage) {
    stage.game.set(stage.body, "position", Vec2(0, 5));
}
void remove_floor(Stage& stage) {
    stage.game.tree.destroy(stage.floor);
}
double angle(Stage& stage) {
    return stage.game.number(stage.body, "angle");
}

Cases motion() {
    Cases cases;
    cases["Body.type"] = body_case(
        "static", 30, [](Stage& s) { return s.game.y(s.body) > 0.49; }, remove_floor);
    cases["Body.position"] = body_case(
        Vec2(0, 3), 2, [](Stage& s) { return s.game.y(s.body) < 2.999 && s.game.y(s.body) > 2.9; });
    cases["Body.angle"] =
        body_case(0.4, 3, [](Stage& s) { return angle(s) > 0.1 && angle(s) < 0.399; });
    cases["Body.velocity"] =
        body_case(Vec2(0, 5), 6, [](Stage& s) { return s.game.y(s.body) > 0.8; });
    cases["Body.angular_velocity"] = body_case(6.0, 6, [](Stage& s) { return angle(s) > 0.1; });
    cases["Body.angular_velocity"].shape = "Circle";
    cases["Body.force"] =
        body_case(Vec2(20, 0), 30, [](Stage& s) { return s.game.x(s.body) > 0.5; });
    cases["Body.torque"] = body_case(30.0, 20, [](Stage& s) { return std::fabs(angle(s)) > 0.2; });
    cases["Body.gravity_scale"] =
        body_case(-1, 30, [](Stage& s) { return s.game.y(s.body) > 1.5; });
    cases["Body.linear_damping"] = body_case(
        100.0, 10, [](Stage& s) { return s.game.y(s.body) < 5.3; },
        [](Stage& s) {
            lift(s);
            s.game.set(s.body, "velocity", Vec2(0, 10));
        });
    cases["Body.angular_damping"] = body_case(
        100.0, 10, [](Stage& s) { return angle(s) < 0.3; },
        [](Stage& s) {
            lift(s);
            s.game.set(s.body, "angular_velocity", 10);
        });
    return cases;
}

Cases weight() {
    Cases cases;
    cases["Body.mass"] = body_case(50, 30, [](Stage& s) { return s.load() > 450; });
    cases["Body.inertia"] = body_case(
        1000, 10, [](Stage& s) { return std::fabs(angle(s)) < 0.01; },
        [](Stage& s) {
            lift(s);
            s.game.tree.call(s.body, "apply_angular_impulse", {1.0});
        });
    cases["Body.center"] = body_case(Vec2(0.7, 0), 30, [](Stage& s) { return angle(s) < -0.05; });
    return cases;
}

Cases switches() {
    Cases cases;
    Case& awake = cases["Body.awake"];
    awake.value = [](Stage& s) { return Value(!s.was_awake); };
    awake.effect = [](Stage& s) {
        const Handle step = s.game.tree.child(s.world, "step");
        return s.game.get(step, "awake_bodies").integer() == (s.was_awake ? 0 : 1);
    };
    cases["Body.can_sleep"] = body_case(false, 200, [](Stage& s) { return s.game.awake(s.body); });
    cases["Body.enabled"] = body_case(
        false, 30, [](Stage& s) { return s.game.y(s.body) > 0.49; }, remove_floor);
    cases["Body.sleep_speed"] = body_case(0.0, 200, [](Stage& s) { return s.game.awake(s.body); });
    cases["Body.max_speed"] = body_case(
        1.0, 10, [](Stage& s) { return s.game.y(s.body) > 4.8; },
        [](Stage& s) {
            lift(s);
            s.game.set(s.body, "velocity", Vec2(0, -10));
        });
    Case bullet =
        body_case(true, 3, [](Stage& s) { return s.game.vec(s.other, "velocity").x > 0.1; });
    bullet.prepare = [](Stage& s) {
        s.other = s.game.body("Box", Vec2(6, 5));
        s.game.set(s.game.shape_of(s.other), "width", 0.05);
        s.game.set(s.game.shape_of(s.other), "height", 6);
        s.game.set(s.other, "gravity_scale", 0);
    };
    bullet.then = [](Stage& s) {
        lift(s);
        s.game.set(s.body, "velocity", Vec2(300, 0));
    };
    bullet.shape = "Circle";
    cases["Body.bullet"] = bullet;
    cases["Body.locked_x"] = body_case(
        true, 30, [](Stage& s) { return std::fabs(s.game.x(s.body)) < 1e-3; },
        [](Stage& s) { s.game.set(s.body, "force", Vec2(50, 0)); });
    cases["Body.locked_y"] = body_case(
        true, 30, [](Stage& s) { return s.game.y(s.body) > 0.49; }, remove_floor);
    cases["Body.locked_rotation"] = body_case(
        true, 30, [](Stage& s) { return std::fabs(angle(s)) < 1e-3; },
        [](Stage& s) { s.game.set(s.body, "torque", 50); });
    cases["Body.color"] =
        body_case(tomato, 1, [](Stage& s) { return s.draw().figures.at(0).paint.fill == tomato; });
    return cases;
}

}  // namespace

Cases body_cases() {
    Cases all;
    for (const Cases& some : {motion(), weight(), switches()}) all.insert(some.begin(), some.end());
    return all;
}

}  // namespace fettle::physics_module::testing
