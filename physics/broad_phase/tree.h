#pragma once

#include <geometry/vector.h>

#include <cstdint>
#include <vector>

namespace fettle::physics::detail {

/// A dynamic tree of boxes: inserted by the surface-area heuristic, kept good by rotations on the
/// way up. Plain indices in one vector, so that a copy of it is a snapshot that behaves
/// identically.
class Tree {
  public:
    static constexpr int32_t none = -1;

    /// The leaf's index stays valid until `remove`.
    int32_t insert(const Box4& box, uint32_t item);
    void remove(int32_t leaf);
    /// Replaces the box of a leaf. The leaf keeps its index.
    void move(int32_t leaf, const Box4& box);

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

    /// Every parent contains its children and every link is mutual.
    bool is_consistent() const;
    /// Every index is in range and each node is reached once: safe to walk, whatever it came from.
    bool is_walkable(uint32_t items) const;
    bool is_leaf(int32_t node) const {
        return node >= 0 && size_t(node) < nodes_.size() && nodes_[size_t(node)].is_leaf();
    }

    /// For saving and restoring.
    template <class Io, class Self>
    static void members(Io& io, Self& self) {
        io(self.nodes_), io(self.root_), io(self.free_), io(self.leaves_);
    }
    int height() const { return root_ == none ? 0 : height_of(root_); }

  private:
    struct Node {
        Box4 box;
        int32_t parent = none;
        int32_t left = none;  // none in a leaf
        int32_t right = none;
        uint32_t item = 0;  // of a leaf; next free node in the free list

        bool is_leaf() const { return left == none; }
    };
    static_assert(sizeof(Node) == 32);

    /// Indices still to visit. Trees are shallow; one made by hostile coordinates may not be.
    class Stack {
      public:
        bool empty() const { return count_ == 0; }
        void push(int32_t node) {
            if (count_ < inline_size)
                near_[count_] = node;
            else
                far_.push_back(node);
            ++count_;
        }
        int32_t pop() {
            if (--count_ < inline_size) return near_[count_];
            const int32_t node = far_.back();
            far_.pop_back();
            return node;
        }

      private:
        static constexpr uint32_t inline_size = 96;
        int32_t near_[inline_size];
        uint32_t count_ = 0;
        std::vector<int32_t> far_;
    };

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
};

template <typename Visit>
void Tree::query(const Box4& box, Visit&& visit) const {
    if (root_ == none) return;
    Stack stack;
    stack.push(root_);
    while (!stack.empty()) {
        const Node& node = nodes_[size_t(stack.pop())];
        if (!overlap(node.box, box)) continue;
        if (node.is_leaf()) {
            visit(node.item);
        } else {
            stack.push(node.right);
            stack.push(node.left);
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
    Stack stack;
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
            const float nearer = visit(node.item, far);
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
