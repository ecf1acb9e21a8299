#pragma once

#include <fettle/physics/scheduler.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace fettle::physics::detail {

/// Number of processors that the system reports; the largest int if it reports none.
int processors();

/// Threads that share the blocks of a loop. The calling thread works, too, and returns when all
/// blocks are finished. Each thread begins with its own range of blocks, the same one in every
/// loop, so that the data it wrote in the last loop are still in its cache; then it takes remaining
/// blocks of other threads. The thread of a block varies from run to run; the caller must make sure
/// that results do not depend on it. Sharing work allocates nothing.
class ThreadPool {
  public:
    /// Maximum number of blocks of a loop.
    static constexpr uint32_t most_blocks = (1u << 20) - 1;

    /// `threads`: number of threads, including the caller; `at_a_time`: how many of them work at
    /// the same time. More threads than processors would slow each other down. If the system
    /// provides fewer, throws std::runtime_error with the number of threads that exist.
    explicit ThreadPool(int threads, int at_a_time = processors());
    /// A pool without threads of its own: the threads of the host work while a `HostThreads` lives.
    ThreadPool(TaskScheduler& host, int threads);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    int threads() const { return threads_; }
    bool has_host() const { return host_ != nullptr; }
    /// Number of threads that work at the same time.
    int at_a_time() const { return int(shares_.size()); }

    /// While an object of this class lives, the threads of the host do work of the pool. The pool's
    /// own threads always do.
    class HostThreads {
      public:
        /// Throws what the host throws; then no thread helps.
        explicit HostThreads(ThreadPool* pool);
        ~HostThreads();
        /// Waits for the threads of the host. Returns what the host has thrown, or null. After an
        /// exception it is unknown which tasks the host will still call, so it gets no more.
        std::exception_ptr finish() noexcept;
        HostThreads(const HostThreads&) = delete;
        HostThreads& operator=(const HostThreads&) = delete;

      private:
        ThreadPool* pool_;  ///< null: no tasks of a host run
    };

    /// Calls `work(block)` once for every block below `count`. All calls are made even if some of
    /// them throw; then one of the exceptions is thrown again.
    template <typename Work>
    void run(uint32_t count, Work&& work) {
        Caught caught;
        const auto attempt = [&](uint32_t block) {
            try {
                work(block);
            } catch (...) {
                caught.keep();
            }
        };
        using Attempt = std::remove_reference_t<decltype(attempt)>;
        parallel_for(
            count, [](void* context, uint32_t block) { (*static_cast<Attempt*>(context))(block); },
            const_cast<void*>(static_cast<const void*>(&attempt)));
        if (caught.thrown) std::rethrow_exception(caught.thrown);
    }

  private:
    /// The first exception of several threads.
    struct Caught {
        std::atomic<bool> any = false;
        std::exception_ptr thrown;
        void keep() {
            if (!any.exchange(true)) thrown = std::current_exception();
        }
    };
    using Function = void (*)(void* context, uint32_t block);
    /// Remaining blocks of a thread. Round, first block and end are in one word, so that a late
    /// thread never claims a block of another round.
    struct alignas(64) Share {
        std::atomic<uint64_t> left = 0;
    };

    void parallel_for(uint32_t count, Function function, void* context);
    uint64_t share_of(uint64_t turn, std::size_t thread) const;
    bool claim(uint64_t turn, std::size_t thread, bool own, uint32_t& block);
    void work_on(uint64_t turn, std::size_t thread, bool own);
    bool wait_for_others(uint32_t goal) const;
    void work_until_done(uint64_t turn, uint32_t goal, std::size_t self);
    void run_worker(std::size_t self);
    void do_task(uint32_t number);
    void end_round();
    void stop();

    // Written by the caller, read by all threads: round and number of blocks in one word.
    alignas(64) std::atomic<uint64_t> turn_ = 0;
    std::atomic<Function> function_ = nullptr;
    std::atomic<void*> context_ = nullptr;
    std::atomic<uint32_t> goal_ = 0;  ///< value of `done_` when the round is over
    std::atomic<bool> stop_ = false;
    alignas(64) std::atomic<uint32_t> done_ = 0;  ///< finished blocks of all rounds, modulo 2³²
    alignas(64) std::atomic<uint32_t> sleepers_ = 0;
    TaskScheduler* const host_ = nullptr;
    bool host_failed_ = false;
    std::atomic<uint32_t> host_tasks_ = 0;  ///< number of them that run now
    std::thread::id caller_;                ///< the thread that started the tasks of the host
    const int threads_;
    std::vector<Share> shares_;
    std::vector<std::thread> workers_;
};

/// Like `run`; without a pool, the caller processes the blocks one after the other.
template <typename Work>
void parallel_for(ThreadPool* pool, uint32_t count, Work&& work) {
    if (pool != nullptr && count > 1) {
        pool->run(count, work);
        return;
    }
    for (uint32_t block = 0; block < count; ++block) work(block);
}

/// Data that all threads read often and that no thread writes are in cache lines of their own:
/// reading a line that another thread has just written takes longer than a short loop.
inline constexpr std::size_t cache_line_size = 64;

/// Calls `work(begin, end)` for 0 … size in pieces of `piece`; can be run several times.
template <typename Work>
class alignas(cache_line_size) RangeLoop {
  public:
    RangeLoop(ThreadPool* pool, std::size_t size, std::size_t piece, Work work)
        : work_(std::move(work)), pool_(pool), size_(size), piece_(piece) {}

    void run() const { parallel_for(pool_, uint32_t((size_ + piece_ - 1) / piece_), *this); }
    void operator()(uint32_t block) const {
        const std::size_t begin = block * piece_;
        work_(begin, begin + piece_ < size_ ? begin + piece_ : size_);
    }

  private:
    Work work_;
    ThreadPool* pool_;
    std::size_t size_, piece_;
};

/// Calls `work(begin, end)` for 0 … size in pieces of `piece`: a `RangeLoop` that is run once.
template <typename Work>
void parallel_for(ThreadPool* pool, std::size_t size, std::size_t piece, Work&& work) {
    RangeLoop(pool, size, piece, [&work](std::size_t begin, std::size_t end) {
        work(begin, end);
    }).run();
}

}  // namespace fettle::physics::detail
