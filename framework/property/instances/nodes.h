#pragma once
// Nodes: names and parent-child links of all instances. A node takes 40 bytes, and 6 to 12 bytes in
// the table of names, because a game may have a hundred thousand instances.

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

/// A name in two parts, so that a hundred thousand generated names ("body_4711") need one symbol.
struct NodeName {
    Symbol base;
    std::uint32_t number = 0;  // 0: none

    static NodeName make(std::string_view text);
    /// Like `make`, but adds no symbol: an unknown name gives an empty base.
    static NodeName look_up(std::string_view text);
    std::string text() const;
    friend bool operator==(const NodeName&, const NodeName&) = default;
};

struct Node {
    std::uint32_t generation = 1;
    std::uint32_t parent = 0;
    std::uint32_t first_child = 0;
    std::uint32_t next = 0;
    std::uint32_t previous = 0;  // for the first child: the last sibling
    NodeName name;
    Row row = 0;
    std::uint32_t stored_row = 0;
    std::uint16_t class_id = 0;
    // Bit fields instead of bools, so that compilers can test several of them at once. A flag that
    // prevents a plain write does so when it is set, so one comparison with 0 tests all of them.
    std::uint8_t dead : 1 = 1;
    std::uint8_t watched : 1 = 0;     // the instance has watchers of its own
    std::uint8_t fresh : 1 = 0;       // made since the last barrier, not yet reported
    std::uint8_t has_ad_hoc : 1 = 0;  // avoids a look-up in `AdHoc`
    std::uint8_t has_formula : 1 = 0;
    std::uint8_t has_dependents : 1 = 0;  // a formula read something of this instance
    std::uint8_t named : 1 = 0;           // the user chose the name; a move keeps it
    std::uint8_t counts_children : 1 = 0;
    std::uint8_t kept : 1 = 0;           // deleted, with its slot reserved for undo
    std::uint8_t being_deleted : 1 = 0;  // it is being deleted

    bool alive() const { return !dead; }
    /// Values can be read directly from the memory of the properties.
    bool readable() const { return !dead && !has_formula; }
    /// Values can be written directly, because no watcher and no formula has to be notified.
    bool writable() const { return !dead && !watched && !has_formula && !has_dependents; }
};
static_assert(sizeof(Node) == 40);

/// Place of an instance in the tree. `before`: the sibling in front of it.
struct Position {
    Handle parent;
    Handle before;
    NodeName name;
    bool named = false;
};

/// The table of nodes and their links. Index 0 is not an instance.
class Nodes {
  public:
    Nodes() : nodes_(1), index_(64, 0) {}

    Node* find(Handle handle) {
        if (handle.index >= end()) return nullptr;
        Node* const node = nodes_.data() + handle.index;
        return node->generation == handle.generation && node->alive() ? node : nullptr;
    }
    const Node* find(Handle handle) const { return const_cast<Nodes*>(this)->find(handle); }
    /// Like `find`, but also tests a member function of `Node`. For the shortest paths.
    template <bool (Node::*holds)() const>
    const Node* find_if(Handle handle) const {
        // In a register: without this, compilers pass the two halves of the handle through memory.
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
    /// `keep`: the slot stays reserved for the same instance (`revive`) until `free_kept`.
    void release(std::uint32_t index, bool keep = false);
    /// Takes the slot and generation of an instance that comes back.
    void revive(Handle handle);
    void free_kept(Handle handle);
    /// Whether the slot is still reserved for this deleted instance.
    bool keeps(Handle handle) const;

    // Snapshots (nodes_image.cpp). Generations that were given since the snapshot stay given, so
    // that no handle ever means another instance.
    void save(ByteWriter& to) const;
    /// Reads and checks the bytes; `classes` maps class numbers of the bytes to those of this
    /// process.
    static Nodes load(ByteReader& from, const std::vector<std::uint16_t>& classes);
    /// Replaces the table.
    void replace(Nodes&& other);
    bool keeps_any() const {
        return std::any_of(nodes_.begin(), nodes_.end(), [](const Node& n) { return n.kept != 0; });
    }
    /// Frees the reserved slots for which `claimed(index)` is false.
    template <class Claimed>
    void free_kept_but(Claimed claimed) {
        for (std::uint32_t i = 1; i < end(); ++i)
            if (nodes_[i].kept && !claimed(i)) free_kept({i, nodes_[i].generation - 1});
    }

    /// Appends the node to the children of `parent`. The name must be free.
    void link(std::uint32_t index, std::uint32_t parent, NodeName name);
    void unlink(std::uint32_t index);
    /// Puts a child after its sibling `before`; 0: at the front.
    void reorder(std::uint32_t index, std::uint32_t before);
    std::uint32_t child(std::uint32_t parent, NodeName name) const;
    /// Number of direct children. It is counted on the first call and cached.
    std::uint32_t child_count(std::uint32_t parent) const;
    /// The `n`th child, from 1; 0 if there is none. Reading all children in order of their numbers
    /// takes linear time.
    std::uint32_t nth_child(std::uint32_t parent, std::uint64_t n) const;
    /// Levels above an instance and levels below it; both include its own level.
    std::size_t depth(std::uint32_t index) const;
    std::size_t height(std::uint32_t index) const;
    /// Limit of the depth, so that recursive code (paths, copies, files) cannot overflow the stack.
    static constexpr std::size_t deepest = 1000;
    /// The next name of `stem_1`, `stem_2` ... that was never used under this parent and for which
    /// `taken(name)` is false. `taken` must be true for the name of every child.
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

    /// The last number that `free_name` gave; 0: none that must be kept.
    std::uint32_t last_number(std::uint32_t parent, Symbol stem) const {
        if (!nodes_[parent].counts_children) return 0;
        const auto found = counters_.find(counter_key(parent, stem));
        return found == counters_.end() ? 0 : found->second;
    }
    void set_last_number(std::uint32_t parent, Symbol stem, std::uint32_t last) {
        counter(parent, stem) = last;
    }

  private:
    void detach_link(std::uint32_t index);
    // `index_` is a hash table with open addressing. Key: (parent, name). Value: node index, 0 if
    // empty. Removal shifts entries back and leaves no tombstones.
    std::size_t slot_of(std::uint32_t parent, NodeName name) const;
    void index_insert(std::uint32_t index);
    void index_erase(std::uint32_t index);

    static std::uint64_t counter_key(std::uint32_t parent, Symbol stem) {
        return std::uint64_t{parent} << 32 | stem.id();
    }
    std::uint32_t& counter(std::uint32_t parent, Symbol stem);
    std::uint32_t next_generation(std::uint32_t index, std::uint32_t after);
    bool are_links_valid() const;
    void child_leaves(std::uint32_t index);
    bool index_names();

    std::vector<Node> nodes_;
    std::uint32_t count_ = 1;  // number of slots; the size of the vector would cost a division
    std::vector<std::uint32_t> free_;
    std::vector<std::uint32_t> index_;
    std::size_t indexed_ = 0;
    std::size_t alive_ = 0;
    // (parent, stem) -> last number given. There is no entry while only `stem_1` was given and
    // still exists.
    std::map<std::uint64_t, std::uint32_t> counters_;
    // Slot -> last generation given after a snapshot that was restored later. Needed when the
    // current instance of the slot is deleted.
    std::unordered_map<std::uint32_t, std::uint32_t> issued_;
    // Cached numbers of children, by parent.
    mutable std::unordered_map<std::uint32_t, std::uint32_t> child_counts_;
    // The child that was last found by its number.
    struct Numbered {
        std::uint32_t parent = 0, child = 0;
        std::uint64_t number = 0;
    };
    mutable Numbered numbered_;
};

}  // namespace fettle::property
