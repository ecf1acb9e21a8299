#include "packed_writes.h"

#include <bit>
#include <cstring>

namespace fettle::property {

void PackedWrites::Column::hold(std::uint32_t all_differences) {
    width = (static_cast<std::uint32_t>(std::bit_width(all_differences)) + 7) / 8;
    mask = width == 4 ? ~0u : (1u << 8 * width) - 1;
}

std::uint32_t PackedWrites::Column::value(const std::byte* bytes) const {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes, sizeof word);
    return first ^ (word & mask);
}

PackedWrites::PackedWrites(std::span<const PlainWrite> writes)
    : count_(static_cast<std::uint32_t>(writes.size())) {
    index_.first = writes.front().instance.index;
    generation_.first = writes.front().instance.generation;
    property_.first = writes.front().property->symbol.id();
    std::uint32_t index = 0, generation = 0, property = 0;
    for (const PlainWrite& write : writes) {
        index |= write.instance.index ^ index_.first;
        generation |= write.instance.generation ^ generation_.first;
        property |= write.property->symbol.id() ^ property_.first;
    }
    index_.hold(index);
    generation_.hold(generation);
    property_.hold(property);
    const std::size_t stride = index_.width + generation_.width + property_.width;
    if (stride == 0) return;
    // Every number is written as four bytes; the next number overwrites the unused ones. The last
    // one needs the extra room.
    bytes_ = std::make_unique_for_overwrite<std::byte[]>(writes.size() * stride + 4);
    std::byte* to = bytes_.get();
    const auto put = [&to](std::uint32_t difference, const Column& column) {
        std::memcpy(to, &difference, sizeof difference);
        to += column.width;
    };
    for (const PlainWrite& write : writes) {
        put(write.instance.index ^ index_.first, index_);
        put(write.instance.generation ^ generation_.first, generation_);
        put(write.property->symbol.id() ^ property_.first, property_);
    }
}

PackedWrites::Found PackedWrites::last(std::uint32_t index, Symbol property,
                                       std::size_t count) const {
    // Quick test that excludes most pieces.
    if (((index ^ index_.first) & ~index_.mask) != 0 ||
        ((property.id() ^ property_.first) & ~property_.mask) != 0)
        return {};
    if (bytes_ == nullptr) return {count, generation_.first};
    const std::size_t stride = index_.width + generation_.width + property_.width;
    for (std::size_t number = count; number > 0; --number) {
        const std::byte* const generation = bytes_.get() + (number - 1) * stride + index_.width;
        if (index_.value(generation - index_.width) == index &&
            property_.value(generation + generation_.width) == property.id())
            return {number, generation_.value(generation)};
    }
    return {};
}

PackedWrites::Write PackedWrites::at(std::size_t i) const {
    if (bytes_ == nullptr) return {{index_.first, generation_.first}, property_.first};
    const std::size_t stride = index_.width + generation_.width + property_.width;
    const std::byte* const index = bytes_.get() + i * stride;
    const std::byte* const generation = index + index_.width;
    return {{index_.value(index), generation_.value(generation)},
            property_.value(generation + generation_.width)};
}

}  // namespace fettle::property
