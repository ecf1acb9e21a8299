// An engine has a pool of threads. Its physics uses these threads instead of starting its own.

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "heap.h"

using namespace fettle::physics;

/// Threads that do jobs in the order in which they come: the pool of the engine.
class ThreadPool {
  public:
    explicit ThreadPool(int threads) {
        for (int i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
    }
    ~ThreadPool() {
        {
            const std::lock_guard lock(mutex_);
            stopping_ = true;
        }
        changed_.notify_all();
        for (std::thread& thread : threads_) thread.join();
    }
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    void add(std::function<void()> job) {
        {
            const std::lock_guard lock(mutex_);
            jobs_.push_back(std::move(job));
        }
        changed_.notify_one();
    }

  private:
    void work() {
        std::unique_lock lock(mutex_);
        for (;;) {
            changed_.wait(lock, [this] { return stopping_ || !jobs_.empty(); });
            if (jobs_.empty()) return;
            const std::function<void()> job = std::move(jobs_.front());
            jobs_.pop_front();
            lock.unlock();
            job();
            lock.lock();
        }
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<std::function<void()>> jobs_;
    std::vector<std::thread> threads_;
    bool stopping_ = false;
};

/// Lets the pool do the tasks of a step. The stepping thread works too, so a step never waits for a
/// thread that is busy with something else before it begins; it waits only for tasks that have
/// begun.
class PoolScheduler : public TaskScheduler {
  public:
    explicit PoolScheduler(ThreadPool& pool) : pool_(pool) {}
    ~PoolScheduler() override {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return queued_ == 0; });
    }

    void start(uint32_t count, Task task, void* context) override {
        const std::lock_guard lock(mutex_);
        ++step_;
        open_ = true;
        queued_ += count;
        for (uint32_t number = 0; number < count; ++number)
            pool_.add([this, step = step_, task, context, number] {
                if (begin(step)) {  // false: the step was over before a thread was free
                    task(context, number);
                    end();
                }
                const std::lock_guard done(mutex_);
                --queued_;
                changed_.notify_all();
            });
    }
    void finish() override {
        std::unique_lock lock(mutex_);
        open_ = false;
        changed_.wait(lock, [this] { return running_ == 0; });
    }

  private:
    bool begin(unsigned step) {
        const std::lock_guard lock(mutex_);
        if (!open_ || step != step_) return false;
        ++running_;
        return true;
    }
    void end() {
        const std::lock_guard lock(mutex_);
        --running_;
        changed_.notify_all();
    }

    ThreadPool& pool_;
    std::mutex mutex_;
    std::condition_variable changed_;
    unsigned step_ = 0;
    unsigned queued_ = 0;   // jobs that the pool has not done
    unsigned running_ = 0;  // tasks of this step
    bool open_ = false;     // tasks of this step may begin
};

int main() {
    ThreadPool pool(3);
    PoolScheduler scheduler(pool);
    return example::compare(scheduler, "four tasks in the pool");
}
