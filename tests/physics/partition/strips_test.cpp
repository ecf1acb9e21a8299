// Heaps cut into strips: the nodes and what is solved after what, and that several threads end with
// what one thread ends with.

#include <partition/strips.h>

#include <algorithm>
#include <atomic>
#include <random>
#include <vector>

#include "catch.h"
#include "scenes.h"
#include "thorough.h"
#include "world_inside.h"

namespace strips_test {

using namespace scenes;
using namespace fettle::physics::detail;

namespace {

bool is_above(uint32_t node, uint32_t below) {
    while (below > node) below /= 2;
    return below == node;
}

std::vector<StripSample> samples_in(float width, float height, int count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> x(0.0f, width), y(0.0f, height), work(1.0f, 9.0f);
    std::vector<StripSample> samples;
    for (int i = 0; i < count; ++i) samples.push_back({{x(random), y(random)}, work(random)});
    return samples;
}

/// Enough for four strips, with all that needs more than wide contacts: joints across the cuts, a
/// heavy beam that lies on everything, bouncing, ellipses, locked axes, a platform that moves on
/// its own with things that hang from it. `middle`: x of the heap.
void add_heap(World& world, float middle) {
    Body platform = world.create_body(
        {.type = BodyType::kinematic_body, .position = {middle, 30}, .velocity = {2, 0}});
    platform.add(Box{.width = 150, .height = 1});
    world.create_body({.position = {middle, 18}})
        .add(Box{.width = 160, .height = 1}, {.density = 30});
    Body before = platform;
    for (int i = 0; i < 3600; ++i) {
        const Vec2 at = {middle + 0.8f * float(i % 180) - 72.0f, 0.4f + 0.82f * float(i / 180)};
        Body body = world.create_body({.position = at, .locked_rotation = i % 31 == 0});
        const ShapeDef surface = {.restitution = i % 29 == 0 ? 0.5f : 0.0f,
                                  .hit_events = i % 11 == 0};
        if (i % 17 == 3)
            body.add(Circle{.radius = 0.4f}, surface);
        else if (i % 23 == 5)
            body.add(Ellipse{.radius_x = 0.4f, .radius_y = 0.3f}, surface);
        else
            body.add(Box{.width = 0.8f, .height = 0.8f}, surface);
        if (i % 180 > 60 && i % 180 < 120 && i % 3 > 0)
            world.create_revolute_joint({.body_a = before.id(), .body_b = body.id()})
                .set_break_force(i % 7 == 0 ? 50.0f : infinity);
        if (i >= 3420 && i % 20 == 0)
            world.create_distance_joint({.body_a = platform.id(), .body_b = body.id()});
        before = body;
    }
}

struct Course {
    std::vector<uint64_t> hashes;
    uint32_t strips = 1;
    bool has_hub = false;
    size_t broken = 0, hits = 0;
};

/// Runs with `threads` threads, however many processors there are.
Course run_with(int threads, int steps, int heaps = 1) {
    ThreadPool pool(threads, threads);
    World world({.sleeping = false});
    world.create_body({.type = BodyType::static_body})
        .add(Box{.width = 400.0f * float(heaps), .height = 2, .center = {0, -1}});
    for (int i = 0; i < heaps; ++i) add_heap(world, 200.0f * float(i));
    WorldInside::of(world).threads = threads > 1 ? &pool : nullptr;
    Course course;
    for (int i = 0; i < steps; ++i) {
        world.step(frame);
        course.strips = std::max(course.strips, WorldInside::of(world).strips.count());
        course.has_hub |= !WorldInside::of(world).hubs.empty();
        course.hashes.push_back(world.hash());
        course.broken += world.events().joint_broke.size();
        course.hits += world.events().contact_hit.size();
    }
    REQUIRE_FALSE(world.validate());
    return course;
}

}  // namespace

TEST_CASE("a constraint between two strips belongs to the lowest node above both") {
    for (uint32_t a = 8; a < 16; ++a) {
        for (uint32_t b = 8; b < 16; ++b) {
            const uint32_t node = above_both(StripNode(a), StripNode(b));
            REQUIRE(is_above(node, a));
            REQUIRE(is_above(node, b));
            for (uint32_t lower = node + 1; lower < 16; ++lower)
                REQUIRE_FALSE((is_above(lower, a) && is_above(lower, b)));
        }
    }
}

TEST_CASE("every node is in one section and comes after all that is below it") {
    for (uint32_t strips = 1; strips <= most_strips; strips *= 2) {
        for (uint32_t parts = 1; parts <= strips; parts *= 2) {
            const Sections sections(strips, parts);
            std::vector<uint32_t> order;
            SectionLoop(sections, nullptr, [&](uint32_t section) {
                order.push_back(section);
            }).run();
            REQUIRE(order.size() == sections.size());
            std::vector<int> turn(2 * strips, -1);
            for (size_t i = 0; i < order.size(); ++i) {
                const StripNodes nodes = sections.nodes_of(order[i]);
                for (uint32_t node = nodes.begin; node < nodes.end; ++node) {
                    REQUIRE(turn[node] == -1);
                    REQUIRE(sections.of(StripNode(node)) == order[i]);
                    turn[node] = int(i);
                }
            }
            for (uint32_t node = 1; node < 2 * strips; ++node) {
                REQUIRE(turn[node] >= 0);
                if (2 * node >= 2 * strips) continue;
                REQUIRE(turn[node] > turn[2 * node]);
                REQUIRE(turn[node] > turn[2 * node + 1]);
            }
        }
    }
}

TEST_CASE("threads never solve a section and one above it at the same time") {
    ThreadPool pool(4, 4);
    const Sections sections(8, 4);
    std::vector<std::atomic<int>> begun(16), done(16);
    for (int round = 1; round <= 200; ++round) {
        std::atomic<bool> wrong = false;
        SectionLoop(sections, &pool, [&](uint32_t section) {
            const StripNodes nodes = sections.nodes_of(section);
            for (uint32_t node = nodes.begin; node < nodes.end; ++node) {
                ++begun[node];
                for (uint32_t below = 2 * node; below < 16; ++below)
                    if (is_above(node, below) && done[below] != round) wrong = true;
                ++done[node];
            }
        }).run();
        REQUIRE_FALSE(wrong);
    }
    for (uint32_t node = 1; node < 16; ++node) REQUIRE(begun[node] == 200);
}

TEST_CASE("strips hold about as much work each and lie across the longer side") {
    auto wide = samples_in(100, 60, 4000);
    Strips strips;
    strips.cut(wide, 8);
    std::vector<float> work(16);
    float all = 0.0f;
    for (const StripSample& sample : wide) {
        work[strips.leaf_at(sample.place)] += sample.work;
        all += sample.work;
    }
    for (uint32_t leaf = 8; leaf < 16; ++leaf) REQUIRE(work[leaf] == Approx(all / 8).epsilon(0.03));
    REQUIRE(strips.leaf_at({1, 1}) == strips.leaf_at({1, 59}));
    REQUIRE(strips.leaf_at({1, 1}) < strips.leaf_at({99, 1}));

    auto tall = samples_in(10, 60, 4000);
    strips.cut(tall, 2);
    REQUIRE(strips.leaf_at({1, 1}) == strips.leaf_at({9, 1}));
    REQUIRE(strips.leaf_at({1, 1}) < strips.leaf_at({1, 59}));
}

TEST_CASE("strips are as good with a body that is far away") {
    auto samples = samples_in(100, 60, 4000);
    samples[17].place = {3e7f, 1};
    samples[90].place = {-2e5f, 1};
    Strips strips;
    strips.cut(samples, 4);
    std::vector<int> count(8);
    for (const StripSample& sample : samples) ++count[strips.leaf_at(sample.place)];
    for (uint32_t leaf = 4; leaf < 8; ++leaf) {
        REQUIRE(count[leaf] > 900);
        REQUIRE(count[leaf] < 1100);
    }
}

TEST_CASE("strips keep the order of bodies in a row") {
    std::vector<StripSample> rows;
    for (int i = 0; i < 400; ++i) rows.push_back({{float(i % 40), 0.25f * float(i / 40)}, 1});
    Strips strips;
    strips.cut(rows, 2);
    REQUIRE(strips.leaf_at({0, 0}) == strips.leaf_at({39, 0}));
    REQUIRE(strips.leaf_at({0, 0}) < strips.leaf_at({0, 2.25f}));
}

TEST_CASE("bodies at one place are all in a valid strip") {
    Strips strips;
    std::vector<StripSample> one_place(40, StripSample{{3, 3}, 1});
    strips.cut(one_place, 4);
    for (const Vec2& at : {Vec2{3, 3}, Vec2{-1e8f, 0}, Vec2{1e8f, 5}}) {
        REQUIRE(strips.leaf_at(at) >= 4);
        REQUIRE(strips.leaf_at(at) < 8);
    }
    strips.cut({}, 4);
    REQUIRE(strips.count() == 1);
    REQUIRE(strips.leaf_at({0, 0}) == 1);
    REQUIRE(Strips::count_for(0) == 1);
    REQUIRE(Strips::count_for(2047) == 1);
    REQUIRE(Strips::count_for(2048) == 2);
    REQUIRE(Strips::count_for(1'000'000) == most_strips);
}

TEST_CASE("a heap of everything ends the same however many threads share out its strips") {
    const Course one = run_with(1, 70);
    REQUIRE(one.strips >= 4);
    REQUIRE(one.has_hub);
    REQUIRE(one.broken > 0);
    REQUIRE(one.hits > 0);
    for (const int threads : {2, 3, 4, 8}) {
        if (!thorough() && threads != 3) continue;
        const Course several = run_with(threads, 70);
        REQUIRE(several.hashes == one.hashes);
        REQUIRE(several.broken == one.broken);
        REQUIRE(several.hits == one.hits);
    }
}

TEST_CASE("a heap larger than the cache ends the same however many threads share out its strips") {
    constexpr int steps = 12;
    const Course one = run_with(1, steps, 5);
    REQUIRE(one.strips == most_strips);
    REQUIRE(run_with(3, steps, 5).hashes == one.hashes);
    if (thorough()) REQUIRE(run_with(4, steps, 5).hashes == one.hashes);
}

TEST_CASE("the index of bodies stays valid when strips sort an unordered list") {
    World world;
    world.set_gravity({0, 0});
    std::vector<Body> row;
    for (int i = 0; i < 2400; ++i) {
        row.push_back(world.create_body({.position = {float(i), 0}, .velocity = {0, 1}}));
        row.back().add(Circle{.radius = 0.3f});
        if (i > 0)
            world.create_distance_joint(
                {.body_a = row[size_t(i) - 1].id(), .body_b = row.back().id()});
    }
    row[10].destroy();  // the last takes its place in the list
    for (int i = 0; i < 66; ++i) world.step(1.0f / 60.0f);
    REQUIRE(WorldInside::of(world).strips.count() > 1);
    REQUIRE_FALSE(world.validate());
    row[20].destroy();
    world.step(1.0f / 60.0f);
    REQUIRE_FALSE(world.validate());
}

}  // namespace strips_test
