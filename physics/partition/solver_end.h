#pragma once

#include <partition/strips.h>

#include <cstdint>

namespace fettle::physics::detail {

/// The end of a contact or joint in a step: index and strip of its body, and whether the body takes
/// impulses.
class SolverEnd {
  public:
    /// A fixed or sleeping body.
    SolverEnd() = default;
    /// `moves`: the body takes impulses.
    SolverEnd(uint32_t index, StripNode strip, bool moves)
        : bits_(index << strip_bits << 1 | uint32_t{strip} << 1 | moves) {
        static_assert(2 * most_strips <= 1 << strip_bits);
    }

    static SolverEnd of_hub(uint32_t index) { return {index, 0, true}; }

    uint32_t index() const { return bits_ >> strip_bits >> 1; }
    StripNode strip() const { return StripNode(bits_ >> 1 & ((1u << strip_bits) - 1)); }
    bool moves() const { return (bits_ & 1) != 0; }
    bool is_hub() const { return moves() && strip() == 0; }

  private:
    static constexpr int strip_bits = 4;
    uint32_t bits_ = 0;
};

/// The node of a contact or joint between two bodies that are not hubs. A body that takes no
/// impulses may be in any strip.
inline StripNode node_of(SolverEnd a, SolverEnd b) {
    if (a.moves() && b.moves()) return above_both(a.strip(), b.strip());
    return a.moves() || b.index() == 0 ? a.strip() : b.strip();
}

/// A contact that acts in this step: the data for coloring and grouping.
struct ActingContact {
    uint32_t slot = 0;
    SolverEnd end_a, end_b;
    uint32_t entry = 0;  ///< index in the counts of a thread: entry of its section and its color
    uint32_t place = 0;  ///< index in the entry; later its lane
    StripNode node = 1;
    uint8_t hub = 0;        ///< index + 1 of the hub whose copy it acts on; 0: no copy
    bool serially = false;  ///< solved one at a time
    uint8_t flags = 0;      ///< bits of `Flag`

    enum Flag : uint8_t {
        is_touching = 1,
        reports_hits = 2,
        on_impact_path = 4,   ///< an impact may go through it: restitution, or joints of a body
        approaches_fast = 8,  ///< fast enough for an impact
        in_impact = 16,       ///< an impact may pass through it in this step
        one_load = 32  ///< the load of the joints of its bodies is in the two bits from this one on
    };
    bool takes_impacts() const { return (flags & on_impact_path) != 0; }
    bool is_fast() const { return (flags & approaches_fast) != 0; }
    /// It is solved in a group, but its share of an impact is computed for it alone.
    bool passes_impacts() const { return (flags & in_impact) != 0 && !serially; }
    /// The load that joints of its bodies bear, as in `JointScratch`; 0: the usual one, or none.
    size_t load() const { return flags / one_load; }
    bool touching() const { return (flags & is_touching) != 0; }
    bool hit_events() const { return (flags & reports_hits) != 0; }

    uint32_t a() const { return end_a.index(); }
    uint32_t b() const { return end_b.index(); }
    bool moves_a() const { return end_a.moves(); }
    bool moves_b() const { return end_b.moves(); }
    bool both_move() const { return moves_a() && moves_b(); }
    /// A body of the contact that takes impulses.
    uint32_t mover() const { return moves_a() ? a() : b(); }
};
static_assert(sizeof(ActingContact) == 24);

/// Acting contacts that one thread found, sorted by node; contacts of one node are in the order of
/// the awake contacts.
struct ActingPiece {
    uint32_t begin = 0;
    NodeRanges nodes;           ///< from `begin` on
    uint32_t serially = 0;      ///< number of contacts that are solved one at a time
    uint32_t passing = 0;       ///< number of contacts in groups that may pass an impact on
    bool links_blocks = false;  ///< a contact links two blocks of an earlier step
    bool fast = false;          ///< shapes that may bounce approach fast

    uint32_t count() const { return nodes.size(); }
    uint32_t end() const { return begin + count(); }
};

}  // namespace fettle::physics::detail
