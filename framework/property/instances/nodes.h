#pragma once
// Nodes: who is whose child, what everyone is called. Compact (40 bytes and 6 to 12 in a table of
// names) because a game may have a hundred thousand of them.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <fettle/property/bytes.h>
#include <fettle/property/class.h>
#include <fettle/property/symbol.h>
#include <fettle/property/value.h>

namespace fettle::property {

/// A name in two parts, so that a hundred thousand generated names ("body_4711") intern one symbol.
struct NodeName {
    Symbol base;
    std::uint32_t number = 0;  // 0: none

    static NodeName make(std::string_view text);
    /// Like `make`, without interning: an unknown name gives an empty base.
    static NodeName look_up(std::string_view text);
    std::string text() const;
    friend bool operator==(const NodeName&, const NodeName&) = default;
};

struct Node {
    std::uint32_t generation = 1;
    std::uint32_t parent = 0;
    std::uint32_t first_child = 0;
    std::uint32_t next = 0;
    std::uint32_t previous = 0;  // of the first child: the last one
    NodeName name;
    Row row = 0;
    std::uint32_t stored_row = 0;
    std::uint16_t class_id = 0;
    // Numbers of one bit rather than bools: compilers look at several of them at once. Those that
    // stand in the way of a write stand there when they are set.
    std::uint8_t dead : 1 = 1;
    std::uint8_t watched : 1 = 0;     // somebody watches this very instance
    std::uint8_t fresh : 1 = 0;       // made since the last barrier: nobody has been told of it
    std::uint8_t has_ad_hoc : 1 = 0;  // looked up only then
    std::uint8_t has_formula : 1 = 0;
    std::uint8_t has_dependents : 1 = 0;  // a formula read something of it
    std::uint8_t named : 1 = 0;           // the user named it, so that a new parent keeps the name
    std::uint8_t counts_children : 1 = 0;
    std::uint8_t kept : 1 = 0;   // dead, and its slot waits for it to come back
    std::uint8_t dying : 1 = 0;  // it is being deleted

    bool alive() const { return !dead; }
    /// Its cells say what its properties are.
    bool readable() const { return !dead && !has_formula; }
    /// And nobody has to be told at once of what is written to them.
    bool writable() const { return !dead && !watched && !has_formula && !has_dependents; }
};
static_assert(sizeof(Node) == 40);

/// Where an instance hangs. `before`: the sibling in front of it.
struct Position {
    Handle parent;
    Handle before;
    NodeName name;
    bool named = false;
};

/// Slots of nodes and their links. Index 0 is nobody.
class Nodes {
  public:
    Nodes() : nodes_(1), index_(64, 0) {}

    Node* find(Handle handle) {
        if (handle.index >= end()) return nullptr;
        Node* const node = nodes_.data() + handle.index;
        return node->generation == handle.generation && node->alive() ? node : nullptr;
    }
    const Node* find(Handle handle) const { return const_cast<Nodes*>(this)->find(handle); }
    /// If all of that holds of it (a member of `Node`). As `find`, for the shortest ways.
    template <bool (Node::*holds)() const>
    const Node* find_if(Handle handle) const {
        // In a register: compilers take a handle that is handed over apart in memory.
        const auto bits = std::bit_cast<std::uint64_t>(handle);
        static_assert(offsetof(Handle, index) == 0 && offsetof(Handle, generation) == 4);
        const auto index = static_cast<std::uint32_t>(bits);
        if (index >= end()) return nullptr;
        const Node* const node = nodes_.data() + index;
        const bool same = node->generation == static_cast<std::uint32_t>(bits >> 32);
        return same && (node->*holds)() ? node : nullptr;
    }
    Node& operator[](std::uint32_t index) { return nodes_[index]; }
    const Node& operator[](std::uint32_t index) const { return nodes_[index]; }
    Handle handle(std::uint32_t index) const {
        return index == 0 ? Handle{} : Handle{index, nodes_[index].generation};
    }
    Position position(std::uint32_t index) const {
        const Node& node = nodes_[index];
        const bool first = node.parent == 0 || nodes_[node.parent].first_child == index;
        return {handle(node.parent), handle(first ? 0 : node.previous), node.name, node.named != 0};
    }
    std::size_t alive() const { return alive_; }
    std::uint32_t end() const { return count_; }

    std::uint32_t allocate();
    /// `keep`: the slot stays free for the same instance to come back (`revive`) until `free_kept`.
    void release(std::uint32_t index, bool keep = false);
    /// The slot, with that generation: for an instance that comes back.
    void revive(Handle handle);
    void free_kept(Handle handle);
    /// Whether a dead instance could come back.
    bool keeps(Handle handle) const;

    // Snapshots (nodes_image.cpp). Generations are not part of them: what was given since stays
    // given, so that nobody's handle ever means somebody else.
    void save(ByteWriter& to) const;
    /// Reads and checks; `classes` tells what class a number in the bytes means here.
    static Nodes load(ByteReader& from, const std::vector<std::uint16_t>& classes);
    /// Takes the place of what is there.
    void replace(Nodes&& other);
    bool keeps_any() const {
        return std::any_of(nodes_.begin(), nodes_.end(), [](const Node& n) { return n.kept != 0; });
    }
    /// Gives back the slots that are kept and for which `claimed(index)` is false.
    template <class Claimed>
    void free_kept_but(Claimed claimed) {
        for (std::uint32_t i = 1; i < end(); ++i)
            if (nodes_[i].kept && !claimed(i)) free_kept({i, nodes_[i].generation - 1});
    }

    /// Appends to the children of `parent`. The name must be free.
    void link(std::uint32_t index, std::uint32_t parent, NodeName name);
    void unlink(std::uint32_t index);
    /// Puts a child behind its sibling `before`; 0: first.
    void reorder(std::uint32_t index, std::uint32_t before);
    std::uint32_t child(std::uint32_t parent, NodeName name) const;
    /// How many hang directly below. Counted when it is first asked for, and kept from then on.
    std::uint32_t child_count(std::uint32_t parent) const;
    /// The `n`th of them from 1; 0 when there is none. Going through all of them by number takes as
    /// many steps as there are.
    std::uint32_t nth_child(std::uint32_t parent, std::uint64_t n) const;
    /// Levels above an instance, its own counted; and levels below it, its own counted.
    std::size_t depth(std::uint32_t index) const;
    std::size_t height(std::uint32_t index) const;
    /// Whatever is done level by level (a path, a copy, a file) need not fear deeper trees.
    static constexpr std::size_t deepest = 1000;
    /// `stem_1`, `stem_2` ...: never one used before under this parent, and none of which
    /// `taken(name)` is true; that of every child is.
    template <class Taken>
    NodeName free_name(std::uint32_t parent, std::string_view stem, Taken taken) {
        NodeName name{Symbol(stem), 1};
        const bool counted =
            nodes_[parent].counts_children && counters_.contains(counter_key(parent, name.base));
        if (!counted && !taken(name)) return name;
        std::uint32_t& last = counter(parent, name.base);
        name.number = last;
        do ++name.number;
        while (taken(name));
        last = name.number;
        return name;
    }

    /// The last number that `free_name` has given; 0: none that must be kept.
    std::uint32_t last_number(std::uint32_t parent, Symbol stem) const {
        if (!nodes_[parent].counts_children) return 0;
        const auto found = counters_.find(counter_key(parent, stem));
        return found == counters_.end() ? 0 : found->second;
    }
    void set_last_number(std::uint32_t parent, Symbol stem, std::uint32_t last) {
        counter(parent, stem) = last;
    }

  private:
    // Open addressing over (parent, name); a slot holds a node index, 0 is empty. Deletion shifts
    // back, no tombstones.
    void detach_link(std::uint32_t index);
    std::size_t slot_of(std::uint32_t parent, NodeName name) const;
    void index_insert(std::uint32_t index);
    void index_erase(std::uint32_t index);

    static std::uint64_t counter_key(std::uint32_t parent, Symbol stem) {
        return std::uint64_t{parent} << 32 | stem.id();
    }
    std::uint32_t& counter(std::uint32_t parent, Symbol stem);
    std::uint32_t next_generation(std::uint32_t index, std::uint32_t after);
    bool links_hold() const;
    void child_leaves(std::uint32_t index);
    bool index_names();

    std::vector<Node> nodes_;
    std::uint32_t count_ = 1;  // of slots: the vector's own size takes a division to find
    std::vector<std::uint32_t> free_;
    std::vector<std::uint32_t> index_;
    std::size_t indexed_ = 0;
    std::size_t alive_ = 0;
    // (parent, stem) -> last number given, where no more than `stem_1` was: where that one still
    // hangs there, nothing need be kept.
    std::map<std::uint64_t, std::uint32_t> counters_;
    // By slot: the last generation given in a future that a restored snapshot has left. Consulted
    // when the slot's present owner goes.
    std::unordered_map<std::uint32_t, std::uint32_t> issued_;
    // Of those parents whose children were counted.
    mutable std::unordered_map<std::uint32_t, std::uint32_t> child_counts_;
    // The child that was asked for last by its number.
    struct Numbered {
        std::uint32_t parent = 0, child = 0;
        std::uint64_t number = 0;
    };
    mutable Numbered numbered_;
};

}  // namespace fettle::property
