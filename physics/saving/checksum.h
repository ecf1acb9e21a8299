#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace fettle::physics::detail {

/// Header of a saved world. Every word of it is checked when the world is restored, so that every
/// changed byte is detected.
struct SavedHeader {
    uint32_t magic;
    uint32_t version;
    uint32_t records;     ///< computed from the sizes of the records in the saved world
    uint32_t coordinate;  ///< bytes of a coordinate of a position: 4 or 8
    uint64_t size;        ///< total number of bytes, this header included
    uint64_t checksum;    ///< of all bytes after it

    static void fields(auto& io, auto& s) {
        io(s.magic, s.version, s.records, s.coordinate, s.size, s.checksum);
    }
};
static_assert(sizeof(SavedHeader) == 32);

/// Checksum of the bytes and their number. A change inside one word of eight bytes always changes
/// it; other changes are missed with a probability of 2⁻⁶⁴. It does not protect against deliberate
/// changes.
uint64_t checksum(std::span<const std::byte> bytes);

/// The reason to refuse data that a library with the other precision of positions has written.
/// `made`: "the world was saved".
std::string other_precision(const char* made);

/// Writes size and checksum into the header of a complete saved world. Tests that damage a saved
/// world call it again, to reach the checks after the checksum.
void write_checksum(std::span<std::byte> saved);

}  // namespace fettle::physics::detail
