#include <time/keyframe_compression.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>

#include <sys/resource.h>
#include <zstd.h>

namespace fettle::app {
namespace {

// The fastest useful level: it halves the size that remains after sorting the bytes.
constexpr int level = 1;

// Data is compressed in pieces, so that compression needs little additional memory.
constexpr std::size_t piece_size = std::size_t{1} << 20;  // bytes, a multiple of 4

// Sorts the bytes of 4-byte words by their position in the word. State is mostly floats, whose
// bytes of the same position repeat far more often. This saves a sixth of the size and half the
// time.
void sort_by_rank(std::span<const std::byte> plain, std::byte* ranks) {
    const std::size_t words = plain.size() / 4;
    for (std::size_t rank = 0; rank < 4; ++rank)
        for (std::size_t i = 0; i < words; ++i) ranks[rank * words + i] = plain[4 * i + rank];
    for (std::size_t i = 4 * words; i < plain.size(); ++i) ranks[i] = plain[i];
}

void sort_from_ranks(std::span<const std::byte> ranks, std::byte* plain) {
    const std::size_t words = ranks.size() / 4;
    for (std::size_t rank = 0; rank < 4; ++rank)
        for (std::size_t i = 0; i < words; ++i) plain[4 * i + rank] = ranks[rank * words + i];
    for (std::size_t i = 4 * words; i < ranks.size(); ++i) plain[i] = ranks[i];
}

/// Lowers the priority of the packing thread, so that the game goes first if there are few
/// processors.
void lower_priority() {
#ifdef __linux__  // elsewhere it would change the whole process
    constexpr int niceness = 10;
    (void)setpriority(PRIO_PROCESS, 0, niceness);
#endif
}

}  // namespace

// Each piece is a zstd frame with its size before it.
void PackedBytes::pack() {
    using Size = std::uint32_t;
    std::vector<std::byte> ranks(std::min(piece_size, plain_size_)), packed;
    std::vector<std::byte> frame(sizeof(Size) + ZSTD_compressBound(ranks.size()));
    for (std::size_t at = 0; at < plain_size_; at += piece_size) {
        const auto piece = std::span(plain_).subspan(at, std::min(piece_size, plain_size_ - at));
        sort_by_rank(piece, ranks.data());
        const std::size_t size =
            ZSTD_compress(frame.data() + sizeof(Size), frame.size() - sizeof(Size), ranks.data(),
                          piece.size(), level);
        if (ZSTD_isError(size) != 0) return;  // the state stays unpacked
        const auto stored_size = static_cast<Size>(size);
        std::memcpy(frame.data(), &stored_size, sizeof stored_size);
        // Grow by an eighth and not by doubling, because unused capacity would stay allocated.
        if (const std::size_t wanted = packed.size() + sizeof stored_size + size;
            wanted > packed.capacity())
            packed.reserve(wanted + wanted / 8);
        packed.insert(packed.end(), frame.begin(),
                      frame.begin() + static_cast<std::ptrdiff_t>(sizeof stored_size + size));
    }
    packed.shrink_to_fit();
    packed_ = std::move(packed);
    // The first write to a page is slow, so it is done here and not in a step of the game.
    if (prepare_ != 0) next_.resize(prepare_);
    is_packed_.store(true, std::memory_order_release);
}

std::vector<std::byte> PackedBytes::payload() const {
    using Size = std::uint32_t;
    if (!is_packed_.load(std::memory_order_acquire)) return plain_;
    std::vector<std::byte> plain(plain_size_), ranks(std::min(piece_size, plain_size_));
    const std::byte* from = packed_.data();
    for (std::size_t at = 0; at < plain_size_; at += piece_size) {
        Size size = 0;
        std::memcpy(&size, from, sizeof size);
        from += sizeof size;
        const std::size_t piece = std::min(piece_size, plain_size_ - at);
        ZSTD_decompress(ranks.data(), piece, from, size);
        sort_from_ranks(std::span(ranks).first(piece), plain.data() + at);
        from += size;
    }
    return plain;
}

std::size_t PackedBytes::memory() const {
    const bool packed = is_packed_.load(std::memory_order_acquire);
    return touched_ + (packed ? packed_.capacity() + next_.capacity() : prepare_);
}

std::optional<PackedBytes::Buffer> PackedBytes::spare_buffer() {
    if (plain_.empty() || !is_packed_.load(std::memory_order_acquire)) return std::nullopt;
    const std::size_t touched = std::exchange(touched_, 0);
    if (next_.empty()) return Buffer{std::exchange(plain_, {}), touched};
    plain_ = {};
    const std::size_t made = next_.size();
    return Buffer{std::exchange(next_, {}), made};
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
    lower_priority();
    while (true) {
        std::shared_ptr<PackedBytes> next;
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
            if (ending_) return;
            next = waiting_.front().lock();
            waiting_.pop_front();
        }
        if (next != nullptr) next->pack();
    }
}

}  // namespace fettle::app
