// A program that uses oneTBB lets it share the threads between its own work and the physics.

#include <oneapi/tbb/task_group.h>

#include "heap.h"

using namespace fettle::physics;

class TbbScheduler : public TaskScheduler {
  public:
    ~TbbScheduler() noexcept override {}
    void start(uint32_t count, Task task, void* context) override {
        for (uint32_t number = 0; number < count; ++number)
            group_.run([=] { task(context, number); });
    }
    void finish() override { group_.wait(); }

  private:
    tbb::task_group group_;
};

int main() {
    World alone;
    example::fill(alone);
    const auto expected = example::run(alone, "one thread");

    TbbScheduler scheduler;
    World shared;  // after the scheduler, which has to outlive it
    example::fill(shared);
    shared.set_scheduler(&scheduler, 4);
    const auto hash = example::run(shared, "four tasks in oneTBB");
    std::puts(hash == expected ? "the same to the last bit" : "different");
    return hash == expected ? 0 : 1;
}
