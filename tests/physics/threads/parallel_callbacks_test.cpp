#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>
#include <thread>

#include "catch.h"
#include "scenes.h"

// Callbacks that run on several threads.

namespace parallel_callbacks_test {

using namespace scenes;

namespace {

/// Many boxes that fall on the floor beside and onto each other.
void fill(World& world) {
    add_floor(world);
    for (int x = 0; x < 40; ++x)
        for (int y = 0; y < 5; ++y)
            add_box(world, {float(x) * 1.1f + 0.02f * float(y), 0.6f + 1.1f * float(y)});
}

/// The hash after a second in which both callbacks change what they get.
uint64_t run_with_callbacks(int threads, bool parallel, std::atomic<int>& calls) {
    World world;
    fill(world);
    world.set_threads(threads);
    world.set_parallel_callbacks(parallel);
    world.set_mixing([&](ContactEdit& contact) {
        contact.friction = 0.1f + 0.2f * float(contact.shape_a.id().index % 4);
        ++calls;
    });
    world.set_before_solve([&](ContactEdit& contact) {
        contact.enabled = contact.shape_b.body().position().x < 30;
        contact.ignored = contact.shape_b.id().index % 50 == 1;
        ++calls;
    });
    run(world, 1.0f);
    REQUIRE_FALSE(world.validate());
    return world.hash();
}

}  // namespace

TEST_CASE("callbacks on several threads have the results of one thread") {
    std::atomic<int> calls = 0, parallel_calls = 0;
    const uint64_t hash = run_with_callbacks(1, false, calls);
    REQUIRE(calls > 1000);
    for (const int threads : {1, 2, 4}) {
        parallel_calls = 0;
        REQUIRE(run_with_callbacks(threads, true, parallel_calls) == hash);
        REQUIRE(parallel_calls == calls);
    }
}

namespace {

/// Runs all tasks on threads of its own, also where there are few processors.
class Threads : public TaskScheduler {
  public:
    void start(uint32_t count, Task task, void* context) override {
        for (uint32_t i = 0; i < count; ++i) threads_.emplace_back([=] { task(context, i); });
    }
    void finish() override {
        for (std::thread& each : threads_) each.join();
        threads_.clear();
    }

  private:
    std::vector<std::thread> threads_;
};

/// The threads on which the callback ran in a step. A parallel one waits for a second thread,
/// however late the system lets that one run; the limit is for a library that never calls it there.
std::set<std::thread::id> threads_of_calls(bool parallel) {
    Threads threads;
    World world;
    fill(world);
    run(world, 0.3f);
    world.set_scheduler(&threads, 3);
    world.set_parallel_callbacks(parallel);
    std::mutex mutex;
    std::condition_variable came;
    std::set<std::thread::id> found;
    bool waits = parallel;
    world.set_before_solve([&](ContactEdit&) {
        std::unique_lock lock(mutex);
        found.insert(std::this_thread::get_id());
        came.notify_all();
        if (waits)
            waits = came.wait_for(lock, std::chrono::minutes(1), [&] { return found.size() > 1; });
    });
    world.step(frame);
    world.set_scheduler(nullptr, 1);
    return found;
}

}  // namespace

TEST_CASE("only callbacks marked as parallel run in parallel") {
    REQUIRE(threads_of_calls(false) == std::set{std::this_thread::get_id()});
    REQUIRE(threads_of_calls(true).size() > 1);
}

TEST_CASE("a parallel callback that throws or edits ends as others do") {
    World world;
    fill(world);
    run(world, 0.3f);
    world.set_threads(2);
    world.set_parallel_callbacks(true);
    REQUIRE(world.parallel_callbacks());
    std::atomic<int> calls = 0;
    int first = -1;
    for (int round = 0; round < 5; ++round) {
        World copy = world.clone();
        REQUIRE_FALSE(copy.parallel_callbacks());  // belongs to the world, as callbacks do
        copy.set_threads(2);
        copy.set_parallel_callbacks(true);
        calls = 0;
        copy.set_before_solve([&](ContactEdit& contact) {
            ++calls;
            throw std::runtime_error(std::to_string(contact.shape_b.id().index));
        });
        try {
            copy.step(frame);
            FAIL("it threw");
        } catch (const std::runtime_error& error) {
            if (first < 0) first = std::stoi(error.what());
            REQUIRE(std::stoi(error.what()) == first);  // of the first contact, in each run
        }
        REQUIRE(calls > 100);
        REQUIRE_FALSE(copy.validate());
    }
    world.set_mixing([&](ContactEdit& contact) { contact.shape_a.set_friction(1); });
    REQUIRE_THROWS_AS(world.step(frame), Locked);
    world.set_mixing({});
    world.set_before_solve([&](ContactEdit&) { world.after_step([] {}); });
    REQUIRE_THROWS_WITH(world.step(frame), contains("several threads"));
    world.set_parallel_callbacks(false);
    REQUIRE_NOTHROW(world.step(frame));
}

}  // namespace parallel_callbacks_test
