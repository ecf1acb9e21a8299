#include "nodes.h"

#include <algorithm>
#include <charconv>
#include <iterator>

#include <fettle/property/error.h>

namespace fettle::property {
namespace {

// The number after the last underscore, if the same text results when the number is written again.
std::uint32_t trailing_number(std::string_view text, std::string_view& base) {
    base = text;
    const std::size_t underscore = text.rfind('_');
    if (underscore == std::string_view::npos || underscore == 0) return 0;
    const std::string_view digits = text.substr(underscore + 1);
    if (digits.empty() || digits.size() > 9 || digits.front() == '0') return 0;
    std::uint32_t number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error != std::errc() || end != digits.data() + digits.size()) return 0;
    base = text.substr(0, underscore);
    return number;
}

std::size_t hash_of(std::uint32_t parent, NodeName name) {
    std::uint64_t h = std::uint64_t{parent} * 0x9e3779b97f4a7c15u;
    h ^= (std::uint64_t{name.base.id()} << 32 | name.number) * 0xc2b2ae3d27d4eb4fu;
    h ^= h >> 29;
    h *= 0x165667b19e3779f9u;
    return static_cast<std::size_t>(h ^ h >> 32);
}

}  // namespace

NodeName NodeName::make(std::string_view text) {
    std::string_view base;
    const std::uint32_t number = trailing_number(text, base);
    return {Symbol(base), number};
}

NodeName NodeName::look_up(std::string_view text) {
    std::string_view base;
    const std::uint32_t number = trailing_number(text, base);
    return {Symbol::find(base), number};
}

std::string NodeName::text() const {
    return number == 0 ? base.text() : base.text() + "_" + std::to_string(number);
}

std::uint32_t Nodes::allocate() {
    std::uint32_t index;
    if (free_.empty()) {
        index = end();
        // The table grows by an eighth. Doubling would cost more memory than the instances
        // themselves.
        if (nodes_.size() == nodes_.capacity()) nodes_.reserve(index + index / 8 + 64);
        nodes_.emplace_back();
        ++count_;
        if (!issued_.empty()) nodes_[index].generation = next_generation(index, 0);
    } else {
        index = free_.back();
        free_.pop_back();
        const std::uint32_t generation = nodes_[index].generation;
        nodes_[index] = Node{};
        nodes_[index].generation = generation;
    }
    nodes_[index].dead = 0;
    ++alive_;
    return index;
}

std::uint32_t Nodes::next_generation(std::uint32_t index, std::uint32_t after) {
    if (const auto found = issued_.find(index); found != issued_.end()) {
        after = std::max(after, found->second);
        issued_.erase(found);
    }
    return after + 1;
}

void Nodes::release(std::uint32_t index, bool keep) {
    Node& node = nodes_[index];
    if (node.counts_children)
        counters_.erase(counters_.lower_bound(counter_key(index, {})),
                        counters_.lower_bound(counter_key(index + 1, {})));
    child_counts_.erase(index);
    if (numbered_.parent == index) numbered_ = {};
    node.dead = 1;
    node.being_deleted = 0;
    node.kept = keep;
    // The generation of a reserved slot still identifies its former instance.
    node.generation = keep ? node.generation + 1 : next_generation(index, node.generation);
    --alive_;
    // A slot whose generations are used up is never used again, because no handle may ever mean two
    // instances.
    if (node.generation != 0 && !keep) free_.push_back(index);
}

void Nodes::revive(Handle handle) {
    while (handle.index >= end()) {
        nodes_.emplace_back();
        free_.push_back(count_++);
    }
    Node& node = nodes_[handle.index];
    if (node.alive())
        throw Error(ErrorKind::bad_structure, "an instance cannot be made where another one is");
    if (!node.kept) {
        // The search begins at the end: when edits are redone, the slot is nearly always the last
        // one.
        const auto found = std::find(free_.rbegin(), free_.rend(), handle.index);
        if (found != free_.rend()) free_.erase(std::next(found).base());
        // Generations that were given to this slot meanwhile must not be given again.
        if (const std::uint32_t last = node.generation - 1; last > handle.generation)
            issued_[handle.index] = std::max(issued_[handle.index], last);
    }
    node = Node{};
    node.generation = handle.generation;
    node.dead = 0;
    ++alive_;
}

bool Nodes::keeps(Handle handle) const {
    if (handle.index >= end()) return false;
    const Node& node = nodes_[handle.index];
    return node.kept && !node.alive() && node.generation == handle.generation + 1;
}

void Nodes::free_kept(Handle handle) {
    if (!keeps(handle)) return;
    Node& node = nodes_[handle.index];
    node.kept = false;
    node.generation = next_generation(handle.index, handle.generation);
    if (node.generation != 0) free_.push_back(handle.index);
}

void Nodes::reorder(std::uint32_t index, std::uint32_t before) {
    Node& node = nodes_[index];
    const std::uint32_t parent = node.parent;
    if (parent == 0 || before == index) return;
    if (before != 0 && nodes_[before].parent != parent) return;
    detach_link(index);
    if (numbered_.parent == parent) numbered_ = {};
    Node& above = nodes_[parent];
    const std::uint32_t behind = before == 0 ? above.first_child : nodes_[before].next;
    const std::uint32_t last = above.first_child == 0 ? 0 : nodes_[above.first_child].previous;
    node.next = behind;
    if (before == 0) above.first_child = index;
    if (before != 0) nodes_[before].next = index;
    // `previous` of the first child is the last child.
    node.previous = before != 0 ? before : last == 0 ? index : last;
    if (behind != 0) nodes_[behind].previous = index;
    if (behind == 0) nodes_[above.first_child].previous = index;
}

/// Updates the caches about the children of a parent when a child leaves its place.
void Nodes::child_leaves(std::uint32_t index) {
    const Node& node = nodes_[index];
    if (!child_counts_.empty())
        if (const auto counted = child_counts_.find(node.parent); counted != child_counts_.end())
            --counted->second;
    if (numbered_.parent != node.parent) return;
    // The next sibling now has the number of this child. Otherwise, it is unknown whether the child
    // stood before the cached one, so the cache is cleared.
    if (numbered_.child == index && node.next != 0)
        numbered_.child = node.next;
    else
        numbered_ = {};
}

std::uint32_t Nodes::child_count(std::uint32_t parent) const {
    const auto [counted, first] = child_counts_.try_emplace(parent, 0);
    if (first)
        for (std::uint32_t i = nodes_[parent].first_child; i != 0; i = nodes_[i].next)
            ++counted->second;
    return counted->second;
}

std::uint32_t Nodes::nth_child(std::uint32_t parent, std::uint64_t n) const {
    const std::uint32_t first = nodes_[parent].first_child;
    if (n < 1 || first == 0) return 0;
    Numbered at{parent, first, 1};
    if (numbered_.parent == parent && numbered_.number <= 2 * n) at = numbered_;
    if (n > at.number + 16) {
        const std::uint64_t count = child_count(parent);
        if (n > count) return 0;
        if (count - n < n - at.number) at = {parent, nodes_[first].previous, count};
    }
    for (; at.number < n && at.child != 0; ++at.number) at.child = nodes_[at.child].next;
    for (; at.number > n; --at.number) at.child = nodes_[at.child].previous;
    if (at.child != 0) numbered_ = at;
    return at.child;
}

std::size_t Nodes::depth(std::uint32_t index) const {
    std::size_t levels = 0;
    for (; index != 0; index = nodes_[index].parent) ++levels;
    return levels;
}

std::size_t Nodes::height(std::uint32_t top) const {
    std::size_t levels = 1, highest = 1;
    for (std::uint32_t index = top;;) {
        if (nodes_[index].first_child != 0) {
            index = nodes_[index].first_child;
            highest = std::max(highest, ++levels);
            continue;
        }
        while (index != top && nodes_[index].next == 0) {
            index = nodes_[index].parent;
            --levels;
        }
        if (index == top) return highest;
        index = nodes_[index].next;
    }
}

void Nodes::detach_link(std::uint32_t index) {
    Node& node = nodes_[index];
    Node& above = nodes_[node.parent];
    if (above.first_child == index) {
        above.first_child = node.next;
        if (node.next != 0) nodes_[node.next].previous = node.previous;
    } else {
        nodes_[node.previous].next = node.next;
        const std::uint32_t after = node.next != 0 ? node.next : above.first_child;
        nodes_[after].previous = node.previous;
    }
}

void Nodes::link(std::uint32_t index, std::uint32_t parent, NodeName name) {
    Node& node = nodes_[index];
    node.parent = parent;
    node.name = name;
    node.next = 0;
    if (parent == 0) return;
    Node& above = nodes_[parent];
    if (above.first_child == 0) {
        above.first_child = index;
        node.previous = index;
    } else {
        Node& first = nodes_[above.first_child];
        node.previous = first.previous;
        nodes_[first.previous].next = index;
        first.previous = index;
    }
    if (!child_counts_.empty())
        if (const auto counted = child_counts_.find(parent); counted != child_counts_.end())
            ++counted->second;
    index_insert(index);
}

void Nodes::unlink(std::uint32_t index) {
    Node& node = nodes_[index];
    if (node.parent == 0) return;
    if (node.name.number == 1) counter(node.parent, node.name.base);  // its number stays given
    index_erase(index);
    child_leaves(index);
    detach_link(index);
    node.parent = node.next = node.previous = 0;
}

std::size_t Nodes::slot_of(std::uint32_t parent, NodeName name) const {
    const std::size_t mask = index_.size() - 1;
    std::size_t slot = hash_of(parent, name) & mask;
    while (index_[slot] != 0) {
        const Node& node = nodes_[index_[slot]];
        if (node.parent == parent && node.name == name) break;
        slot = (slot + 1) & mask;
    }
    return slot;
}

std::uint32_t Nodes::child(std::uint32_t parent, NodeName name) const {
    return name.base ? index_[slot_of(parent, name)] : 0;
}

void Nodes::index_insert(std::uint32_t index) {
    if (++indexed_ * 3 > index_.size() * 2) {
        std::vector<std::uint32_t> old(index_.size() * 2, 0);
        old.swap(index_);
        for (const std::uint32_t moved : old)
            if (moved != 0) index_[slot_of(nodes_[moved].parent, nodes_[moved].name)] = moved;
    }
    index_[slot_of(nodes_[index].parent, nodes_[index].name)] = index;
}

void Nodes::index_erase(std::uint32_t index) {
    const std::size_t mask = index_.size() - 1;
    std::size_t hole = slot_of(nodes_[index].parent, nodes_[index].name);
    index_[hole] = 0;
    --indexed_;
    for (std::size_t slot = (hole + 1) & mask; index_[slot] != 0; slot = (slot + 1) & mask) {
        const Node& node = nodes_[index_[slot]];
        const std::size_t home = hash_of(node.parent, node.name) & mask;
        if (((slot - home) & mask) < ((slot - hole) & mask)) continue;
        index_[hole] = index_[slot];
        index_[slot] = 0;
        hole = slot;
    }
}

/// The last number that was given; creates the entry if there is none.
std::uint32_t& Nodes::counter(std::uint32_t parent, Symbol stem) {
    nodes_[parent].counts_children = true;
    return counters_.try_emplace(counter_key(parent, stem), 1).first->second;
}

}  // namespace fettle::property
