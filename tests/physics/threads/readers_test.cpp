#include <thread>

#include "catch.h"
#include "one_of_each.h"

namespace readers_test {

using namespace scenes;

namespace {

/// The number of all that every kind of query finds.
size_t asked(const World& world, const Shape& shape, const Form& box, const Form& corner) {
    size_t found = 0;
    QueryFilter filter;
    filter.accept = [&found](const Shape&) {
        ++found;
        return true;
    };
    const Aabb all = {{-50, -50}, {50, 50}};
    found += world.query_aabb(all, filter).size();
    found += world.cast_ray_all({-9, 0.5f}, {9, 0.5f}, filter).size();
    found += world.query_overlap(Circle{.radius = 5}, {}, filter).size();
    found += world.query_overlap(shape, filter).size();
    found += world.cast_shape(shape, {9, 0}, filter).has_value();
    found += world.cast_shape(corner, {{-9, 1}, 1}, {9, 0}, filter).has_value();
    found += world.closest({0, 9}, 99, filter).has_value();
    const auto count = [&](const Shape& each) {
        found += distance(each, shape).distance < 3;
        found += distance(box, {}, corner, {each.world_center(), 0}).distance < 3;
    };
    world.visit_aabb(all, count, filter);
    world.visit_overlap(box, {{0, 1}, 0.3f}, count, filter);
    world.visit_overlap(
        corner, {}, [&](const Shape& each) { world.visit_overlap(each, count); }, filter);
    return found + world.bodies().size() + world.contacts().size();
}

}  // namespace

TEST_CASE("several threads may read one world at the same time") {
    World world;
    const Things things = make_things(world);
    world.step(1.0f / 60);
    const Form box = Box{12, 3}, corner = Concave{{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}};
    const size_t alone = asked(world, things.box, box, corner);
    REQUIRE(alone > 40);
    std::vector<std::thread> threads;
    std::vector<size_t> found(4);
    for (size_t& count : found) {
        threads.emplace_back([&] {
            for (int i = 0; i < 50; ++i) count += asked(world, things.box, box, corner);
        });
    }
    for (std::thread& thread : threads) thread.join();
    for (const size_t count : found) CHECK(count == 50 * alone);
    world.wake_all();  // nothing is locked any more
}

}  // namespace readers_test
