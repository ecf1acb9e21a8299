#pragma once

#include <partition/union_find.h>

#include <cstdint>
#include <span>
#include <vector>

// Blocks of bodies. No contact between two blocks moves a body. So each block can be solved through
// all sub-steps before the next one, or several threads can solve one block each. A block contains
// whole islands, as many as possible while its contacts stay in the cache of a core from the first
// pass to the last.
//
// There are several blocks only while all acting constraints are wide contacts between bodies that
// move freely; then the result does not depend on the blocks. If nearly the whole world is one
// island, there is only one block, because searching for islands in every step would gain nothing.

namespace fettle::physics::detail {

struct SolverBlock {
    uint32_t first_body = 0, body_end = 0;    ///< in the order of the blocks
    uint32_t first_group = 0, group_end = 0;  ///< of wide contacts
    uint32_t first_section = 0;               ///< in the numbering over all blocks
    uint32_t contacts = 0;                    ///< in groups, when the block was made
    bool cut = false;                         ///< several threads share its work
};

class SolverBlocks {
  public:
    /// Contacts of a full block. With 112 bytes each, they fill half of the second-level cache of a
    /// small core.
    static constexpr uint32_t enough_contacts = 2000;
    static constexpr uint32_t enough_bodies = 4000;

    /// `bodies`: the number of bodies plus one, because body 0 is the fixed one.
    void begin(uint32_t bodies);
    /// The two bodies influence each other in this step.
    void link(uint32_t a, uint32_t b) { islands_.unite(a, b); }
    /// Counts a contact of an island, given one of its bodies. After the last one, call `finish`.
    void count_contact(uint32_t body);
    void find_islands();
    void finish();
    /// Puts all bodies into the first block, for small worlds.
    void finish_as_one();
    /// True if `finish` found nearly all contacts in one block; then no blocks are searched for
    /// several steps.
    bool are_mostly_one();
    /// Must be called once in each step that could use several blocks: returns whether to search
    /// for them.
    bool may_be_several() { return wait_ == 0 || --wait_ == 0; }

    /// The next blocks are built for these bodies. `several`: there may be more than one block.
    void set_bodies(std::span<const uint32_t> bodies, bool several);
    /// True if the blocks were built for these bodies in this order, so that a contact that links
    /// two blocks matters.
    bool may_be_linked(std::span<const uint32_t> bodies) const;
    /// True if the blocks can be used again for a step with these bodies, provided that no contact
    /// links two blocks.
    bool may_stay(std::span<const uint32_t> bodies, bool several);

    uint32_t block_of(uint32_t body) const { return block_of_[body]; }
    std::size_t size() const { return blocks_.size(); }
    SolverBlock& operator[](std::size_t block) { return blocks_[block]; }
    const SolverBlock& operator[](std::size_t block) const { return blocks_[block]; }
    std::span<const uint32_t> bodies_of(const SolverBlock& block) const {
        return std::span(order_).subspan(block.first_body, block.body_end - block.first_body);
    }

    /// Scratch: the data stored between steps only save work.
    static void scratch(auto& io, auto& self) {
        io(self.islands_.parent), io(self.contacts_), io(self.block_of_);
        io(self.order_), io(self.blocks_), io(self.bodies_);
    }

  private:
    bool are_built_for(std::span<const uint32_t> bodies) const;
    void order_bodies();

    UnionFind islands_;
    std::vector<uint32_t> contacts_;  // by root
    std::vector<uint32_t> block_of_;  // by body
    std::vector<uint32_t> order_;     // bodies by block
    std::vector<SolverBlock> blocks_;
    std::vector<uint32_t> bodies_;  // slots of the bodies in the blocks
    bool several_ = false;
    int age_ = 0, wait_ = 0;  // steps
};

}  // namespace fettle::physics::detail
