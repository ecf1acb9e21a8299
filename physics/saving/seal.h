#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace fettle::physics::detail {

/// What a saved world begins with. Every word of it is compared when the world is restored, so that
/// no byte of the whole can change unnoticed.
struct SavedHeader {
    uint32_t magic;
    uint32_t version;
    uint32_t layout;      ///< of the records that are copied as they are
    uint32_t byte_order;  ///< reads otherwise where bytes have another order
    uint64_t size;        ///< of all, this header included
    uint64_t checksum;    ///< of all that follows it
};
static_assert(sizeof(SavedHeader) == 32);

/// Of bytes and their number. Another value in any one word of eight bytes always gives another
/// checksum; other changes are missed once in 2⁶⁴. No protection against intent.
uint64_t checksum(std::span<const std::byte> bytes);

/// Writes size and checksum into a saved world whose bytes are all there. Tests that damage one to
/// see what lies behind the checksum call it again.
void seal(std::span<std::byte> saved);

}  // namespace fettle::physics::detail
