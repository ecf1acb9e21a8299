#include "packing.h"

#include <utility>

#include <zstd.h>

namespace fettle::app {
namespace {

// The fastest level of any use: it halves what the bytes' own order leaves.
constexpr int level = 1;

// State is mostly floats: their bytes of the same rank, taken together, repeat far more than they
// do in a row (a sixth less, in half the time).
std::vector<std::byte> by_rank(const std::vector<std::byte>& plain) {
    const std::size_t words = plain.size() / 4;
    std::vector<std::byte> ranks(plain.size());
    for (std::size_t rank = 0; rank < 4; ++rank)
        for (std::size_t i = 0; i < words; ++i) ranks[rank * words + i] = plain[4 * i + rank];
    for (std::size_t i = 4 * words; i < plain.size(); ++i) ranks[i] = plain[i];
    return ranks;
}

std::vector<std::byte> from_ranks(const std::vector<std::byte>& ranks) {
    const std::size_t words = ranks.size() / 4;
    std::vector<std::byte> plain(ranks.size());
    for (std::size_t rank = 0; rank < 4; ++rank)
        for (std::size_t i = 0; i < words; ++i) plain[4 * i + rank] = ranks[rank * words + i];
    for (std::size_t i = 4 * words; i < ranks.size(); ++i) plain[i] = ranks[i];
    return plain;
}

std::vector<std::byte> pack(const std::vector<std::byte>& plain) {
    const std::vector<std::byte> ranks = by_rank(plain);
    std::vector<std::byte> packed(ZSTD_compressBound(ranks.size()));
    const std::size_t size =
        ZSTD_compress(packed.data(), packed.size(), ranks.data(), ranks.size(), level);
    if (ZSTD_isError(size) != 0) return {};
    return {packed.begin(), packed.begin() + static_cast<std::ptrdiff_t>(size)};
}

}  // namespace

std::vector<std::byte> PackedBytes::bytes() const {
    const std::lock_guard lock(mutex);
    if (packed.empty()) return plain;
    std::vector<std::byte> ranks(plain_size);
    ZSTD_decompress(ranks.data(), ranks.size(), packed.data(), packed.size());
    return from_ranks(ranks);
}

std::size_t PackedBytes::size() const {
    const std::lock_guard lock(mutex);
    return plain.size() + packed.size();
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

void Packer::pack(std::shared_ptr<PackedBytes> what) {
    {
        const std::lock_guard lock(mutex_);
        waiting_.push_back(std::move(what));
    }
    wake_.notify_one();
}

void Packer::finish() {
    std::unique_lock lock(mutex_);
    idle_.wait(lock, [this] { return waiting_.empty() && !busy_; });
}

void Packer::work() {
    std::unique_lock lock(mutex_);
    while (true) {
        wake_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
        if (ending_) return;
        const std::shared_ptr<PackedBytes> next = waiting_.front().lock();
        waiting_.pop_front();
        busy_ = true;
        lock.unlock();
        if (next != nullptr) {
            // `plain` is written here alone; who reads it meanwhile holds its lock, as we do to
            // exchange it.
            std::vector<std::byte> packed = app::pack(next->plain);
            if (!packed.empty()) {
                const std::lock_guard exchange(next->mutex);
                next->plain_size = next->plain.size();
                next->packed = std::move(packed);
                next->plain = {};
            }
        }
        lock.lock();
        busy_ = false;
        idle_.notify_all();
    }
}

}  // namespace fettle::app
