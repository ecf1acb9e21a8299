#include "stage.h"

namespace fettle::physics_module::testing {
namespace {

/// A joint that holds the body where it rests, or would pull it up to (0, 3).
std::function<void(Stage&)> joint(const Vec2& target,
                                  std::initializer_list<std::pair<const char*, Value>> more = {}) {
    return [target, values = std::vector(more)](Stage& s) {
        s.other = s.game.make("MouseJoint", s.world,
                              {{"body", s.body}, {"anchor", Vec2(0, 0)}, {"target", target}});
        for (const auto& [property, value] : values) s.game.set(s.other, property, value);
    };
}

Case joint_case(std::function<void(Stage&)> prepare, Value value, int steps,
                std::function<bool(Stage&)> effect) {
    Case one;
    one.prepare = std::move(prepare);
    one.subject = [](Stage& s) { return s.other; };
    one.value = to(std::move(value));
    one.steps = steps;
    one.effect = std::move(effect);
    return one;
}

bool rose(Stage& s) {
    return s.game.y(s.body) > 1;
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
    return cases;
}

}  // namespace fettle::physics_module::testing
