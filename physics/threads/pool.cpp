#include <threads/pool.h>

#include <stdexcept>
#include <string>
#include <system_error>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace fettle::physics::detail {
namespace {

// How long to look for work: first without giving up the processor, since the stages of a step
// follow each other within microseconds; then politely; then asleep, since the next step may be
// long off. Where there are more threads than processors, whoever looks keeps from working who has
// work: then briefly.
constexpr int spins_alone = 20'000, spins_crowded = 100, yields = 2000;

int spins_for(int threads) {
    const auto processors = std::thread::hardware_concurrency();  // 0: not known
    return unsigned(threads) <= processors ? spins_alone : spins_crowded;
}

void pause() {
#if defined(__SSE2__)
    _mm_pause();
#endif
}

constexpr int count_bits = 20;
constexpr uint64_t field = (uint64_t{1} << count_bits) - 1;

constexpr uint64_t round_of(uint64_t turn) {
    return turn >> (2 * count_bits);
}
constexpr uint64_t count_of(uint64_t turn) {
    return turn >> count_bits & field;
}
constexpr uint64_t block_of(uint64_t turn) {
    return turn & field;
}
constexpr uint64_t first_turn(uint64_t round, uint64_t count) {
    return round << (2 * count_bits) | count << count_bits;
}

}  // namespace

ThreadPool::ThreadPool(int threads) : spins_(spins_for(threads)) {
    try {
        workers_.reserve(size_t(threads) - 1);
        while (int(workers_.size()) + 1 < threads) workers_.emplace_back([this] { serve(); });
    } catch (const std::system_error& error) {
        const std::string had = std::to_string(workers_.size() + 1);
        stop();
        throw std::runtime_error("threads = " + std::to_string(threads) +
                                 ": the system gives no more than " + had + " (" + error.what() +
                                 ")");
    }
}

ThreadPool::~ThreadPool() {
    stop();
}

void ThreadPool::stop() {
    stop_.store(true);
    turn_.store(first_turn(round_of(turn_.load()) + 1, 0));
    turn_.notify_all();
    for (std::thread& worker : workers_) worker.join();
    workers_.clear();
}

/// Takes the next block, if there is one left: the one in `turn` then.
bool ThreadPool::claim(uint64_t& turn) {
    while (block_of(turn) < count_of(turn)) {
        if (turn_.compare_exchange_weak(turn, turn + 1, std::memory_order_acq_rel,
                                        std::memory_order_acquire))
            return true;
    }
    return false;
}

void ThreadPool::work_until_done(uint64_t turn) {
    while (claim(turn)) {
        // Claimed: the round cannot end before this block is done.
        function_.load(std::memory_order_relaxed)(context_.load(std::memory_order_relaxed),
                                                  uint32_t(block_of(turn)));
        done_.fetch_add(1, std::memory_order_release);
        turn = turn_.load(std::memory_order_acquire);
    }
}

void ThreadPool::share_out(uint32_t count, Function function, void* context) {
    // All blocks of the last round are done: nobody reads these.
    function_.store(function, std::memory_order_relaxed);
    context_.store(context, std::memory_order_relaxed);
    done_.store(0, std::memory_order_relaxed);
    const uint64_t turn = first_turn(round_of(turn_.load(std::memory_order_relaxed)) + 1, count);
    turn_.store(turn);
    if (sleepers_.load() > 0) turn_.notify_all();
    work_until_done(turn);
    for (int looks = 0; done_.load(std::memory_order_acquire) < count; ++looks) {
        if (looks < spins_)
            pause();
        else
            std::this_thread::yield();
    }
}

void ThreadPool::serve() {
    uint64_t seen = 0;
    for (int looks = 0; !stop_.load(std::memory_order_relaxed);) {
        const uint64_t turn = turn_.load(std::memory_order_acquire);
        if (round_of(turn) != round_of(seen)) {
            work_until_done(turn);
            seen = turn;
            looks = 0;
        } else if (++looks < spins_) {
            pause();
        } else if (looks < spins_ + yields) {
            std::this_thread::yield();
        } else {
            sleepers_.fetch_add(1);
            const uint64_t now = turn_.load();
            if (round_of(now) == round_of(seen) && !stop_.load()) turn_.wait(now);
            sleepers_.fetch_sub(1);
        }
    }
}

}  // namespace fettle::physics::detail
