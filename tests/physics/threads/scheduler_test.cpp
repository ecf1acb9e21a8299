#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include "catch.h"
#include "scenes.h"

namespace scheduler_test {

// The threads of a host do the work of a step.

using namespace scenes;

namespace {

/// Threads that wait for tasks, as an engine has them.
class Engine : public TaskScheduler {
  public:
    explicit Engine(int threads) {
        for (int i = 0; i < threads; ++i) workers_.emplace_back([this] { work(); });
    }
    ~Engine() override {
        {
            const std::lock_guard lock(mutex_);
            over_ = true;
        }
        wake_.notify_all();
        for (std::thread& worker : workers_) worker.join();
    }

    void start(uint32_t count, Task task, void* context) override {
        ++starts;
        {
            const std::lock_guard lock(mutex_);
            for (uint32_t i = 0; i < count; ++i) waiting_.push_back([=] { task(context, i); });
            unfinished_ += count;
        }
        wake_.notify_all();
    }
    void finish() override {
        ++finishes;
        std::unique_lock lock(mutex_);
        done_.wait(lock, [this] { return unfinished_ == 0; });
    }
    size_t threads_that_worked() {
        const std::lock_guard lock(mutex_);
        return worked_.size();
    }

    int starts = 0, finishes = 0;

  private:
    void work() {
        std::unique_lock lock(mutex_);
        for (;;) {
            wake_.wait(lock, [this] { return over_ || !waiting_.empty(); });
            if (waiting_.empty()) return;
            const auto task = std::move(waiting_.back());
            waiting_.pop_back();
            worked_.insert(std::this_thread::get_id());
            lock.unlock();
            task();
            lock.lock();
            if (--unfinished_ == 0) done_.notify_all();
        }
    }

    std::mutex mutex_;
    std::condition_variable wake_, done_;
    std::vector<std::function<void()>> waiting_;
    std::set<std::thread::id> worked_;
    uint32_t unfinished_ = 0;
    bool over_ = false;
    std::vector<std::thread> workers_;
};

/// Runs its tasks at the end of the step, when no work is left for them, or never.
class Idler : public TaskScheduler {
  public:
    explicit Idler(bool late) : late_(late) {}
    void start(uint32_t count, Task task, void* context) override {
        for (uint32_t i = 0; late_ && i < count; ++i) tasks_.push_back([=] { task(context, i); });
    }
    void finish() override {
        for (const auto& task : tasks_) task();
        tasks_.clear();
    }

  private:
    bool late_;
    std::vector<std::function<void()>> tasks_;
};

/// Has no threads: it does each task at once.
class Alone : public TaskScheduler {
  public:
    void start(uint32_t count, Task task, void* context) override {
        for (uint32_t i = 0; i < count; ++i) task(context, i);
    }
    void finish() override {}
};

/// Throws in a step, when some or all of its tasks were started.
class Failing : public Engine {
  public:
    using Engine::Engine;
    void start(uint32_t count, Task task, void* context) override {
        Engine::start(starts == start_of_failure ? 1 : count, task, context);
        if (starts - 1 == start_of_failure) throw std::runtime_error("no thread is free");
    }
    void finish() override {
        if (finishes == finish_of_failure) {
            ++finishes;
            throw std::runtime_error("the threads are gone");
        }
        Engine::finish();
    }
    int start_of_failure = -1, finish_of_failure = -1;
};

void heap(World& world) {
    add_floor(world);
    for (int i = 0; i < 1500; ++i)
        add_box(world, {1.02f * float(i % 40) - 20, 0.5f + 1.01f * float(i / 40)});
}

}  // namespace

TEST_CASE("threads of a host step a world to the same bits") {
    World plain, helped;
    Engine engine(3);
    heap(plain);
    heap(helped);
    helped.set_scheduler(&engine, 4);
    REQUIRE(helped.threads() == 4);
    run(plain, 0.5f);
    run(helped, 0.5f);
    REQUIRE(helped.hash() == plain.hash());
    REQUIRE(engine.starts == 30);
    REQUIRE(engine.finishes == 30);
    REQUIRE(engine.threads_that_worked() > 0);
    REQUIRE_FALSE(helped.validate());
    helped.set_threads(2);
    run(helped, 0.1f);
    run(plain, 0.1f);
    REQUIRE(engine.starts == 30);
    REQUIRE(helped.hash() == plain.hash());
}

TEST_CASE("a host that has no time for tasks changes nothing") {
    for (const bool late : {false, true}) {
        World plain, helped;
        Idler idler(late);
        heap(plain);
        heap(helped);
        helped.set_scheduler(&idler, 8);
        run(plain, 0.2f);
        run(helped, 0.2f);
        REQUIRE(helped.hash() == plain.hash());
        helped.set_scheduler(nullptr, 1);
        REQUIRE(helped.threads() == 1);
        run(helped, 0.1f);
    }
}

TEST_CASE("a host that does the tasks at once on the thread that steps changes nothing") {
    World plain, helped;
    Alone alone;
    heap(plain);
    heap(helped);
    helped.set_scheduler(&alone, 4);
    run(plain, 0.2f);
    run(helped, 0.2f);
    REQUIRE(helped.hash() == plain.hash());
}

TEST_CASE("a task with a number that was not given returns at once") {
    struct Wrong : TaskScheduler {
        void start(uint32_t count, Task task, void* context) override {
            std::thread([&] {
                for (const uint32_t number : {count, count + 1, ~uint32_t{0}})
                    task(context, number);
            }).join();
        }
        void finish() override {}
    } wrong;
    World plain, helped;
    heap(plain);
    heap(helped);
    helped.set_scheduler(&wrong, 4);
    run(plain, 0.2f);
    run(helped, 0.2f);
    REQUIRE(helped.hash() == plain.hash());
}

TEST_CASE("a host that cannot start its tasks has stopped the step before it began") {
    World plain, helped;
    Failing engine(3);
    heap(plain);
    heap(helped);
    helped.set_scheduler(&engine, 4);
    engine.start_of_failure = 5;
    for (int i = 0; i < 10; ++i) {
        const uint64_t before = helped.hash();
        if (i == 5) {
            REQUIRE_THROWS_WITH(helped.step(frame), "no thread is free");
            REQUIRE(helped.hash() == before);
            REQUIRE(engine.finishes == 6);  // the task that was started has ended
        }
        helped.step(frame);
        plain.step(frame);
        REQUIRE(helped.hash() == plain.hash());
    }
    REQUIRE(engine.starts == 11);
    REQUIRE_FALSE(helped.validate());
}

TEST_CASE("a host that cannot wait for its tasks gets an error after the step and no more tasks") {
    World plain;
    Failing engine(3), other(3);  // they outlive the world
    World helped;
    heap(plain);
    heap(helped);
    helped.set_scheduler(&engine, 4);
    engine.finish_of_failure = 3;
    int after_steps = 0;
    for (int i = 0; i < 10; ++i) {
        helped.after_step([&after_steps] { ++after_steps; });
        if (i == 3)
            REQUIRE_THROWS_WITH(helped.step(frame), "the threads are gone");
        else
            helped.step(frame);
        plain.step(frame);
        REQUIRE(helped.hash() == plain.hash());
    }
    REQUIRE(after_steps == 10);
    REQUIRE(engine.starts == 4);
    helped.set_scheduler(&other, 4);
    run(helped, 0.1f);
    run(plain, 0.1f);
    REQUIRE(other.starts == 6);
    REQUIRE(helped.hash() == plain.hash());
}

TEST_CASE("a step whose callback throws has finished its tasks") {
    World world;
    Engine engine(2);
    heap(world);
    world.set_scheduler(&engine, 3);
    world.set_before_solve([](ContactEdit&) { throw std::runtime_error("no"); });
    for (int i = 0; i < 5; ++i) REQUIRE_THROWS_WITH(world.step(frame), "no");
    REQUIRE(engine.finishes == 5);
    REQUIRE_THROWS_WITH(world.set_scheduler(&engine, 0), contains("threads = 0"));
    REQUIRE_THROWS_WITH(world.set_scheduler(&engine, 65), contains("1 to 64"));
    REQUIRE(world.threads() == 3);
}

}  // namespace scheduler_test
