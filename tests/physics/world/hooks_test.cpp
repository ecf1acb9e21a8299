#include <fettle/physics/hooks.h>

#include <cstdlib>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>

#include "catch.h"
#include "scenes.h"
#include "world_inside.h"

namespace hooks_test {

// Messages of the library to the host, about all its worlds.

using namespace scenes;

namespace {

struct Log {
    std::string notes, warnings, errors;
    int lines = 0;

    Log() { set_log(add, this); }
    ~Log() { set_log(nullptr, nullptr); }
    Log(const Log&) = delete;
    Log& operator=(const Log&) = delete;

    static void add(void* user, LogLevel level, const char* text) {
        Log& log = *static_cast<Log*>(user);
        ++log.lines;
        std::string& all = level == LogLevel::note      ? log.notes
                           : level == LogLevel::warning ? log.warnings
                                                        : log.errors;
        all += std::string(text) + '\n';
    }
};

/// The function for failures, set as long as this lives.
struct Failures {
    std::string what;
    const World* world = nullptr;
    bool throws = false;

    Failures() { set_failure_function(add, this); }
    ~Failures() { set_failure_function(nullptr, nullptr); }
    Failures(const Failures&) = delete;
    Failures& operator=(const Failures&) = delete;

    static void add(void* user, const World& world, const char* what) {
        Failures& all = *static_cast<Failures*>(user);
        all.what = what;
        all.world = &world;
        if (all.throws) throw std::runtime_error("the host stops here");
    }
};

}  // namespace

TEST_CASE("the log reports what no result and no exception reports") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    Log log;
    World world;
    add_floor(world);
    Body box = add_box(world, {0, 0.5f});
    world.step(frame);
    world.step(0);
    REQUIRE(log.lines == 0);
    world.step(nan);
    REQUIRE_THAT(log.warnings, contains("World::step: dt = nan"));
    world.step(-1);
    REQUIRE_THAT(log.warnings, contains("dt = -1"));
    world.set_before_solve([nan](ContactEdit& edit) { edit.friction = nan; });
    const int before = log.lines;
    world.step(frame);
    REQUIRE(log.lines == before + 1);  // one line for all contacts of a step
    REQUIRE_THAT(log.warnings,
                 contains("before-solve callback (World::set_before_solve), for shapes ") &&
                     contains(" set friction to NaN, which changes nothing"));
    world.set_before_solve({});
    box.set_velocity_function([nan](VelocityEdit& edit) { edit.velocity.x = nan; });
    world.step(frame);
    REQUIRE_THAT(log.warnings,
                 contains("velocity function of a body (Body::set_velocity_function), for body ") &&
                     contains(" set velocity to NaN, which changes nothing"));
    box.set_velocity_function({});
    world.set_threads(64);
    if (std::thread::hardware_concurrency() < 64) REQUIRE_THAT(log.notes, contains("threads = 64"));
    for (size_t i = 0; i <= World::most_accounts; ++i)
        world.keep_account(add_box(world, {float(i) * 2, 9}).id());
    REQUIRE_THAT(log.notes, contains("World::keep_account"));
    REQUIRE_THROWS_AS(world.keep_account(BodyId()), std::invalid_argument);
    REQUIRE(log.errors.empty());
    int calls = 0;
    world.start_recording([&](auto) {
        if (++calls > 1) throw std::runtime_error("full");
    });
    REQUIRE_THROWS_WITH(world.step(frame), "full");
    REQUIRE_THAT(log.errors, contains("the recording of a world ended"));
    for (int i = 0; i < 2; ++i)
        world.after_step([i] { throw std::runtime_error(i == 0 ? "a" : "b"); });
    REQUIRE_THROWS_WITH(world.step(frame), "a");
    REQUIRE_THAT(log.errors, contains("a function of after_step threw, too"));
}

TEST_CASE("a log that throws or that sets another one does no harm") {
    World world;
    set_log([](void*, LogLevel, const char*) { throw std::runtime_error("no"); }, nullptr);
    world.step(-1);
    static int calls;
    calls = 0;
    set_log(
        [](void*, LogLevel, const char*) {
            ++calls;
            set_log(nullptr, nullptr);
        },
        nullptr);
    world.step(-1);
    world.step(-1);
    REQUIRE(calls == 1);
}

TEST_CASE("while there is a failure function each step checks its world") {
    World world;
    add_floor(world);
    Body box = add_box(world, {0, 0.5f});
    Failures failures;
    run(world, 0.2f);
    REQUIRE(failures.what.empty());
    // A foreign write into the memory of the library, at the end of a step.
    detail::WorldData& data = detail::WorldInside::of(world);
    const uint32_t shape = box.shapes()[0].index();
    box.set_position_function([&](PositionEdit&) { data.boxes[shape].low.x -= 5; });
    world.step(frame);
    REQUIRE_THAT(failures.what, contains("shape " + std::to_string(shape)));
    REQUIRE(failures.world == &world);
    failures.throws = true;
    int after = 0;
    world.after_step([&] { ++after; });
    REQUIRE_THROWS_WITH(world.step(frame), "the host stops here");
    REQUIRE(after == 1);
    REQUIRE_FALSE(world.locked());
    box.set_position_function({});
    failures.what.clear();
    world.step(frame);
    REQUIRE(failures.what.empty());
}

}  // namespace hooks_test
