#include <fettle/physics/hooks.h>
#include <functional>
#include <limits>
#include <memory>
#include <thread>
#include <utility>

#include "catch.h"
#include "scenes.h"

namespace function_life_test {

// The captures of a callback are destroyed with it; their destructors may use the world or destroy
// it.

using namespace scenes;

namespace {

/// Calls a function when its last copy is destroyed.
class AtEnd {
  public:
    explicit AtEnd(std::function<void()> call) : end_(std::make_shared<End>()) {
        end_->call = std::move(call);
    }

  private:
    struct End {
        std::function<void()> call;
        ~End() { call(); }
    };
    std::shared_ptr<End> end_;
};

}  // namespace

TEST_CASE(
    "a destructor in the sink of a recording may start another recording when the first one ends") {
    World world;
    int bytes = 0;
    world.start_recording([end = AtEnd([&] {
                               REQUIRE_FALSE(world.is_recorded());
                               world.set_gravity({0, -1});
                               world.start_recording([&](auto more) { bytes += int(more.size()); });
                           })](auto) {});
    world.stop_recording();
    REQUIRE(world.is_recorded());
    world.step(frame);
    REQUIRE(bytes > 0);
    world.stop_recording();
    REQUIRE_FALSE(world.is_recorded());
}

TEST_CASE("a destructor in a function of a replaced world may use the world that replaced it") {
    World world;
    Body body = add_ball(world, {0, 1});
    int ends = 0;
    world.set_filter([end = AtEnd([&] {
                          ++ends;
                          REQUIRE(world.bodies().empty());
                          add_ball(world, {0, 3});
                          world.step(frame);
                      })](auto&, auto&) { return true; });
    REQUIRE(ends == 0);
    world = World();
    REQUIRE(ends == 1);
    REQUIRE(world.body_count() == 1);
    REQUIRE_FALSE(body.is_valid());
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("a destructor in the function of a destroyed body may set functions of other bodies") {
    World world;
    Body first = add_ball(world, {0, 0});
    const uint32_t slot = first.index();
    int calls = 0;
    first.set_velocity_function(
        [end = AtEnd([&] {
             for (int i = 0; i < 50; ++i)
                 add_ball(world, {3.0f * float(i), 9}).set_velocity_function([&](auto&) {
                     ++calls;
                 });
         })](auto&) {});
    first.destroy();
    Body later = add_ball(world, {0, 0});
    REQUIRE(later.index() == slot);
    later.set_velocity_function([&](auto&) { calls += 1000; });
    world.step(frame);
    REQUIRE(calls == 1050);
}

TEST_CASE("a call that logs is completed even if the log function destroys the world") {
    static std::unique_ptr<World> world;
    struct Log {
        Log() {
            set_log([](void*, LogLevel, const char*) { world.reset(); }, nullptr);
        }
        ~Log() { set_log(nullptr, nullptr); }
    } log;
    world = std::make_unique<World>();
    for (size_t i = 0; i <= World::most_accounts; ++i)
        world->keep_account(world->create_body().id());
    REQUIRE(world == nullptr);
    world = std::make_unique<World>();
    world->step(-1);
    REQUIRE(world == nullptr);
    world = std::make_unique<World>();
    add_ball(*world, {0, 0}).set_velocity_function([](VelocityEdit& edit) {
        edit.velocity.x = std::numeric_limits<float>::quiet_NaN();
    });
    REQUIRE_THROWS_AS(world->step(frame), Locked);
    REQUIRE(world == nullptr);
    if (int(std::thread::hardware_concurrency()) < 64) {
        world = std::make_unique<World>();
        world->set_threads(64);
        REQUIRE(world == nullptr);
    }
}

}  // namespace function_life_test
