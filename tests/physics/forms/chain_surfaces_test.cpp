#include <limits>

#include "catch.h"
#include "saved_worlds.h"
#include "scenes.h"

namespace chain_surfaces_test {

// Surfaces of single segments of a chain.

using namespace scenes;

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/// A flat ground of segments of 10 m, from x = 0.
Shape add_ground(World& world, int segments, const ShapeDef& surface = {}) {
    std::vector<Vec2> points;
    for (int i = 0; i <= segments; ++i) points.push_back({10.0f * float(i), 0});
    return world.create_body({.type = BodyType::static_body}).add(Chain{points}, surface);
}

Body add_slider(World& world, float x, float speed = 5) {
    Body box = world.create_body({.position = {x, 0.5f}, .velocity = {speed, 0}});
    box.add(Box{}, {.friction = 0.5f, .material = 9});
    return box;
}

}  // namespace

TEST_CASE("a box slides over the segment of ice and stops on the others") {
    World world;
    Shape ground = add_ground(world, 3, {.friction = 0.5f});
    ground.set_segment_surface(1, SegmentSurface{.friction = 0, .material = 4});
    Body rough = add_slider(world, 2), ice = add_slider(world, 12);
    run(world, 1.0f);
    REQUIRE(rough.velocity().x == Approx(0).margin(0.01));
    REQUIRE(ice.velocity().x == Approx(5).epsilon(0.001));
    run(world, 3.0f);  // beyond the ice
    REQUIRE(ice.position().x > 20);
    REQUIRE(ice.velocity().x == Approx(0).margin(0.01));
}

TEST_CASE("segments bounce and run like belts and resist rolling") {
    World world;
    Shape ground = add_ground(world, 4);
    ground.set_segment_surfaces(std::vector<SegmentSurface>{
        {}, {.restitution = 0.9f}, {.surface_speed = -3}, {.rolling_resistance = 0.2f}});
    Body dead = add_ball(world, {9, 3}), lively = add_ball(world, {15, 3});
    Body carried = add_slider(world, 25, 0);
    Body rolling = add_ball(world, {31, 0.5f}), free = add_ball(world, {2, 0.5f});
    rolling.set_velocity({2, 0});
    free.set_velocity({2, 0});
    float dead_top = 0, lively_top = 0;
    for (int i = 0; i < 90; ++i) {
        world.step(frame);
        if (i < 55) continue;
        dead_top = std::max<float>(dead_top, dead.position().y);
        lively_top = std::max<float>(lively_top, lively.position().y);
    }
    REQUIRE(dead_top < 0.52f);
    REQUIRE(lively_top > 2.0f);
    REQUIRE(carried.velocity().x == Approx(3).epsilon(0.02));  // against the order of the points
    REQUIRE(free.velocity().x > 1.0f);
    REQUIRE(std::fabs(rolling.velocity().x) < 0.1f);
}

TEST_CASE("surfaces of segments can be changed at any moment and wake bodies that rest on them") {
    World world;
    Shape ground = add_ground(world, 2);
    Body box = add_slider(world, 15, 0);
    run(world, 2.0f);
    REQUIRE_FALSE(box.awake());
    ground.set_segment_surface(1, SegmentSurface{.surface_speed = -2});
    REQUIRE(box.awake());
    run(world, 1.0f);
    REQUIRE(box.velocity().x == Approx(2).epsilon(0.02));
    ground.set_segment_surface(1, {});
    run(world, 1.0f);
    REQUIRE(box.velocity().x == Approx(0).margin(0.01));
    REQUIRE(ground.segment_surface(1).friction == ground.friction());
}

TEST_CASE("the surface of the shape holds for segments without one of their own") {
    World world;
    Shape ground = add_ground(world, 3, {.friction = 0.3f, .material = 2});
    REQUIRE(ground.segment_count() == 3);
    REQUIRE_FALSE(ground.segment_surface_override(1));
    const SegmentSurface ice = {.friction = 0.01f, .restitution = 0.5f, .material = 7};
    ground.set_segment_surface(1, ice);
    REQUIRE(ground.segment_surface_override(1) == ice);
    REQUIRE(ground.segment_surface(1) == ice);
    ground.set_friction(0.8f);
    ground.set_material(3);
    REQUIRE(ground.segment_surface(0).friction == 0.8f);
    REQUIRE(ground.segment_surface(0).material == 3);
    REQUIRE(ground.segment_surface(1) == ice);
    ground.set_segment_surfaces({});
    REQUIRE_FALSE(ground.segment_surface_override(1));
    REQUIRE(ground.segment_surface(1).friction == 0.8f);
}

TEST_CASE("contacts and events and callbacks say which segment and material") {
    World world({.persist_events = true});
    Shape ground = add_ground(world, 3, {.hit_events = true, .material = 2});
    ground.set_segment_surface(2, SegmentSurface{.material = 70});
    Body box = add_slider(world, 25, 0);
    box.set_position({25, 1.5f});
    uint32_t part = 99, material = 99;
    world.set_before_solve([&](ContactEdit& edit) {
        const bool first = edit.shape_a == ground;
        part = first ? edit.part_a : edit.part_b;
        material = first ? edit.material_a : edit.material_b;
    });
    bool began = false, hit = false, persisted = false;
    for (int i = 0; i < 60; ++i) {
        world.step(frame);
        const auto look = [&](const auto& events, bool& seen) {
            for (const auto& event : events) {
                const bool first = event.shape_a == ground.id();
                REQUIRE((first ? event.part_a : event.part_b) == 2);
                REQUIRE((first ? event.part_b : event.part_a) == 0);
                REQUIRE((first ? event.material_a : event.material_b) == 70);
                REQUIRE((first ? event.material_b : event.material_a) == 9);
                seen = true;
            }
        };
        look(world.events().contact_begin, began);
        look(world.events().contact_hit, hit);
        look(world.events().contact_persist, persisted);
    }
    REQUIRE(began);
    REQUIRE(hit);
    REQUIRE(persisted);
    REQUIRE(part == 2);
    REQUIRE(material == 70);
    bool listed = false;
    for (const Contact& contact : box.contacts()) {
        REQUIRE(contact.part_a + contact.part_b == 2);
        REQUIRE(contact.material_a + contact.material_b == 79);
        listed = true;
    }
    REQUIRE(listed);
}

TEST_CASE("a value of a segment that is infinity follows that of the chain") {
    World world;
    Shape ground = add_ground(world, 3, {.friction = 0.5f, .material = 3});
    SegmentSurface ice = surface_of_shape;
    ice.friction = 0;
    ground.set_segment_surface(1, ice);
    REQUIRE(ground.segment_surface_override(1) == ice);
    REQUIRE(ground.segment_surface_overrides() ==
            std::vector<SegmentSurface>{surface_of_shape, ice, surface_of_shape});
    REQUIRE(ground.segment_surface(1) == SegmentSurface{.friction = 0, .material = 3});
    ground.set_restitution(0.25f);
    ground.set_surface_speed(-2);
    REQUIRE(ground.segment_surface(1).restitution == 0.25f);
    REQUIRE(ground.segment_surface(1).surface_speed == -2);
    REQUIRE(ground.segment_surface(1).friction == 0);
    Body rough = add_slider(world, 2, 0), slider = add_slider(world, 12);
    run(world, 1.0f);
    REQUIRE(std::fabs(rough.velocity().x) == Approx(2).epsilon(0.01));
    REQUIRE(slider.velocity().x == Approx(5).epsilon(0.001));
    const World copy = world.clone();
    ground.set_segment_surface(1, surface_of_shape);
    REQUIRE_FALSE(ground.segment_surface_override(1));
    REQUIRE(ground.segment_surface_overrides().empty());
    world.restore(copy);
    REQUIRE(ground.segment_surface_override(1) == ice);
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("surfaces stay with the numbers of segments when points change") {
    World world;
    Shape ground = add_ground(world, 3);
    const SegmentSurface ice = {.friction = 0};
    ground.set_segment_surface(2, ice);
    Chain chain = std::get<Chain>(ground.geometry());
    chain.points.push_back({40, 1});
    ground.set_vertices(chain.points);
    REQUIRE(ground.segment_count() == 4);
    REQUIRE(ground.segment_surface_override(2) == ice);
    REQUIRE_FALSE(ground.segment_surface_override(3));
    chain.points.resize(3);
    ground.set_vertices(chain.points);
    REQUIRE(ground.segment_count() == 2);
    chain.points.push_back({30, 0});
    ground.set_vertices(chain.points);
    REQUIRE(ground.segment_surface_override(2) == ice);
    Body slider = add_slider(world, 22);
    run(world, 0.5f);
    REQUIRE(slider.velocity().x == Approx(5).epsilon(0.001));
    ground.set_geometry(Box{});
    ground.set_geometry(chain);
    REQUIRE_FALSE(ground.segment_surface_override(2));
}

TEST_CASE("surfaces of segments belong to the state and end with the chain") {
    World world;
    Shape ground = add_ground(world, 3), other = add_ground(world, 2);
    other.set_segment_surface(0, SegmentSurface{.friction = 0.25f});
    ground.set_segment_surface(1, SegmentSurface{.friction = 0});
    add_slider(world, 12);
    const auto bytes = saved(world);
    const World copy = world.clone();
    run(world, 1.0f);
    const uint64_t end = world.hash();
    ground.set_segment_surface(1, {});
    world.restore(bytes);
    REQUIRE(ground.segment_surface(1).friction == 0.0f);
    run(world, 1.0f);
    REQUIRE(world.hash() == end);
    world.restore(copy);
    run(world, 1.0f);
    REQUIRE(world.hash() == end);
    ground.destroy();
    REQUIRE(other.segment_surface(0).friction == 0.25f);
    Shape next = add_ground(world, 3);
    REQUIRE(next.index() == ground.index());
    REQUIRE_FALSE(next.segment_surface_override(1));
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("saved worlds with surfaces of segments bear damage") {
    World world;
    Shape ground = add_ground(world, 3);
    for (uint32_t i = 0; i < 3; ++i)
        ground.set_segment_surface(i, SegmentSurface{.friction = float(i)});
    add_slider(world, 12);
    run(world, 0.1f);
    check_flipped_bits(saved(world), 5, 200, [](World& restored) {
        for (const Shape& shape : restored.shapes())
            if (shape.type() == ShapeType::chain)
                for (uint32_t i = 0; i < shape.segment_count(); ++i) (void)shape.segment_surface(i);
    });
}

TEST_CASE("wrong surfaces of segments are refused and change nothing") {
    World world;
    Shape ground = add_ground(world, 3);
    const auto refused = [&](auto act, const char* what) {
        REQUIRE_THROWS_WITH(act(), contains(what));
    };
    refused([&] { ground.set_segment_surface(3, {}); }, "segment = 3: expected a number below 3");
    refused([&] { (void)ground.segment_surface(7); }, "segment = 7");
    refused([&] { (void)ground.segment_surface_override(7); }, "segment = 7");
    refused([&] { ground.set_segment_surface(0, SegmentSurface{.friction = -1}); }, "friction");
    refused([&] { ground.set_segment_surface(0, SegmentSurface{.friction = nan}); }, "friction");
    refused([&] { ground.set_segment_surface(0, SegmentSurface{.restitution = 2}); },
            "restitution");
    refused([&] { ground.set_segment_surface(0, SegmentSurface{.surface_speed = -infinity}); },
            "surface_speed");
    refused([&] { ground.set_segment_surfaces(std::vector<SegmentSurface>(2)); },
            "expected none or 3");
    REQUIRE_FALSE(ground.segment_surface_override(0));
    Shape box = add_box(world, {0, 9}).shapes()[0];
    refused([&] { (void)box.segment_count(); }, "segment_count");
    refused([&] { box.set_segment_surface(0, {}); }, "set_segment_surface");
    refused([&] { box.set_segment_surfaces({}); }, "set_segment_surfaces");
}

TEST_CASE("points at the same place make no segment and no number") {
    World world;
    Shape ground = world.create_body({.type = BodyType::static_body})
                       .add(Chain{{{0, 0}, {10, 0}, {10, 0}, {20, 0}}});
    REQUIRE(ground.segment_count() == 2);
    ground.set_segment_surface(1, SegmentSurface{.friction = 0});
    Body slider = add_slider(world, 12);
    run(world, 0.5f);
    REQUIRE(slider.velocity().x == Approx(5).epsilon(0.001));
}

}  // namespace chain_surfaces_test
