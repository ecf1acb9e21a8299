#pragma once

#include "catch.h"
#include "scenes.h"

#include <saving/checksum.h>
#include <saving/fields.h>
#include <saving/words.h>

#include <algorithm>
#include <cstring>
#include <vector>

// Saved worlds, and what becomes of them when some of their bits are flipped.

namespace scenes {

inline std::vector<std::byte> saved(const World& world) {
    std::vector<std::byte> bytes;
    world.save(bytes);
    return bytes;
}

/// The offset of a field in a saved record: of the first byte that differs after `change`.
template <class Record, class Change>
size_t place_in(Change change) {
    Record one{}, other{};
    change(other);
    std::vector<std::byte> bytes(detail::encoded_size<Record>()), changed(bytes.size());
    detail::Encoder{bytes.data()}(one);
    detail::Encoder{changed.data()}(other);
    const auto at = std::mismatch(bytes.begin(), bytes.end(), changed.begin()).first;
    REQUIRE((at != bytes.end()));
    return size_t(at - bytes.begin());
}

/// Where the number is in the bytes, which hold it once.
inline size_t place_of(uint64_t number, const std::vector<std::byte>& bytes) {
    size_t found = bytes.size();
    for (size_t at = 0; at + sizeof number <= bytes.size(); ++at) {
        if (std::memcmp(&bytes[at], &number, sizeof number) != 0) continue;
        REQUIRE(found == bytes.size());
        found = at;
    }
    REQUIRE(found < bytes.size());
    return found;
}

/// Three bits flipped behind the header, `trials` times, and sealed again, so that the checksum
/// holds: refused, or restored to a world that can be stepped and read with `look(world)`.
/// Both happen.
template <class Look>
void check_flipped_bits(const std::vector<std::byte>& bytes, uint64_t seed, int trials, Look look) {
    uint64_t state = seed;
    const auto next = [&state] {
        return state = state * 6364136223846793005u + 1442695040888963407u;
    };
    int refused = 0;
    for (int trial = 0; trial < trials; ++trial) {
        auto damaged = bytes;
        constexpr size_t header = sizeof(detail::SavedHeader);
        for (int flips = 0; flips < 3; ++flips)
            damaged[header + (next() >> 20) % (bytes.size() - header)] ^=
                std::byte(1 << (next() >> 60) % 8);
        detail::write_checksum(damaged);
        World target;
        try {
            target.restore(damaged);
            for (int i = 0; i < 3; ++i) target.step(frame);
            look(target);
        } catch (const std::invalid_argument&) {
            ++refused;
        }
    }
    REQUIRE(refused > 0);
    REQUIRE(refused < trials);
}

}  // namespace scenes
