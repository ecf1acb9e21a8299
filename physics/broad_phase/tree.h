#pragma once

#include <broad_phase/bucket.h>
#include <geometry/make_room.h>
#include <geometry/vector.h>
#include <threads/pool.h>

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace fettle::physics::detail {

/// A dynamic tree of boxes. New boxes are inserted by the surface-area heuristic. If few leaves
/// move, the boxes above them are enlarged. If many move, all boxes are computed again (`refit`),
/// and if they have become much larger than after the last build, the tree is built again from the
/// top. Several threads share both tasks; the tree does not depend on their number. Pairs are found
/// by one walk of the tree against itself, which skips nodes without a moved leaf and processes up
/// to sixteen leaves as one bucket. If few leaves have moved, a search around each is used instead.
/// The tree consists of plain indices in one vector, so a copy of it behaves identically.
class Tree {
  public:
    static constexpr int32_t none = -1;

    /// The leaf's index stays valid until `remove`.
    int32_t insert(const Box4& box, uint32_t item);
    void remove(int32_t leaf);
    /// Replaces the box of a leaf and marks it as moved. The leaf keeps its index.
    void move(int32_t leaf, const Box4& box) {
        place(leaf, box);
        enlarge_above(leaf);
    }
    /// The first half of `move`: before any other call, `enlarge_above` must be called for the
    /// leaf, or `refit`. Several threads may place different leaves at once.
    void place(int32_t leaf, const Box4& box) {
        nodes_[size_t(leaf)].box = box;
        nodes_[size_t(leaf)].moved = epoch_;
    }
    /// True if it is faster to call `enlarge_above` for each of this many placed leaves than to
    /// call `refit`.
    bool are_few(std::size_t leaves) const {
        return 16 * leaves <= leaves_ && 2 * (enlarged_ + leaves) <= leaves_;
    }
    /// Enlarges the boxes above a leaf that was placed.
    void enlarge_above(int32_t leaf);
    /// Computes all boxes from the leaves; builds the tree again if that saves time. `before`: see
    /// `rebuild`.
    void refit(ThreadPool* threads = nullptr, std::span<const Box4> before = {});
    /// Marks the leaf as moved and all of its pairs as unknown.
    void clear_pairs(int32_t leaf);

    /// If leaves were inserted or removed since the last call, builds the moved parts of the tree
    /// again. Leaves keep their indices. `before`: for each item, its box when `clear_moves` was
    /// called; no box if it had none or was touched since.
    void rebuild(ThreadPool* threads = nullptr, std::span<const Box4> before = {});

    /// A part of a walk: two nodes, or one node against itself.
    struct NodePair {
        int32_t a, b;
    };
    /// Calls `visit(item, item)` for every two overlapping leaves, one of this tree and one of the
    /// other (which may be this tree), if one of them has moved. Skips most of the pairs that
    /// overlapped at the last `clear_moves`.
    template <typename Visit>
    void pairs(const Tree& other, FindOverlaps overlaps, Visit&& visit) const;
    /// Appends parts of that walk, about `enough` of them if the walk is long enough; they can be
    /// processed in any order.
    void begin_walk(const Tree& other, std::size_t enough, std::vector<NodePair>& parts) const;
    template <typename Visit>
    void pairs(const Tree& other, NodePair part, FindOverlaps overlaps, Visit&& visit) const;
    /// Calls `visit(item)` for the other leaves that overlap a moved leaf and did not before;
    /// `before`: its box at the last `clear_moves`. Called for each moved leaf, it finds every pair
    /// once.
    template <typename Visit>
    void pairs_of_leaf(int32_t leaf, const Box4& before, FindOverlaps overlaps,
                       Visit&& visit) const;
    /// From now on no leaf counts as moved, and all pairs are known.
    void clear_moves();

    const Box4& box(int32_t node) const { return nodes_[size_t(node)].box; }
    uint32_t size() const { return leaves_; }

    /// Calls `visit(item)` for every leaf whose box overlaps, in an order fixed by the tree's
    /// history.
    template <typename Visit>
    void query(const Box4& box, Visit&& visit) const;
    /// True if the box of a leaf overlaps.
    bool meets(const Box4& box) const;

    /// Calls `visit(item, far)` for every leaf whose box meets the segment from + t·(to - from)
    /// with t <= far; `visit` returns the new `far`: smaller to clip, 0 to stop.
    template <typename Visit>
    void cast(const Position& from, const Position& to, Visit&& visit) const;

    /// True if every parent contains its children, has moved if one of them has, and every link is
    /// mutual.
    bool is_consistent() const;
    /// False if deserialized data are damaged. If true, every index is in range and each node is
    /// reached once.
    bool is_walkable(uint32_t items) const;
    bool is_leaf(int32_t node) const {
        return node >= 0 && size_t(node) < nodes_.size() && nodes_[size_t(node)].is_leaf();
    }
    /// The item of a leaf.
    uint32_t item(int32_t leaf) const { return nodes_[size_t(leaf)].item(); }

    /// For saving and restoring.
    static void members(auto& io, auto& self) {
        io(self.nodes_), io(self.root_), io(self.free_), io(self.leaves_), io(self.epoch_);
        io(self.built_perimeters_), io(self.built_since_change_), io(self.built_epoch_),
            io(self.enlarged_);
    }
    /// Scratch: data that can be built again.
    static void scratch(auto& io, auto& self) {
        io(self.bucket_of_), io(self.buckets_), io(self.bucket_places_);
        io(self.parts_), io(self.inner_), io(self.subtrees_), io(self.upper_nodes_),
            io(self.part_ranges_);
    }
    int height() const { return root_ == none ? 0 : height_of(root_); }

  private:
    struct Node {
        Box4 box;
        int32_t parent = none;
        int32_t left = none;   // none in a leaf
        int32_t right = none;  // in a leaf: its item; in a free node: the next free node
        uint32_t moved = 0;    // the last epoch in which it, or a node below it, moved

        bool is_leaf() const { return left == none; }
        uint32_t item() const { return uint32_t(right); }
    };
    static_assert(sizeof(Node) == 32);
    /// A walk opens a bucket whose perimeter is this many times that of the other node.
    static constexpr float sparse_bucket = 4.0f;

    /// A subtree that does not change while the nodes above it are built again: in most cases a
    /// leaf.
    struct Part {
        Vec2 middle;  // twice the center of its box
        int32_t node;
    };
    /// A subtree to be built from the `count` parts beginning at `part`. It needs one inner node
    /// less than parts. These nodes are consecutive in the list of inner nodes from `inner` on:
    /// first the top of the subtree, then the nodes of its left side, then those of its right side.
    /// So they are known before the subtree is built.
    struct PartRange {
        uint32_t part, count, inner;
        uint32_t left = 0;  // number of parts on the left
    };
    /// The work of one thread in building and fitting: one subtree, or several.
    struct Subtree {
        PartRange range;
        uint32_t buckets = 0, first_bucket = 0;
        float perimeters = 0.0f;
    };
    /// Position of a bucket in the tree.
    struct BucketPlace {
        int32_t node;
        uint32_t part, count;
    };

    /// Nodes that are still to be visited. Trees are shallow, but extreme coordinates may make a
    /// tree deep.
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
    void mark_moved(int32_t node);
    void list_moved_parts();
    void list();
    void list_subtrees(std::span<const uint32_t> first_part, std::span<const uint32_t> count);
    bool is_listed() const { return !subtrees_.empty() && parts_.size() == leaves_; }
    float build(ThreadPool* threads, std::span<const Box4> before);
    void divide(ThreadPool* threads);
    void split_range(PartRange& range);
    void build_below(PartRange range, Subtree& subtree, bool in_bucket);
    void add_bucket_place(const PartRange& range, Subtree& subtree);
    static Part* split(Part* begin, Part* end);
    struct Before;
    float fit(ThreadPool* threads, const Before& before);
    float fit_subtree(const Subtree& subtree, const Before& before);
    void fit_node(int32_t index);
    template <typename Push>
    void open(const Tree& other, NodePair pair, bool bucket_a, bool bucket_b, Push&& push) const;
    /// False if the two trees have no new pairs.
    bool has_pairs(const Tree& other) const {
        if (root_ == none || other.root_ == none) return false;
        const Node &mine = nodes_[size_t(root_)], &theirs = other.nodes_[size_t(other.root_)];
        return (has_moved(mine) || other.has_moved(theirs)) && overlap(mine.box, theirs.box);
    }
    /// The bucket of a node, or null.
    const BoxBucket* bucket(int32_t node) const {
        const size_t index = size_t(node);
        if (index >= bucket_of_.size() || bucket_of_[index] < 0) return nullptr;
        return &buckets_[size_t(bucket_of_[index])];
    }
    /// The boxes of the bucket that have moved, one bit each.
    uint32_t moved_in(const BoxBucket& bucket) const {
        return bucket.epoch == epoch_ ? bucket.moved : 0;
    }
    /// The boxes when all their pairs were known.
    const BucketBoxes& before(const BoxBucket& bucket) const {
        return bucket.epoch == epoch_ ? bucket.before : bucket.now;
    }
    void fill_bucket(const BucketPlace& place, BoxBucket& bucket, const Before& before) const;
    void begin_epoch(BoxBucket& bucket) const;
    void update_bucket(int32_t leaf, bool clear_pairs);
    template <typename Visit>
    void pairs_of_buckets(const BoxBucket& a, const Tree& other, const BoxBucket& b,
                          FindOverlaps overlaps, Visit&& visit) const;
    void leaves_changed() {
        built_since_change_ = false;
        if (!bucket_of_.empty()) discard_build();
    }
    void discard_build();
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
    float built_perimeters_ = 0.0f;   ///< sum of the buckets' perimeters; 0: parts were built since
    bool built_since_change_ = true;  ///< no leaf was inserted or removed since the last build
    uint32_t built_epoch_ = 0;        ///< the next build includes parts that moved after this epoch
    uint32_t enlarged_ = 0;  ///< how often the boxes above a leaf were enlarged since the last fit
    // Dropped if the tree changes other than by moving boxes. Without buckets, pairs are found one
    // by one.
    std::vector<int32_t> bucket_of_;  ///< by node; -1: none
    std::vector<BoxBucket> buckets_;
    std::vector<BucketPlace> bucket_places_;
    // Scratch of building, and lists of the nodes.
    std::vector<Part> parts_;
    std::vector<int32_t> inner_;  ///< from the top down, left before right
    std::vector<Subtree> subtrees_;
    std::vector<uint32_t> upper_nodes_;  ///< inner nodes above the subtrees, as indices in the list
    std::vector<PartRange> part_ranges_;  ///< used while they are divided
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

/// Visits the new pairs of two buckets, or of one bucket with itself.
template <typename Visit>
void Tree::pairs_of_buckets(const BoxBucket& a, const Tree& other, const BoxBucket& b,
                            FindOverlaps overlaps, Visit&& visit) const {
    uint32_t rows[BoxBucket::capacity], known[BoxBucket::capacity], any = 0;
    overlaps(a.now, a.count, b.now, rows);
    const uint32_t moved_a = moved_in(a), moved_b = other.moved_in(b);
    for (uint32_t i = 0; i < a.count; ++i) {
        if ((moved_a >> i & 1) == 0) rows[i] &= moved_b;
        if (&a == &b) rows[i] &= ~1u << i;  // each pair once
        any |= rows[i];
    }
    if (any == 0) return;
    overlaps(before(a), a.count, other.before(b), known);
    for (uint32_t i = 0; i < a.count; ++i) {
        for (uint32_t row = rows[i] & ~known[i]; row != 0; row &= row - 1)
            visit(a.item[i], b.item[std::countr_zero(row)]);
    }
}

/// Pushes the pairs below a pair that is neither two leaves nor two buckets: opens the larger node.
/// A bucket stays whole, since it is compared fastest as a whole, unless it is much larger than the
/// other node: then its leaves are far apart, and few of them are near that node.
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
        return;
    }
    const float size_a = perimeter(u.box), size_b = perimeter(v.box);
    const bool whole_a = bucket_a && (this == &other || size_a < sparse_bucket * size_b);
    if (v.is_leaf() || (bucket_b && !u.is_leaf()) ||
        (!u.is_leaf() && !whole_a && size_a >= size_b)) {
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
            pairs_of_buckets(*mine, other, *theirs, overlaps, visit);
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
void Tree::pairs_of_leaf(int32_t leaf, const Box4& before, FindOverlaps overlaps,
                         Visit&& visit) const {
    const Node& own = nodes_[size_t(leaf)];
    BucketBoxes alone, once;
    alone.set(0, own.box);
    once.set(0, before);
    Stack<int32_t> stack;
    stack.push(root_);
    while (!stack.empty()) {
        const int32_t index = stack.pop();
        const Node& node = nodes_[size_t(index)];
        if (!overlap(node.box, own.box)) continue;
        if (const BoxBucket* near = bucket(index)) {
            uint32_t row = 0, known = 0;
            overlaps(alone, 1, near->now, &row);
            overlaps(once, 1, this->before(*near), &known);
            const uint32_t moved = moved_in(*near);
            for (row &= ~known; row != 0; row &= row - 1) {
                const int i = std::countr_zero(row);
                const bool theirs = (moved >> i & 1) != 0 && near->item[i] < own.item();
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
void Tree::cast(const Position& start, const Position& to, Visit&& visit) const {
    if (root_ == none) return;
    const Vec2 from = Vec2(start), d = to - start;
    const float slack = 2.0f * max(rounding_of(start), rounding_of(to));
    const Vec2 across = normalized(Vec2{-d.y, d.x});
    const Vec2 abs_across = {std::fabs(across.x), std::fabs(across.y)};
    float far = 1.0f;
    auto swept = [&] {
        const Vec2 end = from + far * d;
        return grow(Box4{{min(from.x, end.x), min(from.y, end.y)},
                         {max(from.x, end.x), max(from.y, end.y)}},
                    slack);
    };
    Box4 reach = swept();
    Stack<int32_t> stack;
    stack.push(root_);
    while (!stack.empty()) {
        const Node& node = nodes_[size_t(stack.pop())];
        if (!overlap(node.box, reach)) continue;
        // Separating axis across the ray: its distance from the box's center against the box's
        // projected half size.
        const Vec2 center = 0.5f * (node.box.low + node.box.high);
        const Vec2 half = 0.5f * (node.box.high - node.box.low);
        const float near = dot(abs_across, half) * 1.00001f + (1e-6f + slack);
        if (std::fabs(dot(across, from - center)) > near) continue;
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
