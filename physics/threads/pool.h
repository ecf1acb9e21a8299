#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <type_traits>
#include <vector>

namespace fettle::physics::detail {

/// Threads that share out the blocks of a loop. Whoever calls works too and returns when all is
/// done. Which thread does a block is chance; that it makes no difference is up to the caller.
/// Nothing is allocated to share out work.
class ThreadPool {
  public:
    /// `threads`: how many work at a time, the caller's included. Throws std::runtime_error that
    /// says how many there are, if the system gives no more.
    explicit ThreadPool(int threads);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    int threads() const { return int(workers_.size()) + 1; }

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

    void share_out(uint32_t count, Function function, void* context);
    bool claim(uint64_t& turn);
    void work_until_done(uint64_t turn);
    void serve();
    void stop();

    // Round, number of blocks and next block in one word, so that nobody who is late claims a block
    // that is not there.
    alignas(64) std::atomic<uint64_t> turn_ = 0;
    std::atomic<Function> function_ = nullptr;
    std::atomic<void*> context_ = nullptr;
    alignas(64) std::atomic<uint32_t> done_ = 0;
    std::atomic<uint32_t> sleepers_ = 0;
    std::atomic<bool> stop_ = false;
    const int spins_;
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

/// Runs `work(begin, end)` over 0 … size in pieces of `piece`.
template <typename Work>
void share_out_range(ThreadPool* pool, std::size_t size, std::size_t piece, Work&& work) {
    const auto count = uint32_t((size + piece - 1) / piece);
    share_out(pool, count, [&](uint32_t block) {
        const std::size_t begin = block * piece;
        work(begin, begin + piece < size ? begin + piece : size);
    });
}

}  // namespace fettle::physics::detail
