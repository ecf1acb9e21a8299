// Nodes in snapshots. The table is stored as it is, so that new instances get the same slots as
// without the restore. Names are interned again if the process is another one.

#include <algorithm>
#include <bit>
#include <iterator>

#include "nodes.h"

namespace fettle::property {
namespace {

/// The number at the end of a name has at most nine digits. The last numbers in a snapshot must be
/// smaller than this, so that there is room for further names.
constexpr std::uint32_t max_number = 900'000'000;

/// The symbols that the nodes use. Symbols are numbers of one process, so their texts are stored
/// too.
class Names {
  public:
    void use(Symbol name) {
        if (!name) return;
        if (name.id() >= used_.size()) used_.resize(name.id() + 1, false);
        if (used_[name.id()]) return;
        used_[name.id()] = true;
        order_.push_back(name);
    }
    void save(ByteWriter& to) const {
        to.put(std::uint64_t{order_.size()});
        for (const Symbol name : order_) {
            to.put(name.id());
            to.put(name.text());
        }
    }

  private:
    std::vector<bool> used_;
    std::vector<Symbol> order_;
};

/// Maps the symbols of a snapshot to those of this process.
class NameMap {
  public:
    explicit NameMap(ByteReader& from) {
        for (std::size_t n = from.count(12); n > 0; --n) {
            const auto id = from.get<std::uint32_t>();
            const Symbol here(from.text());
            from.require(id != 0, "a name without a number");
            map_[id] = here;
        }
    }
    Symbol operator()(Symbol there, const ByteReader& from) const {
        if (!there) return there;
        const auto found = map_.find(there.id());
        from.require(found != map_.end(), "a name that is not in its list of names");
        return found->second;
    }

  private:
    std::unordered_map<std::uint32_t, Symbol> map_;
};

}  // namespace

void Nodes::save(ByteWriter& to) const {
    Names names;
    for (std::uint32_t i = 1; i < end(); ++i)
        if (nodes_[i].alive()) names.use(nodes_[i].name.base);
    for (const auto& [key, last] : counters_) {
        const auto stem = std::bit_cast<Symbol>(static_cast<std::uint32_t>(key));
        names.use(stem);
    }
    names.save(to);
    to.put(std::uint32_t{sizeof(Node)});
    to.put(std::uint64_t{end()});
    to.raw(nodes_.data(), end() * sizeof(Node));
    to.put(free_);
    to.put(std::uint64_t{counters_.size()});
    for (const auto& [key, last] : counters_) {
        to.put(key);
        to.put(last);
    }
}

Nodes Nodes::load(ByteReader& from, const std::vector<std::uint16_t>& classes) {
    const NameMap names(from);
    from.require(from.get<std::uint32_t>() == sizeof(Node), "it is of another version of Fettle");
    Nodes read;
    read.nodes_ = from.list<Node>();
    read.count_ = static_cast<std::uint32_t>(read.nodes_.size());
    read.free_ = from.list<std::uint32_t>();
    from.require(!read.nodes_.empty() && read.nodes_.size() < UINT32_MAX, "it has no instances");
    for (std::uint32_t i = 1; i < read.end(); ++i) {
        Node& node = read.nodes_[i];
        if (!node.alive()) continue;
        ++read.alive_;
        from.require(node.generation != 0 && !node.kept, "an instance that is dead");
        from.require(node.class_id < classes.size(), "an instance of no class");
        node.class_id = classes[node.class_id];
        node.name.base = names(node.name.base, from);
        from.require(
            !node.name.base.text().empty() && NodeName::look_up(node.name.text()) == node.name,
            "an invalid name");
    }
    std::vector<bool> free(read.end());
    for (const std::uint32_t index : read.free_) {
        from.require(index != 0 && index < read.end() && !read.nodes_[index].alive() &&
                         !read.nodes_[index].kept && read.nodes_[index].generation != 0 &&
                         !free[index],
                     "a slot that is in use, or listed twice, in the list of free slots");
        free[index] = true;
    }
    for (std::size_t n = from.count(12); n > 0; --n) {
        const auto key = from.get<std::uint64_t>();
        const auto stem = std::bit_cast<Symbol>(static_cast<std::uint32_t>(key));
        const auto last = from.get<std::uint32_t>();
        from.require(last < max_number, "a number that no name can have");
        read.counters_[key >> 32 << 32 | names(stem, from).id()] = last;
    }
    from.require(read.are_links_valid(), "parents and children do not agree");
    from.require(read.index_names(), "two children of one name");
    return read;
}

/// Whether every child is in the list of its parent exactly once and every parent exists.
bool Nodes::are_links_valid() const {
    const auto inside = [this](std::uint32_t index) {
        return index < end() && nodes_[index].alive();
    };
    std::size_t listed = 0, hanging = 0;
    for (std::uint32_t parent = 1; parent < end(); ++parent) {
        const Node& above = nodes_[parent];
        if (!above.alive()) continue;
        if (above.parent != 0) {
            ++hanging;
            if (!inside(above.parent) || above.parent == parent) return false;
        }
        std::uint32_t before = 0;
        for (std::uint32_t i = above.first_child; i != 0; i = nodes_[i].next) {
            if (!inside(i) || nodes_[i].parent != parent || ++listed > alive_) return false;
            if (before != 0 && nodes_[i].previous != before) return false;
            before = i;
        }
        if (before != 0 && nodes_[above.first_child].previous != before) return false;
    }
    if (listed != hanging) return false;
    // Every instance must be reachable from an instance without a parent, so there is no cycle. No
    // instance may be too deep.
    struct Reached {
        std::uint32_t index;
        std::size_t depth;
    };
    std::size_t reached = 0;
    std::vector<Reached> open;
    for (std::uint32_t i = 1; i < end(); ++i)
        if (nodes_[i].alive() && nodes_[i].parent == 0) open.push_back({i, 1});
    while (!open.empty()) {
        const auto [index, depth] = open.back();
        open.pop_back();
        ++reached;
        if (depth > deepest) return false;
        for (std::uint32_t i = nodes_[index].first_child; i != 0; i = nodes_[i].next)
            open.push_back({i, depth + 1});
    }
    return reached == alive_;
}

/// Fills the table of names. False if two siblings have the same name.
bool Nodes::index_names() {
    std::size_t size = 64;
    while (size * 2 < alive_ * 3 + 3) size *= 2;
    index_.assign(size, 0);
    indexed_ = 0;
    for (std::uint32_t i = 1; i < end(); ++i) {
        if (!nodes_[i].alive() || nodes_[i].parent == 0) continue;
        if (child(nodes_[i].parent, nodes_[i].name) != 0) return false;
        index_insert(i);
    }
    return true;
}

void Nodes::replace(Nodes&& other) {
    const std::uint32_t room = std::max(end(), other.end());
    const std::uint32_t count = end();
    const auto present = std::move(nodes_);
    auto issued = std::move(issued_);
    for (std::uint32_t i = 1; i < room; ++i) {
        // The last generation given to this slot, now or after a snapshot that was restored later.
        std::uint32_t last = 0;
        if (i < count)
            last = present[i].alive() ? present[i].generation : present[i].generation - 1;
        if (const auto found = issued.find(i); found != issued.end())
            last = std::max(last, found->second);
        if (i >= other.end()) {
            other.issued_[i] = last;
        } else if (Node& node = other.nodes_[i]; node.alive() || node.kept) {
            if (last >= node.generation) other.issued_[i] = last;
        } else {
            node.generation = std::max(node.generation, last + 1);
        }
    }
    // Slots beyond both tables may have been used after a snapshot that was restored earlier.
    for (const auto& [i, last] : issued)
        if (i >= room) other.issued_[i] = last;
    *this = std::move(other);
}

}  // namespace fettle::property
