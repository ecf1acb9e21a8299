#pragma once
// What is kept of writes once they have been told: which cell each of them wrote, in as few bytes
// as those of one piece differ in. A game writes much the same cells again and again, or those of
// instances that were made one after the other: four bytes a write instead of 32.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include <fettle/property/observer.h>

namespace fettle::property {

class PackedWrites {
  public:
    explicit PackedWrites(std::span<const PlainWrite> writes);

    struct Found {
        std::size_t number = 0;  // from 1 on; 0: none of that cell
        std::uint32_t generation = 0;
    };
    /// The last write to a property of whoever had that slot.
    Found last(std::uint32_t index, Symbol property) const;

  private:
    /// One number of each write, as bits in which it differs from that of the first.
    struct Column {
        std::uint32_t first = 0;
        std::uint32_t width = 0;  // in bytes
        std::uint32_t mask = 0;   // of so many bytes
        void hold(std::uint32_t all_differences);
        std::uint32_t value(const std::byte* bytes) const;
    };

    std::uint32_t count_;
    Column index_, generation_, property_;
    std::unique_ptr<std::byte[]> bytes_;  // null where all are of one cell
};

}  // namespace fettle::property
