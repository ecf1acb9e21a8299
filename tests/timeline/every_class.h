#pragma once
// A game with an instance of every class that can be created, and values for every property.

#include <map>
#include <random>
#include <string>
#include <vector>

#include "playing.h"

namespace fettle::app {

/// Everything is below `world`; references and joints connect the instances.
inline constexpr const char* every_class = R"(
    world.floor = Body { type = "static", position = vec(0, -1), Box { width = 60, height = 2 } }
    world.a = Body { position = vec(-4, 0.5), Box {}, Circle { center = vec(0, 1) } }
    world.b = Body { position = vec(-2, 0.5), Box {} }
    world.round = Body { position = vec(0, 0.6), Circle {}, Ellipse {} }
    world.flat = Body { position = vec(2, 0.6), Capsule {}, Segment {} }
    world.cut = Body { position = vec(4, 0.6), Concave {}, Polygon {} }
    world.rail = Body { type = "static", position = vec(0, -3), Chain {} }
    world.pushed = Body { type = "kinematic", position = vec(8, 3), Box {} }
    world.hero = Mover { position = vec(14, 0.1), walk = 1 }
    world.bare = Body { position = vec(12, 3) }
    local function other(name)
        return Body { position = vec(-8, 5), Circle { radius = 0.3 } }
    end
    for i, class in ipairs { DistanceJoint, RevoluteJoint, PrismaticJoint, WheelJoint, WeldJoint,
                             MotorJoint, PulleyJoint, GearJoint, GrooveJoint, PinSlotJoint,
                             RatchetJoint, FilterJoint, RotaryLimitJoint } do
        local one = Body { position = vec(-8 - 2 * i, 5), Circle { radius = 0.3 } }
        local two = Body { position = vec(-7.4 - 2 * i, 5), Circle { radius = 0.2 } }
        world:add(one) world:add(two)
        world:add(class { body_a = one, body_b = two })
    end
    world.mouse = MouseJoint { body = world.b, target = vec(-2, 1) }
    for _, class in ipairs { Wind, Drag, Buoyancy, Attractor } do
        world:add(class { enabled = false })
    end
    Coin = class("Coin", Body) { worth = 1, label = "x", at = vec(1, 2), owner = Body, list = {1, 2} }
    Plan = class("Plan") { open = true, ratio = 0.5, tint = color("red") }
    world.coin = Coin { position = vec(6, 0.5), Circle {} }
    world.plan = Plan {}
    world.plan.mine = 3
    world.other = World { Body { Circle {} } }
    world.camera = Camera {}
    loose = Body { Box {} }
)";

/// Values to write: some that any property of the type accepts, some that few accept.
inline std::vector<property::Value> values_for(const property::Property& property,
                                               const std::vector<property::Handle>& instances) {
    using property::List;
    using property::Type;
    using property::Value;
    using property::Vec2;
    if (!property.enumerators.empty())
        return {property.enumerators.begin(), property.enumerators.end()};
    const double inf = std::numeric_limits<double>::infinity();
    switch (property.type) {
        case Type::boolean:
            return {true, false};
        case Type::integer:
            return {0, 1, 2, 3, -1, 7, 64, std::int64_t{1} << 40};
        case Type::number:
            return {0.0, 1.0, 0.5, -2.5, 1e-5, 3.0, 40.0, 1e6, 1e-30, 3e38, inf, -inf};
        case Type::text:
            return {"", "other"};
        case Type::vec2:
            return {Vec2(0, 0),    Vec2(1, 2),      Vec2(-3, 0.5),
                    Vec2(0, 1e-9), Vec2(1e8, -1e8), Vec2(1e5, 2e38)};
        case Type::color:
            return {property::Color{0, 0.5f, 1, 1}, Value()};
        case Type::reference: {
            std::vector<Value> all = {Value(property::Handle{})};
            for (std::size_t i = 0; i < instances.size(); i += 3) all.emplace_back(instances[i]);
            return all;
        }
        case Type::list:
            return {List{},
                    Value(),
                    List{Vec2(-1, -1), Vec2(1, 1)},
                    List{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)},
                    List{Vec2(0, 0), Vec2(2, 0), Vec2(2, 2), Vec2(1, 0.5), Vec2(0, 2)},
                    List{Vec2(0, 0), Vec2(1, 0), Vec2(2, 1e-7), Vec2(3, 0), Vec2(3, 1), Vec2(0, 1)},
                    List{Vec2(0, 0), Vec2(1, 1), Vec2(2, 2)}};
        default:
            return {1, "text", Value(), List{1, "two", Vec2(3, 4)}};
    }
}

/// Path, property and value of all saved properties.
inline std::map<std::string, std::string> all_values(property::Tree& tree) {
    std::map<std::string, std::string> all;
    tree.each_below(tree.root(), [&](property::Handle handle) {
        for (const property::Property* property : tree.properties(handle))
            if (!property->transient)
                all[tree.path(handle, *property)] =
                    tree.text(tree.peek(handle, *property)) +
                    (tree.overridden(handle, *property) ? " given" : "");
    });
    return all;
}

}  // namespace fettle::app
