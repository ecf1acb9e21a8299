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
    TbbScheduler scheduler;
    return example::compare(scheduler, "four tasks in oneTBB");
}
