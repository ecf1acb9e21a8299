#include "saved_worlds.h"

namespace shape_snapshot_test {

using namespace scenes;

namespace {

/// Chain, concave polygons, ellipses, polygons of many vertices, all on each other.
void build_heap(World& world) {
    Body ground = world.create_body({.type = BodyType::static_body});
    std::vector<Vec2> points;
    for (int i = 0; i <= 40; ++i)
        points.push_back({float(i) * 0.5f - 10.0f, 0.02f * float((i - 20) * (i - 20))});
    ground.add(Chain{points});
    for (int i = 0; i < 24; ++i) {
        Body body = world.create_body(
            {.position = {float(i % 6) - 2.5f, 1.5f + float(i / 6)}, .angle = 0.4f * float(i)});
        if (i % 4 == 0) body.add(Ellipse{0.5f, 0.3f});
        if (i % 4 == 1)
            body.add(
                Concave{{{0, 0}, {0.8f, 0}, {0.8f, 0.3f}, {0.3f, 0.3f}, {0.3f, 0.8f}, {0, 0.8f}}});
        if (i % 4 == 2) body.add(Polygon{ellipse_points(0.4f, 0.3f, 20)});
        if (i % 4 == 3) body.add(Box{.width = 0.7f, .height = 0.7f}, {.restitution = 0.5f});
    }
}

}  // namespace

TEST_CASE("a heap of every kind of shape goes on bit for bit after restoring") {
    World world;
    build_heap(world);
    run(world, 1.0f);
    const auto bytes = saved(world);
    run(world, 1.5f);
    const uint64_t expected = world.hash();
    const auto after = saved(world);
    world.restore(bytes);
    REQUIRE_FALSE(world.validate());
    run(world, 1.5f);
    REQUIRE(world.hash() == expected);
    World other;
    other.restore(bytes);
    run(other, 1.5f);
    REQUIRE(other.hash() == expected);
    REQUIRE(other.shape_count() == 25);
    // Edits that were not yet refreshed are saved as well.
    for (Shape shape : world.shapes())
        if (shape.type() == ShapeType::chain)
            shape.set_vertices(std::vector<Vec2>{{-9, 0}, {9, 0}, {10, 4}});
    World edited;
    edited.restore(saved(world));
    run(world, 0.5f);
    run(edited, 0.5f);
    REQUIRE(world.hash() == edited.hash());
    REQUIRE_FALSE(edited.validate());
}

TEST_CASE("flipped bits of every kind of shape are refused or leave a world that can be stepped") {
    World world;
    build_heap(world);
    run(world, 0.5f);
    check_flipped_bits(saved(world), 7, 1500, [](World& target) {
        for (Shape shape : target.shapes()) {
            shape.aabb();
            shape.area();
            shape.world_vertices();
        }
        (void)target.cast_ray({-5, 3}, {5, 0});
    });
}

TEST_CASE("very small and very large shapes are refused or leave a valid world") {
    for (const float size : {1e-6f, 1e-5f, 1e-3f, 1.0f, 1e3f, 1e6f}) {
        World world;
        Body ground = world.create_body({.type = BodyType::static_body});
        int made = 0;
        const auto attempt = [&](const Geometry& geometry) {
            try {
                Body body = world.create_body({.position = {0, 2 * size}});
                body.add(geometry);
                ++made;
            } catch (const std::invalid_argument&) {
            }
        };
        try {
            ground.add(Chain{{{-10 * size, 0}, {0, 0}, {0.5f * size, 0}, {10 * size, size}}});
        } catch (const std::invalid_argument&) {
        }
        attempt(Ellipse{size, 0.01f * size});
        attempt(Ellipse{size, size});
        attempt(Concave{{{0, 0}, {size, 0}, {size, size}, {0.5f * size, 0.1f * size}, {0, size}}});
        attempt(Chain{{{0, 0}, {size, 0}}});
        const std::vector<Vec2> round = ellipse_points(size, size, 30);
        attempt(Polygon{round});
        attempt(Polygon{round, size});
        for (int i = 0; i < 60; ++i) world.step(frame);
        INFO(size << " m: " << made << " made");
        if (size >= 1e-5f) CHECK(made >= 3);
        REQUIRE_FALSE(world.validate());
    }
}

}  // namespace shape_snapshot_test
