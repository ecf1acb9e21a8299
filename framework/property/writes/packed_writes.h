#pragma once
// Compressed record of reported writes: the written cell of each. Only the differing bytes are
// stored. A game mostly writes the same cells, or cells of instances that were made in sequence, so
// a write takes four bytes instead of 32.

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
        std::size_t number = 0;  // from 1; 0: the cell was not written
        std::uint32_t generation = 0;
    };
    /// The last write, of the first `count` ones, to that property of an instance in that slot.
    Found last(std::uint32_t index, Symbol property, std::size_t count) const;
    std::size_t count() const { return count_; }
    struct Write {
        Handle instance;
        std::uint32_t property = 0;  // the id of its symbol
    };
    /// The write with that index.
    Write at(std::size_t i) const;

  private:
    /// One number of each write, stored as the bits in which it differs from the first write.
    struct Column {
        std::uint32_t first = 0;
        std::uint32_t width = 0;  // in bytes
        std::uint32_t mask = 0;   // covers `width` bytes
        void hold(std::uint32_t all_differences);
        std::uint32_t value(const std::byte* bytes) const;
    };

    std::uint32_t count_;
    Column index_, generation_, property_;
    std::unique_ptr<std::byte[]> bytes_;  // null if all writes have the same cell
};

}  // namespace fettle::property
