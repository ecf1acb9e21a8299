#include "stage.h"

namespace fettle::physics_module::testing {
namespace {

using Settings = std::vector<std::pair<std::string, Value>>;

bool was_lifted(Stage& s) {
    return s.game.y(s.body) > 1;
}
bool was_pushed_right(Stage& s) {
    return s.game.x(s.body) > 0.3;
}

/// A field that does not move the resting body until one of its properties is edited.
Case field(
    const char* of_class, Settings settings, Value value, std::function<bool(Stage&)> effect,
    std::function<void(Stage&)> then = [](Stage&) {}) {
    Case one;
    one.prepare = [of_class, settings](Stage& s) {
        s.other = s.game.make(of_class, s.world);
        for (const auto& [property, setting] : settings) s.game.set(s.other, property, setting);
    };
    one.subject = [](Stage& s) { return s.other; };
    one.value = to(std::move(value));
    one.effect = std::move(effect);
    one.then = std::move(then);
    one.steps = 60;
    return one;
}

}  // namespace

Cases field_cases() {
    Cases cases;
    cases["Field.enabled"] =
        field("Buoyancy", {{"level", 5}, {"enabled", false}}, true, was_lifted);
    cases["Field.region"] =
        field("Buoyancy", {{"level", 5}, {"region", List{Vec2(10, 10), Vec2(20, 20)}}}, Value(),
              was_lifted);
    cases["Field.mask"] = field("Buoyancy", {{"level", 5}, {"mask", 2}}, 1, was_lifted);
    cases["Wind.velocity"] =
        field("Wind", {{"velocity", Vec2(0, 0)}}, Vec2(30, 0), was_pushed_right);
    cases["Wind.density"] =
        field("Wind", {{"velocity", Vec2(30, 0)}, {"density", 0}}, 1.2, was_pushed_right);
    cases["Drag.flow"] = field("Drag", {{"linear", 20}}, Vec2(10, 0), was_pushed_right);
    cases["Drag.linear"] =
        field("Drag", {{"linear", 0}, {"flow", Vec2(10, 0)}}, 20, was_pushed_right);
    cases["Drag.quadratic"] =
        field("Drag", {{"linear", 0}, {"flow", Vec2(10, 0)}}, 5, was_pushed_right);
    cases["Buoyancy.level"] = field("Buoyancy", {{"level", -10}}, 5, was_lifted);
    // A fifth of the body is below 0.2 m; all of it is above -0.2 m.
    cases["Buoyancy.normal"] = field("Buoyancy", {{"level", 0.2}}, Vec2(0, -1), was_lifted);
    cases["Buoyancy.density"] = field("Buoyancy", {{"level", 5}, {"density", 0}}, 2, was_lifted);
    cases["Buoyancy.drag"] = field(
        "Buoyancy", {{"level", 100}, {"density", 1}}, 0,
        [](Stage& s) { return s.game.y(s.body) > 6.3; },
        [](Stage& s) {
            s.game.set(s.body, "position", Vec2(0, 4));
            s.game.set(s.body, "velocity", Vec2(0, 5));
        });
    cases["Buoyancy.drag"].steps = 30;
    cases["Buoyancy.flow"] = field("Buoyancy", {{"level", 100}, {"density", 1}, {"drag", 5}},
                                   Vec2(5, 0), was_pushed_right);
    const Value up = Vec2(0, 100);
    cases["Attractor.center"] = field(
        "Attractor", {{"strength", 40}, {"falloff", 0}, {"center", Vec2(0, -100)}}, up, was_lifted);
    cases["Attractor.strength"] =
        field("Attractor", {{"strength", 0}, {"falloff", 0}, {"center", up}}, 40, was_lifted);
    cases["Attractor.falloff"] =
        field("Attractor", {{"strength", 40}, {"center", up}}, 0, was_lifted);
    cases["Attractor.core"] = field(
        "Attractor", {{"strength", 40}, {"falloff", 0}, {"center", Vec2(0, 10.5)}, {"core", 1000}},
        0.5, was_lifted);
    return cases;
}

}  // namespace fettle::physics_module::testing
