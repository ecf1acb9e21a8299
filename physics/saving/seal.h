#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace fettle::physics::detail {

/// Header of a saved world. Every word of it is compared when the world is restored, so that no
/// changed byte stays undetected.
struct SavedHeader {
    uint32_t magic;
    uint32_t version;
    uint32_t layout;      ///< of the records that are copied byte by byte
    uint32_t byte_order;  ///< has another value on a machine with another byte order
    uint64_t size;        ///< bytes in all, with this header
    uint64_t checksum;    ///< of all bytes after it
};
static_assert(sizeof(SavedHeader) == 32);

/// Checksum of the bytes and their number. A change within one word of eight bytes always gives
/// another checksum; other changes are missed once in 2⁶⁴. It does not protect against deliberate
/// changes.
uint64_t checksum(std::span<const std::byte> bytes);

/// Writes size and checksum into the header of a complete saved world. Tests that damage a saved
/// world, to reach the checks after the checksum, call it again.
void seal(std::span<std::byte> saved);

}  // namespace fettle::physics::detail
