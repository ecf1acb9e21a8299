#include <fettle/physics/position.h>
#include <saving/checksum.h>
#include <saving/words.h>

#include <cstring>

namespace fettle::physics::detail {
namespace {

// Number of sums that are computed in parallel, in vectors.
constexpr size_t block_words = 8;

/// Reads the words of a block, with their lowest byte first.
void load_block(const std::byte* from, uint64_t (&block)[block_words]) {
    for (size_t i = 0; i < block_words; ++i)
        block[i] = load_word<uint64_t>(from + i * sizeof(uint64_t));
}

/// The sums over the blocks. From one previous value, two different words give two different values
/// of `mixed`; with one word, two different previous values do, too. So one changed word changes
/// `mixed`. A second changed word of the same sum can undo that, but then `sum` still differs.
struct Sums {
    uint64_t mixed[block_words] = {1, 2, 3, 4, 5, 6, 7, 8};
    uint64_t sum[block_words] = {};

    void add(const uint64_t (&block)[block_words]) {
        for (size_t i = 0; i < block_words; ++i) mixed[i] ^= block[i];
        for (size_t i = 0; i < block_words; ++i) mixed[i] += mixed[i] << 29;
        for (size_t i = 0; i < block_words; ++i) mixed[i] ^= mixed[i] >> 32;
        for (size_t i = 0; i < block_words; ++i) sum[i] += mixed[i];
    }
};

uint64_t combine(uint64_t before, uint64_t word) {
    const uint64_t product = (before ^ word) * 0x9e3779b97f4a7c15u;
    return product ^ (product >> 32);
}

}  // namespace

uint64_t checksum(std::span<const std::byte> bytes) {
    Sums sums;
    uint64_t block[block_words];
    const std::byte* at = bytes.data();
    size_t left = bytes.size();
    for (; left >= sizeof block; left -= sizeof block, at += sizeof block) {
        load_block(at, block);
        sums.add(block);
    }
    if (left > 0) {
        std::byte last[sizeof block] = {};
        std::memcpy(last, at, left);
        load_block(last, block);
        sums.add(block);
    }
    uint64_t all = combine(0, bytes.size());
    for (size_t i = 0; i < block_words; ++i)
        all = combine(combine(all, sums.mixed[i]), sums.sum[i]);
    return all;
}

std::string other_precision(const char* made) {
    const bool is_single = sizeof(WorldCoordinate) == sizeof(float);
    return std::string(made) + " with positions in " + (is_single ? "double" : "single") +
           " precision, and this library has " + (is_single ? "single" : "double") +
           " precision (FETTLE_PHYSICS_DOUBLE)";
}

void write_checksum(std::span<std::byte> saved) {
    SavedHeader header = {};
    if (saved.size() < sizeof header) return;
    Decoder{saved.data()}(header);
    header.size = saved.size();
    header.checksum = checksum(saved.subspan(sizeof header));
    Encoder{saved.data()}(header);
}

}  // namespace fettle::physics::detail
