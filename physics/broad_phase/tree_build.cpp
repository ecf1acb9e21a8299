#include <broad_phase/tree.h>

#include <algorithm>

// Building a tree from the top, and computing its boxes from the leaves. Threads share both tasks;
// a unit of work is a subtree. The division of the parts determines the nodes of each subtree, and
// sums are added in the order of the subtrees, so the tree does not depend on the number of
// threads.

namespace fettle::physics::detail {
namespace {

/// Limits for subtrees: each is large enough for a task, and there are enough for all threads.
constexpr uint32_t min_subtree = 128, max_subtrees = 64;

uint32_t subtree_size(std::size_t parts) {
    return std::max(min_subtree, uint32_t(parts / max_subtrees));
}

/// When the perimeters of the buckets have grown by this factor since they were built, building
/// them again costs less than the additional overlaps.
constexpr float max_growth = 1.1f;

}  // namespace

/// Boxes of the items at the last `clear_moves`.
struct Tree::Before {
    std::span<const Box4> boxes;    ///< of each item
    bool still_in_buckets = false;  ///< the buckets still have the same leaves
};

void Tree::refit(ThreadPool* threads, std::span<const Box4> before) {
    built_epoch_ = std::min(built_epoch_, epoch_ - 1);
    enlarged_ = 0;
    if (root_ == none || nodes_[size_t(root_)].is_leaf()) return;
    const bool listed = is_listed();
    if (!listed) list();
    if (fit(threads, {before, listed}) <= max_growth * built_perimeters_) return;
    parallel_for(threads, parts_.size(), 1024, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
            const Box4& box = nodes_[size_t(parts_[i].node)].box;
            parts_[i].middle = box.low + box.high;
        }
    });
    built_perimeters_ = build(threads, before);
    built_since_change_ = true;
    built_epoch_ = epoch_;
}

void Tree::rebuild(ThreadPool* threads, std::span<const Box4> before) {
    if (built_since_change_) return;
    built_since_change_ = true;
    if (root_ == none || nodes_[size_t(root_)].is_leaf() ||
        nodes_[size_t(root_)].moved <= built_epoch_)
        return;
    if (4 * enlarged_ > leaves_)
        built_epoch_ = 0;  // include all parts, so that all leaves are in buckets again
    list_moved_parts();
    const float perimeters = build(threads, before);
    built_perimeters_ = is_listed() ? perimeters : 0.0f;
    built_epoch_ = epoch_;
    enlarged_ = 0;
}

void Tree::discard_build() {
    bucket_of_.clear();
    buckets_.clear();
    parts_.clear();
    subtrees_.clear();
}

// --- The parts

/// Lists the subtrees that did not move (at least leaves), and the nodes above them, which are used
/// again. The order is top down and left before right, so that neighbors in the tree are neighbors
/// in memory.
void Tree::list_moved_parts() {
    parts_.clear();
    inner_.clear();
    Stack<int32_t> open;
    open.push(root_);
    while (!open.empty()) {
        const int32_t index = open.pop();
        const Node& node = nodes_[size_t(index)];
        if (node.is_leaf() || node.moved <= built_epoch_) {
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
    list_subtrees(first_part, count);
}

/// `first_part`, `count`: the parts of each inner node.
void Tree::list_subtrees(std::span<const uint32_t> first_part, std::span<const uint32_t> count) {
    bucket_of_.assign(nodes_.size(), -1);
    buckets_.clear();
    subtrees_.clear();
    upper_nodes_.clear();
    bucket_places_.resize(parts_.size() / 2 + 1);
    const uint32_t greatest = subtree_size(parts_.size());
    for (uint32_t i = 0; i < inner_.size();) {
        if (count[i] > greatest) {
            upper_nodes_.push_back(i++);
            continue;
        }
        Subtree& subtree = subtrees_.emplace_back();
        subtree.range = {first_part[i], count[i], i};
        subtree.first_bucket = uint32_t(buckets_.size());
        for (const uint32_t end = i + count[i] - 1; i < end;) {
            const bool is_bucket = count[i] <= BoxBucket::capacity;
            if (is_bucket) add_bucket_place({first_part[i], count[i], i}, subtree);
            i += is_bucket ? count[i] - 1 : 1;
        }
        buckets_.resize(buckets_.size() + subtree.buckets);
    }
}

// --- Building

/// Builds the tree of the parts. Returns the sum of the perimeters of the buckets.
float Tree::build(ThreadPool* threads, std::span<const Box4> before) {
    bucket_of_.assign(nodes_.size(), -1);
    bucket_places_.resize(parts_.size() / 2 + 1);
    root_ = parts_.size() == 1 ? parts_.front().node : inner_.front();
    nodes_[size_t(root_)].parent = none;
    divide(threads);
    parallel_for(threads, uint32_t(subtrees_.size()),
                 [&](uint32_t i) { build_below(subtrees_[i].range, subtrees_[i], false); });
    uint32_t count = 0;
    for (Subtree& subtree : subtrees_) {
        subtree.first_bucket = count;
        count += subtree.buckets;
    }
    buckets_.resize(count);
    return fit(threads, {before});
}

/// Divides the parts into subtrees, one level at a time; threads share the work of a level.
void Tree::divide(ThreadPool* threads) {
    const uint32_t greatest = subtree_size(parts_.size());
    subtrees_.clear();
    upper_nodes_.clear();
    part_ranges_.assign(1, {0, uint32_t(parts_.size()), 0});
    for (size_t begin = 0, end = 1; begin < end; begin = end, end = part_ranges_.size()) {
        parallel_for(threads, uint32_t(end - begin), [&](uint32_t i) {
            PartRange& range = part_ranges_[begin + i];
            if (range.count > greatest) split_range(range);
        });
        for (size_t i = begin; i < end; ++i) {
            const PartRange range = part_ranges_[i];
            if (range.count <= greatest) {
                if (range.count > 1) subtrees_.push_back({range});
                continue;
            }
            upper_nodes_.push_back(range.inner);
            part_ranges_.push_back({range.part, range.left, range.inner + 1});
            part_ranges_.push_back(
                {range.part + range.left, range.count - range.left, range.inner + range.left});
        }
    }
    std::sort(upper_nodes_.begin(), upper_nodes_.end());
    std::sort(subtrees_.begin(), subtrees_.end(),
              [](const Subtree& a, const Subtree& b) { return a.range.inner < b.range.inner; });
}

/// Divides its parts in two and links its node to the two sides.
void Tree::split_range(PartRange& range) {
    Part* begin = parts_.data() + range.part;
    range.left = uint32_t(split(begin, begin + range.count) - begin);
    const int32_t index = inner_[range.inner];
    const int32_t left = range.left == 1 ? begin->node : inner_[range.inner + 1];
    const int32_t right =
        range.count - range.left == 1 ? begin[range.left].node : inner_[range.inner + range.left];
    Node& node = nodes_[size_t(index)];
    node.left = left;
    node.right = right;
    nodes_[size_t(left)].parent = nodes_[size_t(right)].parent = index;
}

void Tree::build_below(PartRange range, Subtree& subtree, bool in_bucket) {
    if (range.count == 1) return;
    if (!in_bucket && range.count <= BoxBucket::capacity) {
        const Part* begin = parts_.data() + range.part;
        in_bucket = std::all_of(begin, begin + range.count, [this](const Part& part) {
            return nodes_[size_t(part.node)].is_leaf();
        });
        if (in_bucket) add_bucket_place(range, subtree);
    }
    split_range(range);
    build_below({range.part, range.left, range.inner + 1}, subtree, in_bucket);
    build_below({range.part + range.left, range.count - range.left, range.inner + range.left},
                subtree, in_bucket);
}

/// A bucket has at least two leaves. So the buckets of a subtree have room from half of the
/// position of its first leaf on.
void Tree::add_bucket_place(const PartRange& range, Subtree& subtree) {
    bucket_places_[subtree.range.part / 2 + subtree.buckets++] = {inner_[range.inner], range.part,
                                                                  range.count};
}

/// Splits in the middle of the longer side. If nearly all parts are on one side of it, splits into
/// halves by number, so that no coordinates make the tree deep.
Tree::Part* Tree::split(Part* begin, Part* end) {
    if (end - begin == 2) return begin + 1;
    Vec2 low = begin->middle, high = begin->middle;
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
    parallel_for(threads, uint32_t(subtrees_.size()),
                 [&](uint32_t i) { subtrees_[i].perimeters = fit_subtree(subtrees_[i], before); });
    for (size_t i = upper_nodes_.size(); i-- > 0;) fit_node(inner_[upper_nodes_[i]]);
    float perimeters = 0.0f;
    for (const Subtree& subtree : subtrees_) perimeters += subtree.perimeters;
    return perimeters;
}

float Tree::fit_subtree(const Subtree& subtree, const Before& before) {
    const uint32_t begin = subtree.range.inner;
    for (uint32_t i = begin + subtree.range.count - 1; i-- > begin;) fit_node(inner_[i]);
    float perimeters = 0.0f;
    for (uint32_t i = 0; i < subtree.buckets; ++i) {
        const BucketPlace& place = bucket_places_[subtree.range.part / 2 + i];
        const uint32_t bucket = subtree.first_bucket + i;
        bucket_of_[size_t(place.node)] = int32_t(bucket);
        fill_bucket(place, buckets_[bucket], before);
        perimeters += perimeter(nodes_[size_t(place.node)].box);
    }
    return perimeters;
}

/// Computes the box of a node; the boxes below it must be computed already.
void Tree::fit_node(int32_t index) {
    Node& node = nodes_[size_t(index)];
    const Node &left = nodes_[size_t(node.left)], &right = nodes_[size_t(node.right)];
    node.box = unite(left.box, right.box);
    node.moved = std::max(left.moved, right.moved);
}

void Tree::fill_bucket(const BucketPlace& place, BoxBucket& bucket, const Before& before) const {
    begin_epoch(bucket);
    bucket.count = place.count;
    bucket.moved = 0;
    for (uint32_t i = 0; i < place.count; ++i) {
        const Node& leaf = nodes_[size_t(parts_[place.part + i].node)];
        bucket.now.set(i, leaf.box);
        bucket.item[i] = leaf.item();
        bucket.moved |= uint32_t{has_moved(leaf)} << i;
    }
    if (before.still_in_buckets) return;
    for (uint32_t i = 0; i < place.count; ++i) {
        const uint32_t item = bucket.item[i];
        bucket.before.set(i, item < before.boxes.size() ? before.boxes[item] : no_box);
    }
    for (uint32_t i = place.count; i < BoxBucket::capacity; ++i) {
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
void Tree::update_bucket(int32_t leaf, bool clear_pairs) {
    for (int32_t i = leaf; i != none && !bucket_of_.empty(); i = nodes_[size_t(i)].parent) {
        const int32_t place = bucket_of_[size_t(i)];
        if (place < 0) continue;
        BoxBucket& bucket = buckets_[size_t(place)];
        begin_epoch(bucket);
        const Node& node = nodes_[size_t(leaf)];
        const uint32_t *first = bucket.item, *last = first + bucket.count;
        const auto slot = uint32_t(std::find(first, last, node.item()) - first);
        bucket.now.set(slot, node.box);
        if (clear_pairs) bucket.before.set(slot, no_box);
        bucket.moved |= uint32_t{1} << slot;
        return;
    }
}

}  // namespace fettle::physics::detail
