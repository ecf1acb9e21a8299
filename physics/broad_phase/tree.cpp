#include <broad_phase/tree.h>

#include <algorithm>
#include <cstring>

namespace fettle::physics::detail {

int32_t Tree::allocate() {
    if (free_ != none) {
        const int32_t node = free_;
        free_ = nodes_[size_t(node)].right;
        nodes_[size_t(node)] = Node{};
        return node;
    }
    make_room(nodes_);
    nodes_.emplace_back();
    return int32_t(nodes_.size()) - 1;
}

void Tree::release(int32_t node) {
    nodes_[size_t(node)] = Node{};
    nodes_[size_t(node)].right = free_;
    free_ = node;
}

int32_t Tree::insert(const Box4& box, uint32_t item) {
    const int32_t leaf = allocate();
    nodes_[size_t(leaf)].box = box;
    nodes_[size_t(leaf)].right = int32_t(item);
    ++leaves_;
    leaves_changed();
    link_leaf(leaf);
    mark_moved(leaf);
    return leaf;
}

void Tree::remove(int32_t leaf) {
    leaves_changed();
    unlink_leaf(leaf);
    release(leaf);
    --leaves_;
}

void Tree::enlarge_above(int32_t leaf) {
    built_epoch_ = std::min(built_epoch_, epoch_ - 1);
    ++enlarged_;
    update_bucket(leaf, false);
    const Box4& box = nodes_[size_t(leaf)].box;
    for (int32_t i = nodes_[size_t(leaf)].parent; i != none; i = nodes_[size_t(i)].parent) {
        Node& node = nodes_[size_t(i)];
        if (has_moved(node) && contains(node.box, box)) break;
        node.box = unite(node.box, box);
        node.moved = epoch_;
    }
}

void Tree::clear_pairs(int32_t leaf) {
    mark_moved(leaf);
    update_bucket(leaf, true);
}

void Tree::clear_moves() {
    ++epoch_;
}

/// Marks a leaf and the nodes above it as moved.
void Tree::mark_moved(int32_t index) {
    built_epoch_ = std::min(built_epoch_, epoch_ - 1);
    for (nodes_[size_t(index)].moved = epoch_, index = nodes_[size_t(index)].parent;
         index != none && !has_moved(nodes_[size_t(index)]); index = nodes_[size_t(index)].parent)
        nodes_[size_t(index)].moved = epoch_;
}

/// Greedy descent by the surface-area heuristic: the cost of a place is the perimeter of the new
/// parent plus what every ancestor grows by (J. Goldsmith, J. Salmon, "Automatic Creation of Object
/// Hierarchies for Ray Tracing", 1987).
int32_t Tree::best_sibling(const Box4& box) const {
    const float own = perimeter(box);
    int32_t index = root_;
    float node_area = perimeter(nodes_[size_t(index)].box);
    float here = perimeter(unite(nodes_[size_t(index)].box, box));  // as sibling of `index`, with
                                                                    // the growth of the ancestors
    float growth = 0.0f;                                            // of the ancestors of `index`
    float best_cost = here;
    int32_t best = index;
    while (!nodes_[size_t(index)].is_leaf()) {
        growth += here - growth - node_area;  // `index` itself grows if the leaf is inserted below
                                              // it
        const int32_t children[2] = {nodes_[size_t(index)].left, nodes_[size_t(index)].right};
        float cost[2], bound[2], area[2];
        for (int k = 0; k < 2; ++k) {
            const Node& child = nodes_[size_t(children[k])];
            const float united = perimeter(unite(child.box, box));
            area[k] = perimeter(child.box);
            cost[k] = united + growth;
            if (cost[k] < best_cost) {
                best_cost = cost[k];
                best = children[k];
            }
            // No place below this child costs less than this.
            bound[k] = child.is_leaf() ? cost[k] : own + growth + (united - area[k]);
        }
        int k = bound[1] < bound[0] ? 1 : 0;
        if (nodes_[size_t(children[k])].is_leaf() && !nodes_[size_t(children[1 - k])].is_leaf())
            k = 1 - k;
        if (nodes_[size_t(children[k])].is_leaf() || bound[k] >= best_cost) break;
        index = children[k];
        node_area = area[k];
        here = cost[k];
    }
    return best;
}

void Tree::link_leaf(int32_t leaf) {
    if (root_ == none) {
        root_ = leaf;
        nodes_[size_t(leaf)].parent = none;
        return;
    }
    const int32_t sibling = best_sibling(nodes_[size_t(leaf)].box);
    const int32_t parent = allocate();
    const int32_t above = nodes_[size_t(sibling)].parent;
    Node& node = nodes_[size_t(parent)];
    node.parent = above;
    node.left = sibling;
    node.right = leaf;
    node.moved = nodes_[size_t(sibling)].moved;
    nodes_[size_t(sibling)].parent = parent;
    nodes_[size_t(leaf)].parent = parent;
    if (above == none) {
        root_ = parent;
    } else if (nodes_[size_t(above)].left == sibling) {
        nodes_[size_t(above)].left = parent;
    } else {
        nodes_[size_t(above)].right = parent;
    }
    refit_upwards(parent);
}

void Tree::unlink_leaf(int32_t leaf) {
    const int32_t parent = nodes_[size_t(leaf)].parent;
    if (parent == none) {
        root_ = none;
        return;
    }
    const int32_t above = nodes_[size_t(parent)].parent;
    const int32_t sibling = nodes_[size_t(parent)].left == leaf ? nodes_[size_t(parent)].right
                                                                : nodes_[size_t(parent)].left;
    nodes_[size_t(sibling)].parent = above;
    nodes_[size_t(leaf)].parent = none;
    release(parent);
    if (above == none) {
        root_ = sibling;
        return;
    }
    (nodes_[size_t(above)].left == parent ? nodes_[size_t(above)].left
                                          : nodes_[size_t(above)].right) = sibling;
    refit_upwards(above);
}

void Tree::refit_upwards(int32_t index) {
    while (index != none) {
        Node& node = nodes_[size_t(index)];
        node.box = unite(nodes_[size_t(node.left)].box, nodes_[size_t(node.right)].box);
        rotate(index);
        index = nodes_[size_t(index)].parent;
    }
}

/// Exchanges a child with a grandchild on the other side if that shrinks the box of the inner node
/// (D. Kopta et al., "Fast, Effective BVH Updates for Animated Scenes", 2012). The box of `index`
/// itself does not change.
void Tree::rotate(int32_t index) {
    const int32_t sides[2] = {nodes_[size_t(index)].left, nodes_[size_t(index)].right};
    float best_gain = 0.0f;
    int32_t best_child = none, best_grandchild = none;
    for (int k = 0; k < 2; ++k) {
        const Node& inner = nodes_[size_t(sides[k])];
        if (inner.is_leaf()) continue;
        const int32_t other = sides[1 - k];
        const Box4& moved = nodes_[size_t(other)].box;
        const float area = perimeter(inner.box);
        // `other` replaces one grandchild and is joined with the remaining one.
        const float gain_left = area - perimeter(unite(moved, nodes_[size_t(inner.right)].box));
        const float gain_right = area - perimeter(unite(moved, nodes_[size_t(inner.left)].box));
        if (gain_left > best_gain) {
            best_gain = gain_left;
            best_child = other;
            best_grandchild = inner.left;
        }
        if (gain_right > best_gain) {
            best_gain = gain_right;
            best_child = other;
            best_grandchild = inner.right;
        }
    }
    if (best_child != none) exchange(best_child, best_grandchild);
}

void Tree::exchange(int32_t child, int32_t grandchild) {
    const int32_t top = nodes_[size_t(child)].parent;
    const int32_t inner = nodes_[size_t(grandchild)].parent;
    (nodes_[size_t(top)].left == child ? nodes_[size_t(top)].left : nodes_[size_t(top)].right) =
        grandchild;
    (nodes_[size_t(inner)].left == grandchild ? nodes_[size_t(inner)].left
                                              : nodes_[size_t(inner)].right) = child;
    nodes_[size_t(grandchild)].parent = top;
    nodes_[size_t(child)].parent = inner;
    nodes_[size_t(inner)].moved =
        std::max(nodes_[size_t(inner)].moved, nodes_[size_t(child)].moved);
    nodes_[size_t(inner)].box = unite(nodes_[size_t(nodes_[size_t(inner)].left)].box,
                                      nodes_[size_t(nodes_[size_t(inner)].right)].box);
}

bool Tree::meets(const Box4& box) const {
    if (root_ == none || !overlap(nodes_[size_t(root_)].box, box)) return false;
    Stack<int32_t> waiting;
    waiting.push(root_);
    while (!waiting.empty()) {
        const Node& node = nodes_[size_t(waiting.pop())];
        if (node.is_leaf()) return true;
        for (const int32_t child : {node.left, node.right})
            if (overlap(nodes_[size_t(child)].box, box)) waiting.push(child);
    }
    return false;
}

void Tree::begin_walk(const Tree& other, size_t enough, std::vector<NodePair>& parts) const {
    if (!has_pairs(other)) return;
    const size_t begin = parts.size();
    parts.push_back({root_, other.root_});
    // The oldest part first, so level by level. A pair of leaves cannot be opened and stays in the
    // list.
    size_t next = begin, bottom = begin;
    for (; next < parts.size() && parts.size() - next + bottom - begin < enough; ++next) {
        const NodePair pair = parts[next];
        const bool bucket_a = bucket(pair.a) != nullptr, bucket_b = other.bucket(pair.b) != nullptr;
        const bool leaves = nodes_[size_t(pair.a)].is_leaf() && other.is_leaf(pair.b);
        if (leaves || (bucket_a && bucket_b)) {
            parts[bottom++] = pair;
            continue;
        }
        open(other, pair, bucket_a, bucket_b, [&](NodePair below) { parts.push_back(below); });
    }
    parts.erase(parts.begin() + std::ptrdiff_t(bottom), parts.begin() + std::ptrdiff_t(next));
}

int Tree::height_of(int32_t index) const {
    // Iterative, one level at a time: a degenerate tree must not overflow the call stack.
    std::vector<int32_t> level = {index}, next;
    int height = 0;
    for (; !level.empty(); ++height) {
        next.clear();
        for (int32_t i : level) {
            const Node& node = nodes_[size_t(i)];
            if (!node.is_leaf()) next.insert(next.end(), {node.left, node.right});
        }
        level.swap(next);
    }
    return height;
}

bool Tree::is_consistent() const {
    if (root_ == none) return leaves_ == 0;
    if (nodes_[size_t(root_)].parent != none) return false;
    uint32_t found = 0;
    std::vector<int32_t> open = {root_};
    while (!open.empty()) {
        const int32_t index = open.back();
        open.pop_back();
        const Node& node = nodes_[size_t(index)];
        if (node.is_leaf()) {
            ++found;
            continue;
        }
        for (int32_t child : {node.left, node.right}) {
            if (nodes_[size_t(child)].parent != index) return false;
            if (!contains(node.box, nodes_[size_t(child)].box)) return false;
            if (nodes_[size_t(child)].moved > node.moved) return false;
            open.push_back(child);
        }
    }
    return found == leaves_;
}

bool Tree::is_walkable(uint32_t items) const {
    unsigned char built_since_change = 0;
    std::memcpy(&built_since_change, &built_since_change_, sizeof built_since_change);
    if (built_since_change > 1) return false;  // not a valid bool
    const auto inside = [this](int32_t node) {
        return node == none || (node >= 0 && size_t(node) < nodes_.size());
    };
    if (!inside(root_) || !inside(free_)) return false;
    std::vector<char> seen(nodes_.size(), 0);
    std::vector<int32_t> open;
    if (root_ != none) open.push_back(root_);
    uint32_t found = 0;
    while (!open.empty()) {
        const int32_t index = open.back();
        open.pop_back();
        if (seen[size_t(index)]++ != 0) return false;
        const Node& node = nodes_[size_t(index)];
        if (!inside(node.parent) || (node.is_leaf() && node.item() >= items)) return false;
        found += node.is_leaf();
        if (node.is_leaf()) continue;
        for (const int32_t child : {node.left, node.right}) {
            if (child == none || !inside(child) || nodes_[size_t(child)].parent != index)
                return false;
            open.push_back(child);
        }
    }
    for (int32_t free = free_; free != none; free = nodes_[size_t(free)].right) {
        if (!inside(free) || seen[size_t(free)]++ != 0) return false;
    }
    return found == leaves_ && (root_ == none || nodes_[size_t(root_)].parent == none);
}

}  // namespace fettle::physics::detail
