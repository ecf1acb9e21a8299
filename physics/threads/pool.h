#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace fettle::physics::detail {

/// How many the system reports; a large number where it reports none.
int processors();

/// Threads that share out the blocks of a loop. Whoever calls works too and returns when all is
/// done. Each thread begins with a range of blocks of its own, the same one in every loop, so that
/// what it wrote last time is still in its cache; then it takes what others have left. Which thread
/// does a block is chance; that it makes no difference is up to the caller. Nothing is allocated to
/// share out work.
class ThreadPool {
  public:
    /// Blocks of a loop.
    static constexpr uint32_t most_blocks = (1u << 20) - 1;

    /// `threads`: how many to work, the caller's included; `at_a_time`: how many of them do. More
    /// than there are processors would only keep each other from working. Throws
    /// std::runtime_error that says how many there are, if the system gives no more.
    explicit ThreadPool(int threads, int at_a_time = processors());
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    int threads() const { return threads_; }
    /// How many of them work at a time.
    int at_a_time() const { return int(shares_.size()); }

    /// `work(block)` for every block below `count`, each once.
    template <typename Work>
    void run(uint32_t count, Work&& work) {
        using Plain = std::remove_reference_t<Work>;
        share_out(
            count, [](void* context, uint32_t block) { (*static_cast<Plain*>(context))(block); },
            const_cast<void*>(static_cast<const void*>(&work)));
    }

  private:
    using Function = void (*)(void* context, uint32_t block);
    /// What is left of a thread's blocks: round, first and end in one word, so that nobody who is
    /// late claims a block that is not there.
    struct alignas(64) Share {
        std::atomic<uint64_t> left = 0;
    };

    void share_out(uint32_t count, Function function, void* context);
    uint64_t share_of(uint64_t turn, std::size_t thread) const;
    bool claim(uint64_t turn, std::size_t thread, bool own, uint32_t& block);
    void work_on(uint64_t turn, std::size_t thread, bool own);
    bool wait_for_others(uint32_t goal) const;
    void work_until_done(uint64_t turn, uint32_t goal, std::size_t self);
    void serve(std::size_t self);
    void stop();

    // Written by the caller, read by all: round and number of blocks in one word.
    alignas(64) std::atomic<uint64_t> turn_ = 0;
    std::atomic<Function> function_ = nullptr;
    std::atomic<void*> context_ = nullptr;
    std::atomic<uint32_t> goal_ = 0;  ///< `done_` when the round is over
    std::atomic<bool> stop_ = false;
    alignas(64) std::atomic<uint32_t> done_ = 0;  ///< blocks of all rounds, modulo 2³²
    alignas(64) std::atomic<uint32_t> sleepers_ = 0;
    const int threads_;
    std::vector<Share> shares_;
    std::vector<std::thread> workers_;
};

/// The same with whatever there is: without a pool, one after the other.
template <typename Work>
void share_out(ThreadPool* pool, uint32_t count, Work&& work) {
    if (pool != nullptr && count > 1) {
        pool->run(count, work);
        return;
    }
    for (uint32_t block = 0; block < count; ++block) work(block);
}

/// What all threads read over and over is alone in its lines of memory and never written to: a
/// line that one has just written to takes another longer to read than a short loop takes.
inline constexpr std::size_t line_size = 64;

/// `work(begin, end)` over 0 … size in pieces of `piece`, as often as it is run.
template <typename Work>
class alignas(line_size) RangeLoop {
  public:
    RangeLoop(ThreadPool* pool, std::size_t size, std::size_t piece, Work work)
        : work_(std::move(work)), pool_(pool), size_(size), piece_(piece) {}

    void run() const { share_out(pool_, uint32_t((size_ + piece_ - 1) / piece_), *this); }
    void operator()(uint32_t block) const {
        const std::size_t begin = block * piece_;
        work_(begin, begin + piece_ < size_ ? begin + piece_ : size_);
    }

  private:
    Work work_;
    ThreadPool* pool_;
    std::size_t size_, piece_;
};

/// The same once.
template <typename Work>
void share_out_range(ThreadPool* pool, std::size_t size, std::size_t piece, Work&& work) {
    RangeLoop(pool, size, piece, [&work](std::size_t begin, std::size_t end) {
        work(begin, end);
    }).run();
}

}  // namespace fettle::physics::detail
