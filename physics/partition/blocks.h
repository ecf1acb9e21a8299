#pragma once

#include <partition/union_find.h>

#include <cstdint>
#include <span>
#include <vector>

// Bodies in blocks that can be solved one after the other, through all sub-steps, or each by
// another thread: no contact that moves anything links two of them. A block holds whole islands,
// and so many that its contacts stay in the cache of a core from the first pass to the last.
//
// A world has more than the first block only while all that acts are wide contacts between bodies
// that move freely: then it makes no difference to an island which block it is in. Nor has it more
// while nearly all of it is one island: then to look for islands in every step is in vain.

namespace fettle::physics::detail {

struct SolverBlock {
    uint32_t first_body = 0, body_end = 0;    ///< in the order of the blocks
    uint32_t first_group = 0, group_end = 0;  ///< of wide contacts
    uint32_t first_section = 0;               ///< of all blocks
    uint32_t contacts = 0;                    ///< in groups, when the block was made
    bool cut = false;                         ///< several threads share it out
};

class SolverBlocks {
  public:
    /// Contacts of a block: 112 bytes each, half of the second-level cache of a small core.
    static constexpr uint32_t enough_contacts = 2000;
    static constexpr uint32_t enough_bodies = 4000;

    /// `bodies`: one more than there are, since body 0 does not move.
    void begin(uint32_t bodies);
    /// They influence each other in this step.
    void link(uint32_t a, uint32_t b) { islands_.unite(a, b); }
    /// Of contacts by one of their bodies that moves; then `finish`.
    void count_contact(uint32_t body);
    void find_islands();
    void finish();
    /// All in the first block, when there is little to do.
    void finish_as_one();
    /// Found, as `finish` counted: then the next look is a while off.
    bool are_mostly_one();
    /// In each step that could do with several blocks, once: whether to look.
    bool may_be_several() { return wait_ == 0 || --wait_ == 0; }

    /// From here on these blocks are of those bodies; `several`: in more than the first.
    void remember(std::span<const uint32_t> bodies, bool several);
    /// They are of these bodies, in this order, and it matters whether something links two of them.
    bool may_be_linked(std::span<const uint32_t> bodies) const;
    /// For another step of these bodies, in which no contact links two of them.
    bool may_stay(std::span<const uint32_t> bodies, bool several);

    uint32_t block_of(uint32_t body) const { return block_of_[body]; }
    std::size_t size() const { return blocks_.size(); }
    SolverBlock& operator[](std::size_t block) { return blocks_[block]; }
    const SolverBlock& operator[](std::size_t block) const { return blocks_[block]; }
    std::span<const uint32_t> bodies_of(const SolverBlock& block) const {
        return std::span(order_).subspan(block.first_body, block.body_end - block.first_body);
    }

    /// What stays from step to step only saves work.
    template <class Io, class Self>
    static void scratch(Io& io, Self& self) {
        io(self.islands_.parent), io(self.contacts_), io(self.block_of_);
        io(self.order_), io(self.blocks_), io(self.bodies_);
    }

  private:
    bool are_of(std::span<const uint32_t> bodies) const;
    void order_bodies();

    UnionFind islands_;
    std::vector<uint32_t> contacts_;  // by root
    std::vector<uint32_t> block_of_;  // by body
    std::vector<uint32_t> order_;     // bodies by block
    std::vector<SolverBlock> blocks_;
    std::vector<uint32_t> bodies_;  // whose blocks these are: slots
    bool several_ = false;
    int age_ = 0, wait_ = 0;  // steps
};

}  // namespace fettle::physics::detail
