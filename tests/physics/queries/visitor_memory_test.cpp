#include <new>
#include <thread>

#include "catch.h"
#include "memory_end.h"
#include "scenes.h"

namespace visitor_memory_test {

using namespace scenes;

TEST_CASE("a visitor allocates nothing") {
    World world;
    world.create_body({.type = BodyType::static_body}).add(Box{40, 1});
    for (int i = 0; i < 20; ++i) add_ball(world, {2.0f * float(i) - 20.0f, 1});
    const std::vector<Vec2> angle = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
    world.create_body({.position = {-1, 3}}).add(Concave{angle});
    run(world, 0.5f);
    const Aabb all = {{-30, -5}, {30, 20}};
    const Position left = {-30, 0.5f}, right = {30, 0.9f};
    int finds = 0;
    const Form probe = Box{60, 2}, corner = Concave{angle};
    const Shape moved = world.shapes()[3];
    const ShapeId other = world.shapes()[5].id();
    const auto query = [&] {
        const auto count = [&finds, &world](const Shape& shape) {
            finds += &shape.world() == &world;
        };
        world.visit_aabb(all, count);
        world.visit_point({0, 3.5f}, count);
        world.visit_ray(left, right, [&](const RayHit& hit) { finds += hit.fraction < 1; });
        finds += world.cast_ray(left, right).has_value();
        finds += world.closest({0, 9}).has_value();
        // A query inside a visitor needs memory of its own.
        world.visit_overlap(probe, {{0, 1}, 0.1f}, [&](const Shape& found) {
            world.visit_overlap(found, count);
            world.visit_overlap(corner, {found.world_center(), 0}, count);
        });
        finds += world.cast_shape(corner, {{-20, 1}, 1}, {40, 0}).has_value();
        finds += world.cast_shape(moved, {40, 0}).has_value();
        finds += distance(moved, world.shape(other)).distance > 0.0f;
        finds += distance(probe, {}, corner, {{0, 9}, 1}).distance > 0.0f;
        finds += time_of_impact(probe, {{}, {{0, 9}, 0}}, corner, {{{0, 9}, 0}, {}}).has_value();
    };
    query();  // the memory of the thread for outlines
    const int once = finds;
    {
        const MemoryEnd end(0);
        query();
    }
    CHECK(finds == 2 * once);
    CHECK(once > 25);
}

namespace {

/// Asks a world when the thread has freed what it kept for queries.
struct Late {
    const World* world = nullptr;
    bool allocates = false;
    int finds = 0;

    int ask() const {
        int found = 0;
        const auto count = [&found](const Shape&) { ++found; };
        world->visit_overlap(Circle{9}, {}, count);
        world->visit_overlap(world->shapes()[0], count);
        return found;
    }
};

}  // namespace

TEST_CASE("a query works when the thread has ended what it keeps") {
    World world;
    for (int i = 0; i < 3; ++i) add_ball(world, {2.0f * float(i), 0});
    Late late{&world};
    const int found = late.ask();
    REQUIRE(found == 3);
    std::thread([&late] {
        struct AtTheEnd {
            Late* late = nullptr;
            ~AtTheEnd() {
                const Form probe = Circle{9};
                try {
                    const MemoryEnd end(0);
                    late->world->visit_overlap(probe, {}, [](const Shape&) {});
                } catch (const std::bad_alloc&) {
                    late->allocates = true;  // the memory of the thread is not used any more
                }
                late->finds = late->ask();
            }
        };
        thread_local AtTheEnd end;  // made before what a query keeps, and so destroyed after it
        end.late = &late;
        late.ask();
    }).join();
    CHECK(late.allocates);
    CHECK(late.finds == found);
}

}  // namespace visitor_memory_test
