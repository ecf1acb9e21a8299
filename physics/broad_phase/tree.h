#pragma once

#include <broad_phase/bucket.h>
#include <geometry/growth.h>
#include <geometry/vector.h>

#include <bit>

#include <cstdint>
#include <vector>

namespace fettle::physics::detail {

/// A dynamic tree of boxes. What is new is inserted by the surface-area heuristic; what moves only
/// enlarges the boxes above it, and when enough have moved the parts they are in are built anew
/// from the top (`settle`), which costs less than to take leaves out and put them in again one by
/// one. Pairs are found by one walk of the tree against itself, below which nothing is visited that
/// did not move and in which up to sixteen leaves that were built anew are one bucket; or, of few
/// that moved, by looking around each.
/// Plain indices in one vector, so that a copy of it is a snapshot that behaves identically.
class Tree {
  public:
    static constexpr int32_t none = -1;

    /// The leaf's index stays valid until `remove`.
    int32_t insert(const Box4& box, uint32_t item);
    void remove(int32_t leaf);
    /// Replaces the box of a leaf, which has moved then. The leaf keeps its index.
    void move(int32_t leaf, const Box4& box);
    /// Whether so many had better be moved one by one than relocated.
    bool are_few(std::size_t leaves) const {
        return 8 * leaves <= leaves_ && 2 * (worn_ + leaves) <= leaves_;
    }
    /// The same for many leaves: before anything else, call `settle`.
    void relocate(int32_t leaf, const Box4& box);
    /// Counts the leaf as moved where it is.
    void touch(int32_t leaf);

    /// Builds the parts that have moved since they were built anew, if some were relocated,
    /// inserted or removed since it last did. Leaves keep their indices.
    void settle();

    /// A part of a walk: two nodes, or one of a tree against itself.
    struct NodePair {
        int32_t a, b;
    };
    /// Calls `visit(item, item)` for every two leaves, one of this tree and one of the other, or
    /// any two if that is this one too, that overlap and of which one has moved.
    template <typename Visit>
    void pairs(const Tree& other, FindOverlaps overlaps, Visit&& visit) const;
    /// Parts of that walk, about `enough` if there is so much to do, which can be made in any
    /// order.
    void begin_walk(const Tree& other, std::size_t enough, std::vector<NodePair>& parts) const;
    template <typename Visit>
    void pairs(const Tree& other, NodePair part, FindOverlaps overlaps, Visit&& visit) const;
    /// Calls `visit(item)` for the other leaves that overlap one that has moved. Asked for each
    /// that has, every pair is found once.
    template <typename Visit>
    void look_around(int32_t leaf, FindOverlaps overlaps, Visit&& visit) const;
    /// From here on nothing has moved.
    void rest();

    const Box4& box(int32_t node) const { return nodes_[size_t(node)].box; }
    uint32_t size() const { return leaves_; }

    /// Calls `visit(item)` for every leaf whose box overlaps, in an order fixed by the tree's
    /// history.
    template <typename Visit>
    void query(const Box4& box, Visit&& visit) const;

    /// Calls `visit(item, far)` for every leaf whose box meets the segment from + t·(to - from)
    /// with t <= far; `visit` returns the new `far`: smaller to clip, 0 to stop.
    template <typename Visit>
    void cast(V2 from, V2 to, Visit&& visit) const;

    /// Every parent contains its children, has moved if one of them has, and every link is mutual.
    bool is_consistent() const;
    /// Every index is in range and each node is reached once: safe to walk, whatever it came from.
    bool is_walkable(uint32_t items) const;
    bool is_leaf(int32_t node) const {
        return node >= 0 && size_t(node) < nodes_.size() && nodes_[size_t(node)].is_leaf();
    }

    /// For saving and restoring.
    template <class Io, class Self>
    static void members(Io& io, Self& self) {
        io(self.nodes_), io(self.root_), io(self.free_), io(self.leaves_), io(self.epoch_);
        io(self.settled_), io(self.built_), io(self.worn_);
    }
    /// What can be made anew.
    template <class Io, class Self>
    static void scratch(Io& io, Self& self) {
        io(self.bucket_of_), io(self.buckets_), io(self.parts_), io(self.vacant_);
    }
    int height() const { return root_ == none ? 0 : height_of(root_); }

  private:
    struct Node {
        Box4 box;
        int32_t parent = none;
        int32_t left = none;   // none in a leaf
        int32_t right = none;  // of a leaf: its item; of a free node: the next one
        uint32_t moved = 0;    // the epoch in which it, or something below it, moved last

        bool is_leaf() const { return left == none; }
        uint32_t item() const { return uint32_t(right); }
    };
    static_assert(sizeof(Node) == 32);

    /// A subtree that stays as it is while what is above it is built anew.
    struct Part {
        V2 middle;  // twice the center of its box
        int32_t node;
    };

    /// What is still to visit. Trees are shallow; one made by hostile coordinates may not be.
    template <typename Entry>
    class Stack {
      public:
        bool empty() const { return count_ == 0; }
        void push(Entry entry) {
            if (count_ < inline_size)
                near_[count_] = entry;
            else
                far_.push_back(entry);
            ++count_;
        }
        Entry pop() {
            if (--count_ < inline_size) return near_[count_];
            const Entry entry = far_.back();
            far_.pop_back();
            return entry;
        }

      private:
        static constexpr uint32_t inline_size = 96;
        Entry near_[inline_size];
        uint32_t count_ = 0;
        std::vector<Entry> far_;
    };

    bool has_moved(const Node& node) const { return node.moved == epoch_; }
    void flag(int32_t node);
    void take_apart();
    int32_t build(Part* begin, Part* end, bool in_bucket = false);
    static Part* split(Part* begin, Part* end);
    template <typename Push>
    void open(const Tree& other, NodePair pair, bool bucket_a, bool bucket_b, Push&& push) const;
    /// It may have.
    bool has_pairs(const Tree& other) const {
        if (root_ == none || other.root_ == none) return false;
        const Node &mine = nodes_[size_t(root_)], &theirs = other.nodes_[size_t(other.root_)];
        return (has_moved(mine) || other.has_moved(theirs)) && overlap(mine.box, theirs.box);
    }
    /// The bucket that a node is, or nothing.
    const BoxBucket* bucket(int32_t node) const {
        const size_t index = size_t(node);
        if (index >= bucket_of_.size() || bucket_of_[index] < 0) return nullptr;
        return &buckets_[size_t(bucket_of_[index])];
    }
    void make_bucket(int32_t node, const Part* begin, const Part* end);
    void unsettle() {
        settled_ = false;
        drop_buckets();
    }
    void drop_buckets();
    void update_bucket(int32_t leaf);
    int32_t allocate();
    void release(int32_t node);
    void link_leaf(int32_t leaf);
    void unlink_leaf(int32_t leaf);
    int32_t best_sibling(const Box4& box) const;
    void refit_upwards(int32_t node);
    void rotate(int32_t node);
    void exchange(int32_t child, int32_t grandchild);
    int height_of(int32_t node) const;

    std::vector<Node> nodes_;
    int32_t root_ = none;
    int32_t free_ = none;
    uint32_t leaves_ = 0;
    uint32_t epoch_ = 1;
    bool settled_ = true;  ///< nothing was relocated, inserted or removed since the last building
    uint32_t built_ = 0;   ///< the parts that moved in later epochs are due for the next building
    uint32_t worn_ = 0;    ///< how often a leaf moved since
    // Made by `settle`, dropped when the tree changes otherwise: without them, pairs are found one
    // by one.
    std::vector<int32_t> bucket_of_;  ///< by node; -1: none
    std::vector<BoxBucket> buckets_;
    // Of `settle`; kept for their capacity.
    std::vector<Part> parts_;
    std::vector<int32_t> vacant_;
    std::size_t next_vacant_ = 0;
};

template <typename Visit>
void Tree::query(const Box4& box, Visit&& visit) const {
    if (root_ == none) return;
    Stack<int32_t> stack;
    stack.push(root_);
    while (!stack.empty()) {
        const Node& node = nodes_[size_t(stack.pop())];
        if (!overlap(node.box, box)) continue;
        if (node.is_leaf()) {
            visit(node.item());
        } else {
            stack.push(node.right);
            stack.push(node.left);
        }
    }
}

/// Visits the pairs of two buckets, or of one with itself.
template <typename Visit>
void bucket_pairs(const BoxBucket& a, const BoxBucket& b, FindOverlaps overlaps, Visit&& visit) {
    uint32_t rows[BoxBucket::capacity];
    overlaps(a, b, rows);
    for (uint32_t i = 0; i < a.count; ++i) {
        uint32_t row = rows[i];
        if ((a.moved >> i & 1) == 0) row &= b.moved;
        if (&a == &b) row &= ~1u << i;  // each pair once
        for (; row != 0; row &= row - 1) visit(a.item[i], b.item[std::countr_zero(row)]);
    }
}

/// Pushes the pairs below a pair that is no two leaves and no two buckets.
template <typename Push>
void Tree::open(const Tree& other, NodePair pair, bool bucket_a, bool bucket_b, Push&& push) const {
    const auto [a, b] = pair;
    const auto push_pair = [&](int32_t c, int32_t d) {
        const Node &u = nodes_[size_t(c)], &v = other.nodes_[size_t(d)];
        if ((has_moved(u) || other.has_moved(v)) && overlap(u.box, v.box)) push(NodePair{c, d});
    };
    const Node &u = nodes_[size_t(a)], &v = other.nodes_[size_t(b)];
    if (this == &other && a == b) {
        if (has_moved(nodes_[size_t(u.left)])) push(NodePair{u.left, u.left});
        if (has_moved(nodes_[size_t(u.right)])) push(NodePair{u.right, u.right});
        push_pair(u.left, u.right);
    } else if (v.is_leaf() || (bucket_b && !u.is_leaf()) ||
               (!u.is_leaf() && !bucket_a && perimeter(u.box) >= perimeter(v.box))) {
        push_pair(u.left, b);
        push_pair(u.right, b);
    } else {
        push_pair(a, v.left);
        push_pair(a, v.right);
    }
}

template <typename Visit>
void Tree::pairs(const Tree& other, NodePair part, FindOverlaps overlaps, Visit&& visit) const {
    Stack<NodePair> stack;
    stack.push(part);
    while (!stack.empty()) {
        const NodePair pair = stack.pop();
        const Node &u = nodes_[size_t(pair.a)], &v = other.nodes_[size_t(pair.b)];
        const BoxBucket *mine = bucket(pair.a), *theirs = other.bucket(pair.b);
        if (mine != nullptr && theirs != nullptr) {
            bucket_pairs(*mine, *theirs, overlaps, visit);
        } else if (u.is_leaf() && v.is_leaf()) {
            if (&u != &v) visit(u.item(), v.item());
        } else {
            open(other, pair, mine != nullptr, theirs != nullptr,
                 [&](NodePair below) { stack.push(below); });
        }
    }
}

template <typename Visit>
void Tree::pairs(const Tree& other, FindOverlaps overlaps, Visit&& visit) const {
    if (has_pairs(other)) pairs(other, {root_, other.root_}, overlaps, visit);
}

template <typename Visit>
void Tree::look_around(int32_t leaf, FindOverlaps overlaps, Visit&& visit) const {
    const Node& own = nodes_[size_t(leaf)];
    BoxBucket alone;
    alone.set(0, own.box);
    alone.count = 1;
    Stack<int32_t> stack;
    stack.push(root_);
    while (!stack.empty()) {
        const int32_t index = stack.pop();
        const Node& node = nodes_[size_t(index)];
        if (!overlap(node.box, own.box)) continue;
        if (const BoxBucket* near = bucket(index)) {
            uint32_t row = 0;
            overlaps(alone, *near, &row);
            for (; row != 0; row &= row - 1) {
                const int i = std::countr_zero(row);
                const bool theirs = (near->moved >> i & 1) != 0 && near->item[i] < own.item();
                if (near->item[i] != own.item() && !theirs) visit(near->item[i]);
            }
        } else if (!node.is_leaf()) {
            stack.push(node.right);
            stack.push(node.left);
        } else if (node.item() > own.item() || (index != leaf && !has_moved(node))) {
            visit(node.item());
        }
    }
}

template <typename Visit>
void Tree::cast(V2 from, V2 to, Visit&& visit) const {
    if (root_ == none) return;
    const V2 d = to - from;
    const V2 across = normalized(V2{-d.y, d.x});
    const V2 abs_across = {std::fabs(across.x), std::fabs(across.y)};
    float far = 1.0f;
    auto swept = [&] {
        const V2 end = from + far * d;
        return Box4{{min(from.x, end.x), min(from.y, end.y)},
                    {max(from.x, end.x), max(from.y, end.y)}};
    };
    Box4 reach = swept();
    Stack<int32_t> stack;
    stack.push(root_);
    while (!stack.empty()) {
        const Node& node = nodes_[size_t(stack.pop())];
        if (!overlap(node.box, reach)) continue;
        // Separating axis across the ray: its distance from the box's center against the box's
        // projected half size.
        const V2 center = 0.5f * (node.box.low + node.box.high);
        const V2 half = 0.5f * (node.box.high - node.box.low);
        if (std::fabs(dot(across, from - center)) > dot(abs_across, half) * 1.00001f + 1e-6f)
            continue;
        if (node.is_leaf()) {
            const float nearer = visit(node.item(), far);
            if (nearer <= 0.0f) return;
            if (nearer < far) {
                far = nearer;
                reach = swept();
            }
        } else {
            stack.push(node.right);
            stack.push(node.left);
        }
    }
}

}  // namespace fettle::physics::detail
