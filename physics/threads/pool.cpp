#include <threads/pool.h>

#include <algorithm>
#include <limits>
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
// long off.
constexpr int spins = 20'000, yields = 2000;

// How long to wait for who is about to be done, before taking what is left of theirs: pieces that
// change hands are in the other's cache. A microsecond.
constexpr int patience = 40;

// How long the caller waits for the last blocks before giving up the processor: whoever has one may
// have lost theirs.
constexpr int spins_at_end = 2000;

void pause() {
#if defined(__SSE2__)
    _mm_pause();
#endif
}

// A turn or a share: 24 bits of the round, 20 bits of the first block that is left, 20 of the end.
constexpr int count_bits = 20;
constexpr uint64_t field = (uint64_t{1} << count_bits) - 1;
constexpr uint64_t one_first = uint64_t{1} << count_bits;

constexpr uint64_t round_of(uint64_t word) {
    return word >> (2 * count_bits);
}
constexpr uint64_t first_of(uint64_t word) {
    return word >> count_bits & field;
}
constexpr uint64_t end_of(uint64_t word) {
    return word & field;
}
constexpr uint64_t word_of(uint64_t round, uint64_t first, uint64_t end) {
    return round << (2 * count_bits) | first << count_bits | end;
}
/// The next one. Round 0 never comes again: a share of it has never been claimed.
constexpr uint64_t after(uint64_t round) {
    constexpr uint64_t last = ~uint64_t{0} >> (2 * count_bits);
    return round == last ? 1 : round + 1;
}

}  // namespace

int processors() {
    const auto known = int(std::thread::hardware_concurrency());
    return known > 0 ? known : std::numeric_limits<int>::max();
}

ThreadPool::ThreadPool(int threads, int at_a_time)
    : threads_(threads), shares_(size_t(std::min(threads, at_a_time))) {
    try {
        workers_.reserve(shares_.size() - 1);
        for (size_t self = 1; self < shares_.size(); ++self)
            workers_.emplace_back([this, self] { serve(self); });
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
    turn_.store(word_of(after(round_of(turn_.load())), 0, 0));
    turn_.notify_all();
    for (std::thread& worker : workers_) worker.join();
    workers_.clear();
}

/// Of `count` blocks the same part in every round.
uint64_t ThreadPool::share_of(uint64_t turn, size_t thread) const {
    const uint64_t count = end_of(turn), threads = shares_.size();
    return word_of(round_of(turn), count * thread / threads, count * (thread + 1) / threads);
}

/// Takes a block of a thread's share. Whoever comes first finds that of an earlier round and begins
/// it; then the round is not over, for all of that share is still to be done.
bool ThreadPool::claim(uint64_t turn, size_t thread, bool own, uint32_t& block) {
    std::atomic<uint64_t>& share = shares_[thread].left;
    uint64_t seen = share.load(std::memory_order_acquire);
    for (;;) {
        uint64_t left = seen;
        if (round_of(seen) != round_of(turn)) {
            if (turn_.load(std::memory_order_acquire) != turn) return false;  // too late
            left = share_of(turn, thread);
        }
        if (first_of(left) >= end_of(left)) return false;
        block = uint32_t(own ? first_of(left) : end_of(left) - 1);
        // Others take from the end: what is farthest from where the owner is.
        const uint64_t taken = own ? left + one_first : left - 1;
        if (share.compare_exchange_weak(seen, taken, std::memory_order_acq_rel,
                                        std::memory_order_acquire))
            return true;
    }
}

/// Claimed: the round cannot end, nor its function change, before a block is done.
void ThreadPool::work_on(uint64_t turn, size_t thread, bool own) {
    uint32_t done = 0;
    for (uint32_t block = 0; claim(turn, thread, own, block); ++done)
        function_.load(std::memory_order_relaxed)(context_.load(std::memory_order_relaxed), block);
    if (done > 0) done_.fetch_add(done, std::memory_order_release);
}

bool ThreadPool::wait_for_others(uint32_t goal) const {
    for (int looks = 0; looks < patience; ++looks) {
        if (done_.load(std::memory_order_acquire) == goal) return true;
        pause();
    }
    return false;
}

void ThreadPool::work_until_done(uint64_t turn, uint32_t goal, size_t self) {
    work_on(turn, self, true);
    if (wait_for_others(goal)) return;
    for (size_t i = 1; i < shares_.size(); ++i) work_on(turn, (self + i) % shares_.size(), false);
}

void ThreadPool::share_out(uint32_t count, Function function, void* context) {
    // All blocks of the last round are done: no thread reads these.
    function_.store(function, std::memory_order_relaxed);
    context_.store(context, std::memory_order_relaxed);
    const uint32_t goal = goal_.load(std::memory_order_relaxed) + count;
    goal_.store(goal, std::memory_order_relaxed);
    const uint64_t round = after(round_of(turn_.load(std::memory_order_relaxed)));
    if (round == 1) {
        // A share that has been empty ever since may be of any round: forget.
        for (Share& share : shares_) share.left.store(0, std::memory_order_relaxed);
    }
    const uint64_t turn = word_of(round, 0, count);
    turn_.store(turn);
    if (sleepers_.load() > 0) turn_.notify_all();
    work_until_done(turn, goal, 0);
    for (int looks = 0; done_.load(std::memory_order_acquire) != goal; ++looks) {
        if (looks < spins_at_end)
            pause();
        else
            std::this_thread::yield();
    }
}

void ThreadPool::serve(size_t self) {
    uint64_t seen = 0;
    for (int looks = 0; !stop_.load(std::memory_order_relaxed);) {
        const uint64_t turn = turn_.load(std::memory_order_acquire);
        if (round_of(turn) != round_of(seen)) {
            work_until_done(turn, goal_.load(std::memory_order_relaxed), self);
            seen = turn;
            looks = 0;
        } else if (++looks < spins) {
            pause();
        } else if (looks < spins + yields) {
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
