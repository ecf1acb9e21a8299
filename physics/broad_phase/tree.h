#pragma once

#include <broad_phase/bucket.h>
#include <geometry/vector.h>

#include <bit>

#include <cstdint>
#include <vector>

namespace fettle::physics::detail {

/// A dynamic tree of boxes. What is new is inserted by the surface-area heuristic; what moves only
/// enlarges the boxes above it, and once a step the parts that moved are built anew from the top
/// (`settle`), which costs less than to take leaves out and put them in again one by one. Pairs are
/// found by one walk of the tree against itself, below which nothing is visited that did not move
/// and in which up to sixteen leaves that were built anew are one bucket.
/// Plain indices in one vector, so that a copy of it is a snapshot that behaves identically.
class Tree {
  public:
    static constexpr int32_t none = -1;

    /// The leaf's index stays valid until `remove`.
    int32_t insert(const Box4& box, uint32_t item);
    void remove(int32_t leaf);
    /// Replaces the box of a leaf, which has moved then. The leaf keeps its index.
    void move(int32_t leaf, const Box4& box);
    /// The same for many leaves: before anything else, call `settle`.
    void relocate(int32_t leaf, const Box4& box);
    /// Counts the leaf as moved where it is.
    void touch(int32_t leaf);

    /// Builds the parts that have moved anew, if some were relocated, inserted or removed since it
    /// last did. Leaves keep their indices.
    void settle();
    /// Calls `visit(item, item)` for every two leaves that overlap and of which one has moved.
    template <typename Visit>
    void pairs(FindOverlaps overlaps, Visit&& visit) const;
    /// The same for a leaf of this tree and one of another.
    template <typename Visit>
    void pairs(const Tree& other, FindOverlaps overlaps, Visit&& visit) const;
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
        io(self.settled_);
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
    struct NodePair {
        int32_t a, b;
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
    template <typename Visit>
    static void cross_pairs(const Tree& left, const Tree& right, Stack<NodePair>& open,
                            FindOverlaps overlaps, Visit&& visit);
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

/// `open` holds pairs of subtrees that overlap and of which one has moved.
template <typename Visit>
void Tree::cross_pairs(const Tree& left, const Tree& right, Stack<NodePair>& open,
                       FindOverlaps overlaps, Visit&& visit) {
    const auto push = [&](int32_t a, int32_t b) {
        const Node &u = left.nodes_[size_t(a)], &v = right.nodes_[size_t(b)];
        if ((left.has_moved(u) || right.has_moved(v)) && overlap(u.box, v.box)) open.push({a, b});
    };
    while (!open.empty()) {
        const auto [a, b] = open.pop();
        const Node &u = left.nodes_[size_t(a)], &v = right.nodes_[size_t(b)];
        const BoxBucket *bucket_a = left.bucket(a), *bucket_b = right.bucket(b);
        if (u.is_leaf() && v.is_leaf()) {
            visit(u.item(), v.item());
        } else if (bucket_a != nullptr && bucket_b != nullptr) {
            bucket_pairs(*bucket_a, *bucket_b, overlaps, visit);
        } else if (v.is_leaf() || bucket_b != nullptr ||
                   (!u.is_leaf() && bucket_a == nullptr && perimeter(u.box) >= perimeter(v.box))) {
            if (u.is_leaf()) {  // against a bucket
                push(a, v.left);
                push(a, v.right);
                continue;
            }
            push(u.left, b);
            push(u.right, b);
        } else {
            push(a, v.left);
            push(a, v.right);
        }
    }
}

template <typename Visit>
void Tree::pairs(FindOverlaps overlaps, Visit&& visit) const {
    if (root_ == none) return;
    Stack<int32_t> inner;
    Stack<NodePair> open;
    inner.push(root_);
    while (!inner.empty()) {
        const int32_t index = inner.pop();
        const Node& node = nodes_[size_t(index)];
        if (node.is_leaf() || !has_moved(node)) continue;
        if (const BoxBucket* own = bucket(index)) {
            bucket_pairs(*own, *own, overlaps, visit);
            continue;
        }
        inner.push(node.left);
        inner.push(node.right);
        const Node &left = nodes_[size_t(node.left)], &right = nodes_[size_t(node.right)];
        if (!(has_moved(left) || has_moved(right)) || !overlap(left.box, right.box)) continue;
        open.push({node.left, node.right});
        cross_pairs(*this, *this, open, overlaps, visit);
    }
}

template <typename Visit>
void Tree::pairs(const Tree& other, FindOverlaps overlaps, Visit&& visit) const {
    if (root_ == none || other.root_ == none) return;
    const Node &mine = nodes_[size_t(root_)], &theirs = other.nodes_[size_t(other.root_)];
    if (!(has_moved(mine) || other.has_moved(theirs)) || !overlap(mine.box, theirs.box)) return;
    Stack<NodePair> open;
    open.push({root_, other.root_});
    cross_pairs(*this, other, open, overlaps, visit);
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
