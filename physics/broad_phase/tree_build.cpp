#include <broad_phase/tree.h>

#include <algorithm>

// Building a tree from the top, and computing its boxes from the leaves. Threads share both tasks;
// a unit of work is a bough. The division of the parts determines the nodes of each bough, and sums
// are added in the order of the boughs, so the tree does not depend on the number of threads.

namespace fettle::physics::detail {
namespace {

/// Limits for boughs: each is worth a task, and there are enough for all threads.
constexpr uint32_t least_bough = 128, most_boughs = 64;

uint32_t greatest_bough(std::size_t parts) {
    return std::max(least_bough, uint32_t(parts / most_boughs));
}

/// When the perimeters of the buckets have grown by this factor since they were built, they overlap
/// so many others that building them again costs less.
constexpr float greatest_wear = 1.1f;

}  // namespace

/// Boxes of the items at the last `rest`.
struct Tree::Before {
    std::span<const Box4> boxes;    ///< of each item
    bool still_in_buckets = false;  ///< the buckets still have the same leaves
};

void Tree::refit(ThreadPool* threads, std::span<const Box4> before) {
    built_ = std::min(built_, epoch_ - 1);
    enlarged_ = 0;
    if (root_ == none || nodes_[size_t(root_)].is_leaf()) return;
    const bool listed = is_listed();
    if (!listed) list();
    if (fit(threads, {before, listed}) <= greatest_wear * breadth_) return;
    share_out_range(threads, parts_.size(), 1024, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
            const Box4& box = nodes_[size_t(parts_[i].node)].box;
            parts_[i].middle = box.low + box.high;
        }
    });
    breadth_ = build(threads, before);
    settled_ = true;
    built_ = epoch_;
}

void Tree::settle(ThreadPool* threads, std::span<const Box4> before) {
    if (settled_) return;
    settled_ = true;
    if (root_ == none || nodes_[size_t(root_)].is_leaf() || nodes_[size_t(root_)].moved <= built_)
        return;
    if (4 * enlarged_ > leaves_)
        built_ = 0;  // include all parts, so that all leaves are in buckets again
    take_apart();
    const float breadth = build(threads, before);
    breadth_ = is_listed() ? breadth : 0.0f;
    built_ = epoch_;
    enlarged_ = 0;
}

void Tree::forget_build() {
    bucket_of_.clear();
    buckets_.clear();
    parts_.clear();
    boughs_.clear();
}

// --- The parts

/// Lists the subtrees that did not move (at least leaves), and the nodes above them, which are used
/// again. The order is top down and left before right, so that neighbors in the tree are neighbors
/// in memory.
void Tree::take_apart() {
    parts_.clear();
    inner_.clear();
    Stack<int32_t> open;
    open.push(root_);
    while (!open.empty()) {
        const int32_t index = open.pop();
        const Node& node = nodes_[size_t(index)];
        if (node.is_leaf() || node.moved <= built_) {
            parts_.push_back({node.box.low + node.box.high, index});
            continue;
        }
        inner_.push_back(index);
        open.push(node.right);
        open.push(node.left);
    }
}

/// Lists the whole tree in the order of a build.
void Tree::list() {
    parts_.clear();
    inner_.clear();
    std::vector<uint32_t> first_part, count;
    Stack<int32_t> open;
    open.push(root_);
    while (!open.empty()) {
        const int32_t index = open.pop();
        const Node& node = nodes_[size_t(index)];
        if (node.is_leaf()) {
            parts_.push_back({{}, index});
            continue;
        }
        inner_.push_back(index);
        first_part.push_back(uint32_t(parts_.size()));
        open.push(node.right);
        open.push(node.left);
    }
    // Backwards, because children come after their parent: the left side first, then the right
    // side.
    count.resize(inner_.size());
    for (size_t i = inner_.size(); i-- > 0;) {
        const Node& node = nodes_[size_t(inner_[i])];
        const uint32_t left = nodes_[size_t(node.left)].is_leaf() ? 1 : count[i + 1];
        count[i] = left + (nodes_[size_t(node.right)].is_leaf() ? 1 : count[i + left]);
    }
    list_boughs(first_part, count);
}

/// `first_part`, `count`: the parts of each inner node.
void Tree::list_boughs(std::span<const uint32_t> first_part, std::span<const uint32_t> count) {
    bucket_of_.assign(nodes_.size(), -1);
    buckets_.clear();
    boughs_.clear();
    stems_.clear();
    spots_.resize(parts_.size() / 2 + 1);
    const uint32_t greatest = greatest_bough(parts_.size());
    for (uint32_t i = 0; i < inner_.size();) {
        if (count[i] > greatest) {
            stems_.push_back(i++);
            continue;
        }
        Bough& bough = boughs_.emplace_back();
        bough.fork = {first_part[i], count[i], i};
        bough.first_bucket = uint32_t(buckets_.size());
        for (const uint32_t end = i + count[i] - 1; i < end;) {
            const bool is_bucket = count[i] <= BoxBucket::capacity;
            if (is_bucket) add_spot({first_part[i], count[i], i}, bough);
            i += is_bucket ? count[i] - 1 : 1;
        }
        buckets_.resize(buckets_.size() + bough.buckets);
    }
}

// --- Building

/// Builds the tree of the parts. Returns the sum of the perimeters of the buckets.
float Tree::build(ThreadPool* threads, std::span<const Box4> before) {
    bucket_of_.assign(nodes_.size(), -1);
    spots_.resize(parts_.size() / 2 + 1);
    root_ = parts_.size() == 1 ? parts_.front().node : inner_.front();
    nodes_[size_t(root_)].parent = none;
    divide(threads);
    share_out(threads, uint32_t(boughs_.size()),
              [&](uint32_t i) { build_below(boughs_[i].fork, boughs_[i], false); });
    uint32_t count = 0;
    for (Bough& bough : boughs_) {
        bough.first_bucket = count;
        count += bough.buckets;
    }
    buckets_.resize(count);
    return fit(threads, {before});
}

/// Divides the parts into boughs, one level at a time; threads share the work of a level.
void Tree::divide(ThreadPool* threads) {
    const uint32_t greatest = greatest_bough(parts_.size());
    boughs_.clear();
    stems_.clear();
    forks_.assign(1, {0, uint32_t(parts_.size()), 0});
    for (size_t begin = 0, end = 1; begin < end; begin = end, end = forks_.size()) {
        share_out(threads, uint32_t(end - begin), [&](uint32_t i) {
            Fork& fork = forks_[begin + i];
            if (fork.count > greatest) split_fork(fork);
        });
        for (size_t i = begin; i < end; ++i) {
            const Fork fork = forks_[i];
            if (fork.count <= greatest) {
                if (fork.count > 1) boughs_.push_back({fork});
                continue;
            }
            stems_.push_back(fork.inner);
            forks_.push_back({fork.part, fork.left, fork.inner + 1});
            forks_.push_back(
                {fork.part + fork.left, fork.count - fork.left, fork.inner + fork.left});
        }
    }
    std::sort(stems_.begin(), stems_.end());
    std::sort(boughs_.begin(), boughs_.end(),
              [](const Bough& a, const Bough& b) { return a.fork.inner < b.fork.inner; });
}

/// Divides its parts in two and links its node to the two sides.
void Tree::split_fork(Fork& fork) {
    Part* begin = parts_.data() + fork.part;
    fork.left = uint32_t(split(begin, begin + fork.count) - begin);
    const int32_t index = inner_[fork.inner];
    const int32_t left = fork.left == 1 ? begin->node : inner_[fork.inner + 1];
    const int32_t right =
        fork.count - fork.left == 1 ? begin[fork.left].node : inner_[fork.inner + fork.left];
    Node& node = nodes_[size_t(index)];
    node.left = left;
    node.right = right;
    nodes_[size_t(left)].parent = nodes_[size_t(right)].parent = index;
}

void Tree::build_below(Fork fork, Bough& bough, bool in_bucket) {
    if (fork.count == 1) return;
    if (!in_bucket && fork.count <= BoxBucket::capacity) {
        const Part* begin = parts_.data() + fork.part;
        in_bucket = std::all_of(begin, begin + fork.count, [this](const Part& part) {
            return nodes_[size_t(part.node)].is_leaf();
        });
        if (in_bucket) add_spot(fork, bough);
    }
    split_fork(fork);
    build_below({fork.part, fork.left, fork.inner + 1}, bough, in_bucket);
    build_below({fork.part + fork.left, fork.count - fork.left, fork.inner + fork.left}, bough,
                in_bucket);
}

/// A bucket has at least two leaves. So the buckets of a bough have room from half of the position
/// of its first leaf on.
void Tree::add_spot(const Fork& fork, Bough& bough) {
    spots_[bough.fork.part / 2 + bough.buckets++] = {inner_[fork.inner], fork.part, fork.count};
}

/// Splits in the middle of the longer side. If nearly all parts are on one side of it, splits into
/// halves by number, so that no coordinates make the tree deep.
Tree::Part* Tree::split(Part* begin, Part* end) {
    if (end - begin == 2) return begin + 1;
    V2 low = begin->middle, high = begin->middle;
    for (const Part* part = begin + 1; part != end; ++part) {
        low = {min(low.x, part->middle.x), min(low.y, part->middle.y)};
        high = {max(high.x, part->middle.x), max(high.y, part->middle.y)};
    }
    const bool along_x = high.x - low.x > high.y - low.y;
    const float border = along_x ? 0.5f * (low.x + high.x) : 0.5f * (low.y + high.y);
    const auto key = [along_x](const Part& part) {
        return along_x ? part.middle.x : part.middle.y;
    };
    Part* middle = std::partition(begin, end, [&](const Part& part) { return key(part) < border; });
    const std::ptrdiff_t least = 1 + (end - begin) / 16;
    if (middle - begin < least || end - middle < least) {
        middle = begin + (end - begin) / 2;
        std::nth_element(begin, middle, end,
                         [&](const Part& a, const Part& b) { return key(a) < key(b); });
    }
    return middle;
}

// --- Computing boxes

/// Computes all listed boxes, and fills the buckets. Returns the sum of the perimeters of the
/// buckets.
float Tree::fit(ThreadPool* threads, const Before& before) {
    share_out(threads, uint32_t(boughs_.size()),
              [&](uint32_t i) { boughs_[i].breadth = fit_bough(boughs_[i], before); });
    for (size_t i = stems_.size(); i-- > 0;) fit_node(inner_[stems_[i]]);
    float breadth = 0.0f;
    for (const Bough& bough : boughs_) breadth += bough.breadth;
    return breadth;
}

float Tree::fit_bough(const Bough& bough, const Before& before) {
    const uint32_t begin = bough.fork.inner;
    for (uint32_t i = begin + bough.fork.count - 1; i-- > begin;) fit_node(inner_[i]);
    float breadth = 0.0f;
    for (uint32_t i = 0; i < bough.buckets; ++i) {
        const Spot& spot = spots_[bough.fork.part / 2 + i];
        const uint32_t place = bough.first_bucket + i;
        bucket_of_[size_t(spot.node)] = int32_t(place);
        fill_bucket(spot, buckets_[place], before);
        breadth += perimeter(nodes_[size_t(spot.node)].box);
    }
    return breadth;
}

/// Computes the box of a node; the boxes below it must be computed already.
void Tree::fit_node(int32_t index) {
    Node& node = nodes_[size_t(index)];
    const Node &left = nodes_[size_t(node.left)], &right = nodes_[size_t(node.right)];
    node.box = unite(left.box, right.box);
    node.moved = std::max(left.moved, right.moved);
}

void Tree::fill_bucket(const Spot& spot, BoxBucket& bucket, const Before& before) const {
    begin_epoch(bucket);
    bucket.count = spot.count;
    bucket.moved = 0;
    for (uint32_t i = 0; i < spot.count; ++i) {
        const Node& leaf = nodes_[size_t(parts_[spot.part + i].node)];
        bucket.now.set(i, leaf.box);
        bucket.item[i] = leaf.item();
        bucket.moved |= uint32_t{has_moved(leaf)} << i;
    }
    if (before.still_in_buckets) return;
    for (uint32_t i = 0; i < spot.count; ++i) {
        const uint32_t item = bucket.item[i];
        bucket.before.set(i, item < before.boxes.size() ? before.boxes[item] : no_box);
    }
    for (uint32_t i = spot.count; i < BoxBucket::capacity; ++i) {
        bucket.now.set(i, no_box);
        bucket.before.set(i, no_box);
    }
}

/// Begins an epoch of the bucket, in which no box has moved yet.
void Tree::begin_epoch(BoxBucket& bucket) const {
    if (bucket.epoch == epoch_) return;
    bucket.before = bucket.now;
    bucket.moved = 0;
    bucket.epoch = epoch_;
}

/// Updates the bucket of a leaf that has moved since the bucket was filled.
void Tree::update_bucket(int32_t leaf, bool forget_pairs) {
    for (int32_t i = leaf; i != none && !bucket_of_.empty(); i = nodes_[size_t(i)].parent) {
        const int32_t place = bucket_of_[size_t(i)];
        if (place < 0) continue;
        BoxBucket& bucket = buckets_[size_t(place)];
        begin_epoch(bucket);
        const Node& node = nodes_[size_t(leaf)];
        const uint32_t *first = bucket.item, *last = first + bucket.count;
        const auto slot = uint32_t(std::find(first, last, node.item()) - first);
        bucket.now.set(slot, node.box);
        if (forget_pairs) bucket.before.set(slot, no_box);
        bucket.moved |= uint32_t{1} << slot;
        return;
    }
}

}  // namespace fettle::physics::detail
