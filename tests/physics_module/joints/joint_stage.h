#pragma once
// Helpers for the cases of joints.

#include <cmath>

#include "stage.h"

namespace fettle::physics_module::testing {

using JointSettings = std::initializer_list<std::pair<const char*, Value>>;

inline Case joint_case(std::function<void(Stage&)> prepare, Value value, int steps,
                       std::function<bool(Stage&)> effect) {
    Case one;
    one.prepare = std::move(prepare);
    one.subject = [](Stage& s) { return s.other; };
    one.value = to(std::move(value));
    one.steps = steps;
    one.effect = std::move(effect);
    return one;
}

inline bool rose(Stage& s) {
    return s.game.y(s.body) > 1;
}

/// Makes a joint of that class between the body at (0, 0.5) and a point of the world.
inline std::function<void(Stage&)> tie(const char* of_class, const Vec2& to,
                                       JointSettings more = {}) {
    return [of_class, to, values = std::vector(more)](Stage& s) {
        s.other = s.game.make(of_class, s.world, {{"body_b", s.body}, {"anchor_a", to}});
        for (const auto& [property, value] : values) s.game.set(s.other, property, value);
    };
}

/// Moves the joint and its body up into the air.
inline void fling(Stage& s) {
    s.game.set(s.other, "anchor_a", Vec2(0, 4));
    s.game.set(s.body, "position", Vec2(0, 4));
}

inline std::function<void(Stage&)> fling_with(const char* property, Value value) {
    return [property, value](Stage& s) {
        fling(s);
        s.game.set(s.body, property, value);
    };
}

/// A case with the body tied at its center in the air; `then` acts on it afterwards.
inline Case flung(const char* of_class, JointSettings settings, Value value,
                  std::function<bool(Stage&)> effect, std::function<void(Stage&)> then = fling,
                  int steps = 60) {
    Case one = joint_case(tie(of_class, Vec2(0, 0.5), settings), std::move(value), steps,
                          std::move(effect));
    one.then = std::move(then);
    return one;
}

inline bool went_right(Stage& s) {
    return s.game.x(s.body) > 0.6;
}
inline bool stayed_put(Stage& s) {
    return std::fabs(s.game.x(s.body)) < 0.3;
}
inline bool fell(Stage& s) {
    return s.game.y(s.body) < 3;
}
inline bool stayed_up(Stage& s) {
    return s.game.y(s.body) > 3.5;
}
inline double angle_of(Stage& s) {
    return s.game.number(s.body, "angle");
}
inline bool turned(Stage& s) {
    return std::fabs(angle_of(s)) > 0.3;
}

void sliding_joint_cases(Cases& cases);
void coupling_joint_cases(Cases& cases);

}  // namespace fettle::physics_module::testing
