#include "stage.h"

namespace fettle::physics_module::testing {
namespace {

using Settings = std::vector<std::pair<std::string, Value>>;
using Effect = std::function<bool(Stage&)>;
using Prepare = std::function<void(Stage&)>;

/// A static body right of the mover.
void put(Stage& s, const char* shape, const Vec2& position, Settings settings) {
    const Handle body = s.game.make("Body", s.world, {{"type", "static"}, {"position", position}});
    const Handle made = s.game.make(shape, body);
    for (const auto& [property, value] : settings) s.game.set(made, property, value);
}

/// The way is free up to a height of 1 m.
void put_tunnel(Stage& s) {
    put(s, "Box", {9, 2}, {{"width", 2}, {"height", 2}});
}

/// A mover at (5, 0), with these settings until one of its properties is edited.
Case mover(
    Settings settings, Value value, Effect effect, Prepare more = [](Stage&) {}) {
    Case one;
    one.prepare = [settings, more](Stage& s) {
        s.other = s.game.make("Mover", s.world, {{"position", Vec2(5, 0.01)}});
        for (const auto& [property, setting] : settings) s.game.set(s.other, property, setting);
        more(s);
    };
    one.subject = [](Stage& s) { return s.other; };
    one.value = to(std::move(value));
    one.effect = std::move(effect);
    one.steps = 90;
    return one;
}

Effect beyond(double x) {
    return [x](Stage& s) { return s.game.x(s.other) > x; };
}
Effect above(double y) {
    return [y](Stage& s) { return s.game.y(s.other) > y; };
}

}  // namespace

Cases mover_cases() {
    Cases cases;
    cases["Mover.radius"] = mover({{"walk", 2}}, 0.2, beyond(7.2), [](Stage& s) {
        put(s, "Box", {8, 1}, {{"height", 2}});
    });
    cases["Mover.height"] = mover({{"walk", 2}}, 0.9, beyond(8), put_tunnel);
    cases["Mover.crouch_height"] =
        mover({{"walk", 2}, {"crouch", true}, {"crouch_height", 1.2}}, 0.9, beyond(8), put_tunnel);
    cases["Mover.crouch"] = mover({{"walk", 2}}, true, beyond(8), put_tunnel);
    cases["Mover.walk"] = mover({}, 2, beyond(6));
    cases["Mover.climb"] = mover({{"climbing", true}}, 2, above(1));
    cases["Mover.climbing"] = mover({{"climb", 2}}, true, above(1));
    cases["Mover.acceleration"] = mover({{"walk", 2}, {"acceleration", 0}}, 60, beyond(6));
    cases["Mover.air_acceleration"] = mover(
        {{"walk", 2}, {"air_acceleration", 0}, {"gravity_scale", 0}, {"position", Vec2(5, 5)}}, 20,
        beyond(6));
    cases["Mover.max_slope"] =
        mover({{"walk", 2}, {"max_slope", 0.3}}, 0.8, above(0.3), [](Stage& s) {
            put(s, "Polygon", {7, 0},
                {{"vertices", List{Vec2(0, -0.5), Vec2(5, -0.5), Vec2(5, 2.5)}}});
        });
    cases["Mover.step_height"] =
        mover({{"walk", 2}, {"step_height", 0}}, 0.3, above(0.2), [](Stage& s) {
            put(s, "Box", {9, 0.125}, {{"width", 4}, {"height", 0.25}});
        });
    cases["Mover.snap"] = mover(
        {{"position", Vec2(5, 0.21)}, {"snap", 0}}, 0.25, [](Stage& s) { return s.hits == 0; },
        [](Stage& s) {
            put(s, "Box", {5, 0.1}, {{"width", 2}, {"height", 0.2}});
        });
    cases["Mover.snap"].then = [](Stage& s) {
        s.hits = 0;
        s.game.tree.on(s.other, *s.game.tree.class_of(s.other).event("left_ground"),
                       [&s](const property::Occurrence&) { ++s.hits; });
        s.game.set(s.other, "walk", 3);
    };
    cases["Mover.push_force"] =
        mover({{"walk", 2}, {"push_force", 0}}, 600, beyond(7), [](Stage& s) {
            s.game.set(s.game.shape_of(s.game.body("Box", {7, 0.5})), "density", 30);
        });
    const auto wall = [](const char* property, int bits) {
        return [property, bits](Stage& s) {
            put(s, "Box", {8, 1}, {{"height", 2}, {property, bits}});
        };
    };
    cases["Mover.ledges"] = mover({{"walk", 2}}, 2, beyond(8), wall("category", 2));
    cases["Mover.category"] = mover({{"walk", 2}, {"category", 2}}, 1, beyond(8), wall("mask", 2));
    cases["Mover.mask"] = mover({{"walk", 2}}, -5, beyond(8), wall("category", 4));
    cases["Mover.visible"] = mover({}, false, [](Stage& s) {
        Picture picture;
        s.game.tree.draw(s.other, picture, 1.0);
        return picture.figures.empty();
    });
    return cases;
}

}  // namespace fettle::physics_module::testing
