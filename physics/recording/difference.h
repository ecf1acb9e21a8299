#pragma once

#include <recording/chunks.h>
#include <state/world_state.h>

// The difference of two states of a world as bytes. A recording has the states before and after the
// edits between two steps by this difference: so it has the effect of every edit, whatever method
// made it, and the effect of reads that update edited data.

namespace fettle::physics::detail {

/// The state of a world in bytes, as it is saved, in blocks: each member, or the elements of a
/// list, is one. An edit changes few of them.
struct StateBlocks {
    std::vector<std::byte> bytes;
    std::vector<size_t> ends;  ///< of the blocks in `bytes`

    void read(const WorldState& state);
    std::span<const std::byte> block(size_t number) const {
        const size_t begin = number == 0 ? 0 : ends[number - 1];
        return std::span(bytes).subspan(begin, ends[number] - begin);
    }
};

/// Writes the changes from `before` to `now`. False, and writes nothing, if there are none.
bool write_difference(const StateBlocks& before, const StateBlocks& now, ByteWriter& out);

/// The bytes of the state `now`, from `before` and the difference. Throws std::invalid_argument if
/// the two do not belong together.
std::vector<std::byte> apply_difference(const StateBlocks& before, ByteReader& in);

}  // namespace fettle::physics::detail
