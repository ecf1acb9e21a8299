#pragma once

// The world of both programs, and its measurement.

#include <fettle/physics/world.h>

#include <chrono>
#include <cstdio>

namespace example {

/// A heap of boxes in a basin.
inline void fill(fettle::physics::World& world) {
    using namespace fettle::physics;
    world.create_body({.type = BodyType::static_body})
        .add(Chain{.points = {{-30, 60}, {-25, 0}, {25, 0}, {30, 60}}});
    for (int i = 0; i < 2000; ++i)
        world.create_body({.position = {float(i % 40) - 20, 1.0f + float(i / 40)}})
            .add(Box{.width = 0.8f, .height = 0.8f});
}

/// Steps for two seconds and returns the hash of the world.
inline unsigned long long run(fettle::physics::World& world, const char* name) {
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < 120; ++i) world.step(1.0f / 60);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
    const unsigned long long hash = world.hash();
    std::printf("%s: %.2f ms a step, hash %016llx\n", name, time.count() / 120, hash);
    return hash;
}

/// Runs the heap in one thread and with four tasks of the scheduler, which must end in the same
/// bits. Returns what `main` returns. `name`: what runs the tasks.
inline int compare(fettle::physics::TaskScheduler& scheduler, const char* name) {
    fettle::physics::World alone, shared;
    fill(alone);
    fill(shared);
    shared.set_scheduler(&scheduler, 4);
    const unsigned long long expected = run(alone, "one thread");
    const bool same = run(shared, name) == expected;
    std::puts(same ? "the same to the last bit" : "different");
    return same ? 0 : 1;
}

}  // namespace example
