#include <world/world_data.h>

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>

// New pairs of shapes. Where few have moved, each looks around itself; else the trees are walked
// against each other. Either is shared out: what is found is put into order before anything is made
// of it.

namespace fettle::physics::detail {
namespace {

/// Moved shapes that a thread takes at a time, and parts that a walk is shared out in.
constexpr size_t shapes_at_a_time = 16, walk_parts = 64;
/// Far enough that what a pair needs is there when its turn comes.
constexpr size_t pairs_ahead = 6;

}  // namespace

/// Of two whose fat boxes overlap, and of which one moved.
void WorldData::look_at_pair(uint32_t shape, uint32_t other, std::vector<uint64_t>& found) const {
    if (overlap(paired_boxes[shape], paired_boxes[other])) return;  // known, one way or the other
    if (!filters_agree(shape, other) ||
        joint_forbids_contact(forms[shape].body, forms[other].body) ||
        pairs.find(shape, other) != PairSet::absent)
        return;
    found.push_back(uint64_t{std::max(shape, other)} << 32 | std::min(shape, other));
}

/// `look(piece, found)` for every piece, each with a list of its own.
template <typename Look>
void WorldData::look_in_pieces(size_t count, Look&& look) {
    if (found_pairs.size() < count) found_pairs.resize(count);
    share_out(threads, uint32_t(count), [&](uint32_t piece) {
        found_pairs[piece].clear();
        look(piece, found_pairs[piece]);
    });
    for (size_t piece = 0; piece < count; ++piece) {
        const std::vector<uint64_t>& found = found_pairs[piece];
        new_pairs.insert(new_pairs.end(), found.begin(), found.end());
    }
}

/// Of those that have moved, one by one.
void WorldData::look_around_moved() {
    const FindOverlaps overlaps = wide_kernels(most_lanes).overlaps;
    const size_t count = (moved_shapes.size() + shapes_at_a_time - 1) / shapes_at_a_time;
    look_in_pieces(count, [&](size_t piece, std::vector<uint64_t>& found) {
        const size_t begin = piece * shapes_at_a_time;
        const size_t end = std::min(begin + shapes_at_a_time, moved_shapes.size());
        for (size_t i = begin; i < end; ++i) {
            const uint32_t shape = moved_shapes[i];
            const ShapeRecord& record = shapes[shape];
            if (record.proxy == Tree::none) continue;
            const auto look = [&](uint32_t other) { look_at_pair(shape, other, found); };
            if (record.tree == Mobility::fixed) {
                moving_tree.query(fixed_tree.box(record.proxy), look);
            } else {
                moving_tree.look_around(record.proxy, paired_boxes[shape], overlaps, look);
                fixed_tree.query(moving_tree.box(record.proxy), look);
            }
        }
    });
}

/// The moving one against itself and against the fixed one, in one round.
void WorldData::walk_trees() {
    const FindOverlaps overlaps = wide_kernels(most_lanes).overlaps;
    const size_t enough = threads != nullptr ? walk_parts : 1;
    parts_of_walk.clear();
    moving_tree.begin_walk(moving_tree, enough, parts_of_walk);
    const size_t own = parts_of_walk.size();
    moving_tree.begin_walk(fixed_tree, enough, parts_of_walk);
    // The first parts are the largest: dealt out, so that every thread has as many of them.
    const size_t hands = threads != nullptr ? size_t(threads->at_a_time()) : 1;
    const size_t each = (parts_of_walk.size() + hands - 1) / hands;
    look_in_pieces(each * hands, [&](size_t piece, std::vector<uint64_t>& found) {
        const size_t part = piece / each + piece % each * hands;
        if (part >= parts_of_walk.size()) return;
        const Tree& other = part < own ? moving_tree : fixed_tree;
        const auto look = [&](uint32_t a, uint32_t b) { look_at_pair(a, b, found); };
        moving_tree.pairs(other, parts_of_walk[part], overlaps, look);
    });
}

/// The border is in no tree.
void WorldData::look_at_border() {
    for (const uint32_t shape : moved_shapes) {
        if (forms[shape].body == none || shape_generations[shape] == 0) continue;
        if (bodies[forms[shape].body].mobility != Mobility::dynamic) continue;
        for (uint32_t side = 0; side < 4; ++side) {
            if (overlap(fat_boxes[shape], fat_boxes[side])) look_at_pair(shape, side, new_pairs);
        }
    }
}

namespace {

/// Sorted. Spread over buckets by the upper shape first, most of which get one or two: a third of
/// the time.
void sort_pairs(std::vector<uint64_t>& pairs, std::vector<uint64_t>& spare, size_t shapes) {
    constexpr int bits = 8;
    const int shift = 32 + std::max(0, int(std::bit_width(shapes)) - bits);
    std::array<uint32_t, 1 + (1 << bits)> begin = {};
    for (const uint64_t pair : pairs) ++begin[1 + (pair >> shift)];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    auto end = begin;
    spare.resize(pairs.size());
    for (const uint64_t pair : pairs) spare[end[pair >> shift]++] = pair;
    pairs.swap(spare);
    for (size_t bucket = 0; bucket + 1 < begin.size(); ++bucket)
        if (end[bucket] > begin[bucket] + 1)
            std::sort(pairs.begin() + begin[bucket], pairs.begin() + end[bucket]);
}

}  // namespace

/// In the order of the shapes, whatever that of the trees.
void WorldData::order_pairs() {
    sort_pairs(new_pairs, spare_pairs, shapes.size());
    // A pair of which one is fixed is seen twice, if both moved.
    new_pairs.erase(std::unique(new_pairs.begin(), new_pairs.end()), new_pairs.end());
    if (!self.filter) return;
    std::erase_if(new_pairs, [&](uint64_t pair) {
        return !callback_agrees(uint32_t(pair), uint32_t(pair >> 32));
    });
}

/// What is made of a pair is anywhere in memory: asked for some pairs before its turn.
void WorldData::prefetch_pair(uint64_t pair) const {
    const auto a = uint32_t(pair), b = uint32_t(pair >> 32);
    for (const uint32_t shape : {a, b}) {
        __builtin_prefetch(&shapes[shape]);
        __builtin_prefetch(&bodies[forms[shape].body].first_contact, 1);
    }
    pairs.prefetch(a, b);
}

/// What there are already may be collided meanwhile.
void WorldData::create_contacts() {
    for (size_t i = 0; i < new_pairs.size(); ++i) {
        if (i + pairs_ahead < new_pairs.size()) prefetch_pair(new_pairs[i + pairs_ahead]);
        create_contact(uint32_t(new_pairs[i]), uint32_t(new_pairs[i] >> 32));
        if (contact_slots.free == none) continue;
        contacts[contact_slots.free].prefetch();
        __builtin_prefetch(&contact_links[contact_slots.free], 1);
    }
}

/// All pairs are known now that their fat boxes make.
void WorldData::mark_paired(std::span<const uint32_t> moved) {
    for (const uint32_t shape : moved) {
        shapes[shape].moved = false;
        paired_boxes[shape] = fat_boxes[shape];
    }
}

void WorldData::find_pairs() {
    relocated.resize(shapes.size(), 0);
    new_pairs.clear();
    if (moved_shapes.empty()) return;
    moving_tree.settle(threads, paired_boxes);
    fixed_tree.settle(threads, paired_boxes);
    if (4 * moved_shapes.size() < moving_tree.size())
        look_around_moved();
    else
        walk_trees();
    if (settings.bounds) look_at_border();
    order_pairs();
    for (const uint32_t shape : moved_shapes) relocated[shape] = 1;
    moving_tree.rest();
    fixed_tree.rest();
}

}  // namespace fettle::physics::detail
