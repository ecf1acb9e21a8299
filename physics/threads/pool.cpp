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

// How long a thread searches for work. First it spins, because the stages of a step follow each
// other within microseconds; then it yields the processor; then it sleeps, because the next step
// may be far away.
constexpr int spins = 20'000, yields = 2000;

// How long a thread waits for almost finished threads before it takes their remaining blocks, whose
// data are in the cache of the other thread. About a microsecond.
constexpr int spins_before_taking = 40;

// How long the caller waits for the last blocks before it yields: the system may have interrupted
// the thread of such a block.
constexpr int spins_at_end = 2000;

void pause() {
#if defined(__SSE2__)
    _mm_pause();
#endif
}

// A share in one word: 24 bits for the round, 20 bits for the first remaining block, 20 bits for
// the end. `turn_` has the same layout, with all blocks of the round.
constexpr int count_bits = 20;
constexpr uint64_t count_mask = (uint64_t{1} << count_bits) - 1;
constexpr uint64_t one_first = uint64_t{1} << count_bits;

constexpr uint64_t round_of(uint64_t word) {
    return word >> (2 * count_bits);
}
constexpr uint64_t first_of(uint64_t word) {
    return word >> count_bits & count_mask;
}
constexpr uint64_t end_of(uint64_t word) {
    return word & count_mask;
}
constexpr uint64_t word_of(uint64_t round, uint64_t first, uint64_t end) {
    return round << (2 * count_bits) | first << count_bits | end;
}
/// The next round. 0 is skipped, because a share in round 0 counts as never claimed.
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
            workers_.emplace_back([this, self] { run_worker(self); });
    } catch (const std::system_error& error) {
        const std::string had = std::to_string(workers_.size() + 1);
        stop();
        throw std::runtime_error("threads = " + std::to_string(threads) +
                                 ": the system gives no more than " + had + " (" + error.what() +
                                 ")");
    }
}

ThreadPool::ThreadPool(TaskScheduler& host, int threads)
    : host_(&host), threads_(threads), shares_(size_t(threads)) {}

ThreadPool::~ThreadPool() {
    stop();
}

ThreadPool::HostThreads::HostThreads(ThreadPool* pool)
    : pool_(pool != nullptr && pool->host_ != nullptr && pool->threads_ > 1 && !pool->host_failed_
                ? pool
                : nullptr) {
    if (pool_ == nullptr) return;
    pool_->stop_.store(false);
    pool_->caller_ = std::this_thread::get_id();
    try {
        pool_->host_->start(
            uint32_t(pool_->threads_ - 1),
            [](void* context, uint32_t number) {
                static_cast<ThreadPool*>(context)->do_task(number);
            },
            pool_);
    } catch (...) {
        // Some of the tasks may have begun.
        (void)finish();
        throw;
    }
}

ThreadPool::HostThreads::~HostThreads() {
    (void)finish();
}

std::exception_ptr ThreadPool::HostThreads::finish() noexcept {
    ThreadPool* const pool = std::exchange(pool_, nullptr);
    if (pool == nullptr) return nullptr;
    pool->end_round();
    try {
        pool->host_->finish();
        return nullptr;
    } catch (...) {
        pool->host_failed_ = true;
        return std::current_exception();
    }
}

void ThreadPool::do_task(uint32_t number) {
    // A host without a free thread may call the task at once. It would wait for the step, and the
    // step for it.
    if (std::this_thread::get_id() == caller_) return;
    host_tasks_.fetch_add(1);
    if (number < shares_.size() - 1) run_worker(size_t{number} + 1);
    host_tasks_.fetch_sub(1);
}

/// Lets all other threads return from `run_worker`.
void ThreadPool::end_round() {
    stop_.store(true);
    turn_.store(word_of(after(round_of(turn_.load())), 0, 0));
    turn_.notify_all();
}

void ThreadPool::stop() {
    end_round();
    for (std::thread& worker : workers_) worker.join();
    workers_.clear();
    // A host whose `finish` has thrown did not wait for them.
    while (host_tasks_.load() > 0) std::this_thread::yield();
}

/// The share of a thread in `count` blocks. It is the same range in every round.
uint64_t ThreadPool::share_of(uint64_t turn, size_t thread) const {
    const uint64_t count = end_of(turn), threads = shares_.size();
    return word_of(round_of(turn), count * thread / threads, count * (thread + 1) / threads);
}

/// Takes a block of a thread's share. If the share still belongs to an earlier round, the first
/// thread that claims a block initializes it. The current round cannot be over then, because all
/// blocks of that share remain.
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
        // Other threads take blocks from the end, which is farthest from the position of the owner.
        const uint64_t taken = own ? left + one_first : left - 1;
        if (share.compare_exchange_weak(seen, taken, std::memory_order_acq_rel,
                                        std::memory_order_acquire))
            return true;
    }
}

/// While a claimed block is unfinished, the round cannot end and its function cannot change.
void ThreadPool::work_on(uint64_t turn, size_t thread, bool own) {
    uint32_t done = 0;
    for (uint32_t block = 0; claim(turn, thread, own, block); ++done)
        function_.load(std::memory_order_relaxed)(context_.load(std::memory_order_relaxed), block);
    if (done > 0) done_.fetch_add(done, std::memory_order_release);
}

bool ThreadPool::wait_for_others(uint32_t goal) const {
    for (int looks = 0; looks < spins_before_taking; ++looks) {
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

void ThreadPool::parallel_for(uint32_t count, Function function, void* context) {
    // All blocks of the last round are finished, so no thread reads these members.
    function_.store(function, std::memory_order_relaxed);
    context_.store(context, std::memory_order_relaxed);
    const uint32_t goal = goal_.load(std::memory_order_relaxed) + count;
    goal_.store(goal, std::memory_order_relaxed);
    const uint64_t round = after(round_of(turn_.load(std::memory_order_relaxed)));
    if (round == 1) {
        // The numbers repeat after 2²⁴ rounds, so the shares are reset; otherwise an old share
        // could seem to belong to this round.
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

void ThreadPool::run_worker(size_t self) {
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

namespace fettle::physics {

TaskScheduler::~TaskScheduler() = default;

}  // namespace fettle::physics
