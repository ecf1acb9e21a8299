#include <threads/pool.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <numeric>
#include <set>
#include <thread>
#include <vector>

#include "catch.h"
#include "scenes.h"
#include "thorough.h"

namespace threads_test {

using namespace scenes;
using fettle::physics::detail::parallel_for;
using fettle::physics::detail::ThreadPool;

namespace {

/// Numbers of steps are divided by this. The thread sanitizer makes a step ten times as long, and
/// finds a race in few of them.
#ifdef __SANITIZE_THREAD__
const int fewer = 4;
#else
const int fewer = thorough() ? 1 : 2;
#endif

Body floor_of(World& world) {
    Body floor = world.create_body({.type = BodyType::static_body});
    floor.add(Box{.width = 8000, .height = 2, .center = {0, -1}});
    return floor;
}

/// One island too large for a block, and many small ones: stacks that lean.
void pyramid_and_stacks(World& world) {
    floor_of(world);
    for (int row = 0; row < 70; ++row) {
        for (int i = 0; i < 70 - row; ++i) {
            const float x = -200.0f + 1.01f * float(i) + 0.5f * float(row);
            world.create_body({.position = {x, 0.5f + float(row)}}).add(Box{});
        }
    }
    for (int stack = 0; stack < 300; ++stack) {
        for (int k = 0; k < 5; ++k) {
            const Vec2 at = {3.0f * float(stack) + 0.13f * float(k % 3), 0.5f + 1.01f * float(k)};
            world.create_body({.position = at, .angle = 0.02f * float(k)}).add(Box{});
        }
    }
}

/// Everything that needs more than wide contacts: joints, bouncing, locked axes, a platform that
/// moves, sensors, shapes of many kinds, bodies that are too fast.
void menagerie(World& world) {
    floor_of(world);
    Body platform = world.create_body(
        {.type = BodyType::kinematic_body, .position = {0, 3}, .velocity = {1, 0}});
    platform.add(Box{.width = 30, .height = 0.5f});
    Body before = platform;
    for (int i = 0; i < 900; ++i) {
        const Vec2 at = {0.7f * float(i % 60) - 21.0f, 4.0f + 0.9f * float(i / 60)};
        Body body = world.create_body({.position = at, .angle = 0.1f * float(i)});
        if (i % 4 == 0)
            body.add(Circle{.radius = 0.3f}, {.restitution = i % 8 == 0 ? 0.6f : 0.0f});
        else if (i % 4 == 1)
            body.add(Polygon{.vertices = {{-0.3f, -0.3f}, {0.4f, -0.2f}, {0, 0.4f}}},
                     {.hit_events = i % 3 == 0});
        else
            body.add(Box{.width = 0.6f, .height = 0.4f}, {.sensor = i % 50 == 2});
        if (i % 45 == 3) body.set_locked_rotation(true);
        if (i % 60 == 5) body.set_velocity({0, -200});
        if (i % 90 > 80) {
            world.create_revolute_joint({.body_a = before.id(), .body_b = body.id()});
        }
        before = body;
    }
}

std::vector<uint64_t> history(void (*fill)(World&), int threads, int steps) {
    World world({.sleeping = true});
    world.set_threads(threads);
    fill(world);
    std::vector<uint64_t> hashes;
    for (int i = 0; i < steps; ++i) {
        world.step(frame);
        hashes.push_back(world.hash());
        uint64_t told = world.events().contact_begin.size();
        for (const auto& begin : world.events().contact_begin)
            told = told * 31 + begin.shape_a.index * 7 + begin.shape_b.index;
        for (const auto& hit : world.events().contact_hit)
            told = told * 31 + hit.shape_a.index * 7 + hit.shape_b.index;
        hashes.push_back(told);
    }
    REQUIRE(world.threads() == threads);
    REQUIRE_FALSE(world.validate());
    return hashes;
}

}  // namespace

TEST_CASE("a pool does every block once whatever the number of threads") {
    for (const int threads : {1, 2, 3, 8}) {
        ThreadPool pool(threads, threads);
        REQUIRE(pool.threads() == threads);
        for (int round = 0; round < 300; ++round) {
            const auto count = uint32_t(round % 37);
            std::vector<std::atomic<int>> done(count);
            pool.run(count, [&](uint32_t block) { ++done[block]; });
            for (const auto& times : done) REQUIRE(times == 1);
        }
    }
}

TEST_CASE("an exception in a block reaches the caller of the pool after all blocks are done") {
    ThreadPool pool(3, 3);
    for (int round = 0; round < 100; ++round) {
        std::atomic<int> done = 0;
        REQUIRE_THROWS_AS(pool.run(20,
                                   [&](uint32_t block) {
                                       ++done;
                                       if (block % 7 == 0) throw std::bad_alloc();
                                   }),
                          std::bad_alloc);
        REQUIRE(done == 20);
    }
}

TEST_CASE("no more threads work than there are processors") {
    ThreadPool pool(8, 2);
    REQUIRE(pool.threads() == 8);
    std::mutex mutex;
    std::set<std::thread::id> seen;
    for (int round = 0; round < 200; ++round) {
        pool.run(16, [&](uint32_t) {
            const std::lock_guard lock(mutex);
            seen.insert(std::this_thread::get_id());
        });
    }
    REQUIRE(seen.size() <= 2);
    REQUIRE(fettle::physics::detail::processors() >= 1);
}

TEST_CASE("pieces cover a range once") {
    ThreadPool pool(3, 3);
    for (size_t size : {0, 1, 7, 8, 9, 1000}) {
        std::vector<int> times(size);
        parallel_for(&pool, size, 8, [&](size_t begin, size_t end) {
            for (size_t i = begin; i < end; ++i) ++times[i];
        });
        REQUIRE(std::accumulate(times.begin(), times.end(), size_t{0}) == size);
        REQUIRE(std::count(times.begin(), times.end(), 1) == std::ptrdiff_t(size));
    }
}

TEST_CASE("a large island and many small ones end the same on one thread and two and four") {
    const auto one = history(pyramid_and_stacks, 1, 40 / fewer);
    if (thorough()) REQUIRE(history(pyramid_and_stacks, 2, 40 / fewer) == one);
    REQUIRE(history(pyramid_and_stacks, 4, 40 / fewer) == one);
}

TEST_CASE("joints and platforms and bouncing end the same on one thread and two and four") {
    const auto one = history(menagerie, 1, 120 / fewer);
    if (thorough()) REQUIRE(history(menagerie, 2, 120 / fewer) == one);
    REQUIRE(history(menagerie, 4, 120 / fewer) == one);
}

TEST_CASE(
    "islands that meet and part end the same with blocks of earlier steps and with new ones") {
    // A saved world has no blocks: it makes them anew. The ram goes through many stacks.
    World world({.sleeping = false});
    floor_of(world);
    for (int stack = 0; stack < 800; ++stack) {
        for (int k = 0; k < 6; ++k)
            world.create_body({.position = {2.0f * float(stack), 0.5f + float(k)}}).add(Box{});
    }
    Body ram = world.create_body({.position = {-10, 3}, .velocity = {60, 0}});
    ram.add(Box{.width = 4, .height = 4}, {.density = 50});
    World anew;
    std::vector<std::byte> saved;
    for (int i = 0; i < 60; ++i) {
        world.set_threads(1 + i % 3);
        if (i % fewer != 0) {
            world.step(frame);
            continue;
        }
        saved.clear();
        world.save(saved);
        anew.restore(saved);
        world.step(frame);
        anew.step(frame);
        REQUIRE(world.hash() == anew.hash());
    }
    REQUIRE(world.statistics().touching > 4000);
    REQUIRE(ram.position().x > 20.0f);
}

TEST_CASE("the number of threads can be changed at any time and is not copied or restored") {
    World world, other;
    pyramid_and_stacks(world);
    pyramid_and_stacks(other);
    world.set_threads(2);
    const World snapshot = world.clone();
    REQUIRE(snapshot.threads() == 1);
    for (int i = 0; i < 12; ++i) {
        if (i == 4) world.set_threads(4);
        if (i == 8) world.set_threads(1);
        world.step(frame);
        other.step(frame);
        REQUIRE(world.hash() == other.hash());
    }
    world.set_threads(3);
    world.restore(snapshot);
    REQUIRE(world.threads() == 3);
    world.step(frame);
    REQUIRE_THROWS_AS(world.set_threads(0), std::invalid_argument);
    REQUIRE_THROWS_AS(world.set_threads(65), std::invalid_argument);
    REQUIRE(world.threads() == 3);
}

TEST_CASE(
    "bodies that come and go and race against walls end the same on one thread and two and four") {
    const auto run = [](int threads, bool filtered) {
        World world;
        floor_of(world);
        world.set_threads(threads);
        if (filtered) world.set_filter([](const Shape&, const Shape&) { return true; });
        for (int i = 0; i < 40; ++i) {
            world.create_body({.type = BodyType::static_body, .position = {7.0f * float(i), 4}})
                .add(Box{.width = 0.05f, .height = 8});
        }
        std::vector<Body> bodies;
        std::vector<uint64_t> hashes;
        for (int step = 0; step < 90 / fewer; ++step) {
            for (int i = 0; i < 30; ++i) {
                const Vec2 at = {1.0f + 0.6f * float(i) + 7.0f * float(step % 30), 3};
                const Vec2 velocity = {i % 3 == 0 ? 150.0f : -20.0f, 0.1f * float(i)};
                bodies.push_back(world.create_body(
                    {.position = at, .velocity = velocity, .bullet = i % 7 == 0}));
                bodies.back().add(Box{.width = 0.4f, .height = 0.4f});
                if (step < 20 / fewer || i % 2 == 0) continue;
                const size_t old = size_t(step * 31 + i * 17) % bodies.size();
                bodies[old].destroy();
                bodies.erase(bodies.begin() + std::ptrdiff_t(old));
            }
            world.step(frame);
            hashes.push_back(world.hash());
        }
        REQUIRE_FALSE(world.validate());
        for (const Body& body : bodies) REQUIRE(body.position().x < 400.0f);
        return hashes;
    };
    const auto one = run(1, false);
    if (thorough()) REQUIRE(run(2, false) == one);
    REQUIRE(run(4, false) == one);
    REQUIRE(run(4, true) == one);
}

}  // namespace threads_test
