#include <cmath>

#include "stage.h"

namespace fettle::physics_module::testing {
namespace {

constexpr double dt = 1.0 / 60;

Case world_case(
    Value value, int steps, std::function<bool(Stage&)> effect,
    std::function<void(Stage&)> then = [](Stage&) {}) {
    Case one;
    one.value = to(std::move(value));
    one.steps = steps;
    one.effect = std::move(effect);
    one.then = std::move(then);
    return one;
}

std::function<void(Stage&)> put(const Vec2& position, const Vec2& velocity = Vec2(0, 0)) {
    return [position, velocity](Stage& s) {
        s.game.set(s.body, "position", position);
        s.game.set(s.body, "velocity", velocity);
    };
}

/// Lets the body stand on the bounds instead of the floor.
void stand_on_bounds(Stage& s) {
    s.game.tree.destroy(s.floor);
    s.game.set(s.world, "bounds", List{Vec2(-100, 0), Vec2(100, 100)});
}

}  // namespace

Cases world_cases() {
    Cases cases;
    cases["World.gravity"] =
        world_case(Vec2(0, 10), 30, [](Stage& s) { return s.game.y(s.body) > 1; });
    // A fall from rest through n sub-steps of length h covers g·h²·n(n + 1)/2.
    cases["World.substeps"] = world_case(
        1, 1, [](Stage& s) { return std::fabs(5 - s.game.y(s.body) - 10 * dt * dt) < 1e-5; },
        put(Vec2(0, 5)));
    // The number of threads must not change the simulation.
    cases["World.threads"] =
        world_case(2, 1, [](Stage& s) { return s.game.get(s.world, "threads").integer() == 2; });
    cases["World.bounds"] = world_case(
        List{Vec2(-2, -5), Vec2(2, 50)}, 60, [](Stage& s) { return s.game.x(s.body) < 1.6; },
        put(Vec2(0, 3), Vec2(10, 0)));
    cases["World.sleeping"] = world_case(false, 200, [](Stage& s) { return s.game.awake(s.body); });
    cases["World.continuous"] = world_case(
        false, 3, [](Stage& s) { return s.game.y(s.body) < -2; }, put(Vec2(0, 6), Vec2(0, -900)));
    Case& friction = cases["World.bounds_friction"] =
        world_case(0, 30, [](Stage& s) { return s.game.x(s.body) > 0.1; });
    friction.prepare = [](Stage& s) {
        stand_on_bounds(s);
        s.game.set(s.body, "force", Vec2(3, 0));
    };
    Case& mix = cases["World.friction_mix"] = world_case(
        "maximum", 60, [](Stage& s) { return s.game.x(s.body) < 1.5; },
        [](Stage& s) { s.game.set(s.body, "velocity", Vec2(3, 0)); });
    mix.prepare = [](Stage& s) { s.game.set(s.shape, "friction", 0); };
    Case& mix_bounce = cases["World.restitution_mix"] = world_case(
        "minimum", 120, [](Stage& s) { return s.fastest_rise < 1; }, put(Vec2(0, 3)));
    mix_bounce.prepare = [](Stage& s) { s.game.set(s.shape, "restitution", 1); };
    Case& bounce = cases["World.bounds_restitution"] = world_case(
        1, 120, [](Stage& s) { return s.fastest_rise > 3; }, put(Vec2(0, 3)));
    bounce.prepare = stand_on_bounds;
    Case& threshold = cases["World.restitution_threshold"] = world_case(
        100, 120, [](Stage& s) { return s.fastest_rise < 1; }, put(Vec2(0, 3)));
    threshold.prepare = [](Stage& s) { s.game.set(s.shape, "restitution", 0.8); };
    Case& hits = cases["World.hit_threshold"] = world_case(
        100, 120, [](Stage& s) { return s.hits == 0; }, put(Vec2(0, 3)));
    hits.prepare = [](Stage& s) {
        const auto& event = *s.game.tree.class_of(s.body).event("contact_hit");
        s.game.tree.on(s.body, event, [&s](const property::Occurrence&) { ++s.hits; });
    };
    const auto stays_awake = [](Stage& s) { return s.game.awake(s.body); };
    cases["World.sleep_speed"] = world_case(0, 200, stays_awake);
    cases["World.sleep_delay"] = world_case(60, 200, stays_awake);
    cases["World.contact_hertz"] =
        world_case(0.5, 60, [](Stage& s) { return s.game.y(s.body) < 0.49; });
    // An overlap of 5 cm: a step removes the share ω / (2ζ + hω) of it, with ω and ζ of the
    // contact.
    cases["World.contact_damping"] = world_case(
        100, 1, [](Stage& s) { return s.game.y(s.body) < 0.46; }, put(Vec2(0, 0.45)));
    // The same overlap: the direct solver removes a fifth in each sub-step.
    cases["World.solver"] = world_case(
        "direct", 1, [](Stage& s) { return s.game.y(s.body) > 0.475; }, put(Vec2(0, 0.45)));
    cases["World.push_speed"] = world_case(
        0.1, 20, [](Stage& s) { return s.game.y(s.body) < 0.4; }, put(Vec2(0, 0.3)));
    cases["World.max_speed"] = world_case(
        1, 30, [](Stage& s) { return s.game.y(s.body) > 4; }, put(Vec2(0, 5)));
    return cases;
}

}  // namespace fettle::physics_module::testing
