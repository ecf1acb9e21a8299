#include "packing.h"

#include <utility>

#include <sys/resource.h>
#include <zstd.h>

namespace fettle::app {
namespace {

// The fastest level of any use: it halves what the bytes' own order leaves.
constexpr int level = 1;

// The first state is that of bodies that touch nothing yet. The system looks for the pages of what
// comes next when they are first written to: better here than in a step.
constexpr std::size_t growth = 3;
constexpr std::size_t most_prepared = std::size_t{64} << 20;  // bytes; more is not worth a pause

// State is mostly floats: their bytes of the same rank, taken together, repeat far more than they
// do in a row (a sixth less, in half the time).
void sort_by_rank(const std::vector<std::byte>& plain, std::vector<std::byte>& ranks) {
    const std::size_t words = plain.size() / 4;
    ranks.resize(plain.size());
    for (std::size_t rank = 0; rank < 4; ++rank)
        for (std::size_t i = 0; i < words; ++i) ranks[rank * words + i] = plain[4 * i + rank];
    for (std::size_t i = 4 * words; i < plain.size(); ++i) ranks[i] = plain[i];
}

std::vector<std::byte> from_ranks(const std::vector<std::byte>& ranks) {
    const std::size_t words = ranks.size() / 4;
    std::vector<std::byte> plain(ranks.size());
    for (std::size_t rank = 0; rank < 4; ++rank)
        for (std::size_t i = 0; i < words; ++i) plain[4 * i + rank] = ranks[rank * words + i];
    for (std::size_t i = 4 * words; i < ranks.size(); ++i) plain[i] = ranks[i];
    return plain;
}

/// Where there is no processor to spare, the game goes first.
void step_back() {
#ifdef __linux__  // elsewhere it would be the whole process that does
    constexpr int niceness = 10;
    (void)setpriority(PRIO_PROCESS, 0, niceness);
#endif
}

}  // namespace

void PackedBytes::pack(Room& room) {
    sort_by_rank(plain_, room.ranks);
    room.packed.resize(ZSTD_compressBound(room.ranks.size()));
    const std::size_t size = ZSTD_compress(room.packed.data(), room.packed.size(),
                                           room.ranks.data(), room.ranks.size(), level);
    if (ZSTD_isError(size) != 0) return;  // it stays as it is
    packed_.assign(room.packed.begin(), room.packed.begin() + static_cast<std::ptrdiff_t>(size));
    if (!room.made && plain_size_ <= most_prepared / growth) next_.resize(growth * plain_size_);
    room.made = true;
    is_packed_.store(true, std::memory_order_release);
}

std::vector<std::byte> PackedBytes::payload() const {
    if (!is_packed_.load(std::memory_order_acquire)) return plain_;
    std::vector<std::byte> ranks(plain_size_);
    ZSTD_decompress(ranks.data(), ranks.size(), packed_.data(), packed_.size());
    return from_ranks(ranks);
}

std::size_t PackedBytes::size() const {
    const std::size_t packed = is_packed_.load(std::memory_order_acquire) ? packed_.size() : 0;
    return plain_.size() + packed;
}

std::optional<std::vector<std::byte>> PackedBytes::settle() {
    if (plain_.empty() || !is_packed_.load(std::memory_order_acquire)) return std::nullopt;
    if (!next_.empty()) plain_ = std::exchange(next_, {});
    return std::exchange(plain_, {});
}

Packer::Packer() : thread_([this] { work(); }) {}

Packer::~Packer() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

void Packer::pack(const std::shared_ptr<PackedBytes>& what) {
    {
        const std::lock_guard lock(mutex_);
        waiting_.push_back(what);
    }
    wake_.notify_one();
}

void Packer::work() {
    step_back();
    PackedBytes::Room room;
    while (true) {
        std::shared_ptr<PackedBytes> next;
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
            if (ending_) return;
            next = waiting_.front().lock();
            waiting_.pop_front();
        }
        if (next != nullptr) next->pack(room);
    }
}

}  // namespace fettle::app
