#include <partition/blocks.h>

#include <algorithm>

namespace fettle::physics::detail {
namespace {

/// Number of steps after which blocks are built again, because islands may have separated.
constexpr int max_age = 64;

/// An island with this share of the contacts is nearly the whole world.
constexpr float nearly_all = 0.75f;

}  // namespace

void SolverBlocks::set_bodies(std::span<const uint32_t> bodies, bool several) {
    bodies_.assign(bodies.begin(), bodies.end());
    several_ = several;
    age_ = 0;
}

bool SolverBlocks::are_built_for(std::span<const uint32_t> bodies) const {
    return block_of_.size() == bodies.size() + 1 &&
           std::equal(bodies_.begin(), bodies_.end(), bodies.begin(), bodies.end());
}

bool SolverBlocks::may_be_linked(std::span<const uint32_t> bodies) const {
    return several_ && are_built_for(bodies);
}

bool SolverBlocks::may_stay(std::span<const uint32_t> bodies, bool several) {
    if (several != several_ || !are_built_for(bodies)) return false;
    return !several || ++age_ < max_age;
}

void SolverBlocks::begin(uint32_t bodies) {
    islands_.reset(bodies);
    contacts_.assign(bodies, 0);
    block_of_.assign(bodies, 0);
    blocks_.assign(1, {});
}

/// A root has a lower index than the bodies below it.
void SolverBlocks::find_islands() {
    auto& root = islands_.parent;
    for (uint32_t i = 1; i < root.size(); ++i) root[i] = root[root[i]];
}

void SolverBlocks::count_contact(uint32_t body) {
    ++contacts_[islands_.parent[body]];
}

void SolverBlocks::finish() {
    uint32_t contacts = 0, bodies = 0;  // in the last block
    for (uint32_t i = 1; i < islands_.parent.size(); ++i) {
        const uint32_t island = islands_.parent[i];
        if (island == i) {
            if (blocks_.size() == 1 || contacts + contacts_[i] > enough_contacts ||
                bodies >= enough_bodies) {
                blocks_.emplace_back();
                contacts = bodies = 0;
            }
            contacts += contacts_[i];
            blocks_.back().contacts = contacts;
            block_of_[i] = uint32_t(blocks_.size() - 1);
        }
        block_of_[i] = block_of_[island];
        ++bodies;
    }
    order_bodies();
}

bool SolverBlocks::are_mostly_one() {
    uint32_t all = 0, most = 0;
    for (const SolverBlock& block : blocks_) {
        all += block.contacts;
        most = std::max(most, block.contacts);
    }
    if (float(most) < nearly_all * float(all)) return false;
    wait_ = max_age;
    return true;
}

void SolverBlocks::finish_as_one() {
    order_bodies();
}

void SolverBlocks::order_bodies() {
    for (uint32_t i = 1; i < block_of_.size(); ++i) ++blocks_[block_of_[i]].body_end;
    uint32_t begin = 0;
    for (SolverBlock& block : blocks_) {
        const uint32_t count = block.body_end;
        block.first_body = block.body_end = begin;
        begin += count;
    }
    order_.resize(begin);
    for (uint32_t i = 1; i < block_of_.size(); ++i) order_[blocks_[block_of_[i]].body_end++] = i;
}

}  // namespace fettle::physics::detail
