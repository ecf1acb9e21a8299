#include <contacts/crowded_shapes.h>
#include <contacts/pairs.h>
#include <wide/kernels.h>

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>

namespace fettle::physics::detail {
namespace {

/// Number of moved shapes in a task of a thread, and number of parts of a walk through the trees.
constexpr size_t shapes_at_a_time = 16, walk_parts = 64;
/// Prefetch distance.
constexpr size_t pairs_ahead = 6;

struct PairSearch {
    const ObjectState& objects;
    std::span<const uint32_t> generations;  ///< of the shapes
    const BroadPhaseState& boxes;
    PairScratch& scratch;
    FindOverlaps overlaps;
    ThreadPool* threads;

    // Several threads count at a time. Some standard libraries have no std::atomic_ref.
    uint32_t finds_of(uint32_t decider) const {
        return __atomic_load_n(&scratch.finds[decider], __ATOMIC_RELAXED);
    }
    void count_find_of(uint32_t decider) const {
        __atomic_fetch_add(&scratch.finds[decider], 1u, __ATOMIC_RELAXED);
    }
    /// True if the pairs of the shape need no list: it chooses them by itself.
    bool is_crowded(uint32_t decider) const {
        return objects.shapes[decider].crowded || finds_of(decider) > most_decided;
    }

    /// Adds the pair if it is new: the fat boxes overlap, and one of them has moved.
    void add_if_new(uint32_t shape, uint32_t other, std::vector<uint64_t>& found) const {
        if (overlap(boxes.paired_boxes[shape], boxes.paired_boxes[other]))
            return;  // decided in an earlier search
        const uint32_t decider = decider_of(objects, shape, other);
        if (decider != none && is_crowded(decider)) return;
        if (!filters_agree(objects, shape, other) ||
            joint_forbids_contact(objects, objects.forms[shape].body, objects.forms[other].body) ||
            boxes.pairs.find(shape, other) != PairSet::absent)
            return;
        if (decider != none) count_find_of(decider);
        found.push_back(uint64_t{std::max(shape, other)} << 32 | std::min(shape, other));
    }

    /// Queries the trees for each shape that has moved.
    void search_around_moved() {
        const size_t count = (boxes.moved_shapes.size() + shapes_at_a_time - 1) / shapes_at_a_time;
        search_in_pieces(scratch, count, threads, [&](size_t piece, std::vector<uint64_t>& found) {
            const size_t begin = piece * shapes_at_a_time;
            const size_t end = std::min(begin + shapes_at_a_time, boxes.moved_shapes.size());
            for (size_t i = begin; i < end; ++i) {
                const uint32_t shape = boxes.moved_shapes[i];
                const ShapeRecord& record = objects.shapes[shape];
                if (record.proxy == Tree::none) continue;
                const auto add_pair = [&](uint32_t other) { add_if_new(shape, other, found); };
                if (record.tree == Mobility::fixed) {
                    boxes.moving_tree.query(boxes.fixed_tree.box(record.proxy), add_pair);
                } else {
                    boxes.moving_tree.pairs_of_leaf(record.proxy, boxes.paired_boxes[shape],
                                                    overlaps, add_pair);
                    boxes.fixed_tree.query(boxes.moving_tree.box(record.proxy), add_pair);
                }
            }
        });
    }

    /// Compares the moving tree with itself and with the fixed tree, in one round.
    void walk_trees() {
        const size_t enough = threads != nullptr ? walk_parts : 1;
        scratch.parts_of_walk.clear();
        boxes.moving_tree.begin_walk(boxes.moving_tree, enough, scratch.parts_of_walk);
        const size_t own = scratch.parts_of_walk.size();
        boxes.moving_tree.begin_walk(boxes.fixed_tree, enough, scratch.parts_of_walk);
        // The first parts are the largest, so they are distributed evenly to the threads.
        const size_t workers = threads != nullptr ? size_t(threads->at_a_time()) : 1;
        const size_t each = (scratch.parts_of_walk.size() + workers - 1) / workers;
        search_in_pieces(
            scratch, each * workers, threads, [&](size_t piece, std::vector<uint64_t>& found) {
                const size_t part = piece / each + piece % each * workers;
                if (part >= scratch.parts_of_walk.size()) return;
                const Tree& other = part < own ? boxes.moving_tree : boxes.fixed_tree;
                const auto add_pair = [&](uint32_t a, uint32_t b) { add_if_new(a, b, found); };
                boxes.moving_tree.pairs(other, scratch.parts_of_walk[part], overlaps, add_pair);
            });
    }

    /// Adds pairs with the border, which is in no tree.
    void search_at_border() {
        for (const uint32_t shape : boxes.moved_shapes) {
            if (objects.forms[shape].body == none || generations[shape] == 0) continue;
            if (objects.bodies[objects.forms[shape].body].mobility != Mobility::dynamic) continue;
            for (uint32_t side = 0; side < border_sides; ++side) {
                if (overlap(boxes.fat_boxes[shape], boxes.fat_boxes[side]))
                    add_if_new(shape, side, scratch.new_pairs);
            }
        }
    }
};

/// Sorts the pairs into buckets by the upper shape first; most buckets get one or two pairs. This
/// takes a third of the time of sorting them at once.
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

/// Sorts by shapes, so that the order in the trees has no effect.
void order_pairs(std::vector<uint64_t>& pairs, std::vector<uint64_t>& spare, size_t shapes,
                 const UserFilter& filter) {
    sort_pairs(pairs, spare, shapes);
    // A pair with a fixed shape is found twice if both moved.
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    if (!filter) return;
    std::erase_if(pairs,
                  [&](uint64_t pair) { return !filter(uint32_t(pair), uint32_t(pair >> 32)); });
}

/// Prefetches the records that the creation of a contact reads.
void prefetch_pair(const ObjectState& objects, const PairSet& pairs, uint64_t pair) {
    const auto a = uint32_t(pair), b = uint32_t(pair >> 32);
    for (const uint32_t shape : {a, b}) {
        __builtin_prefetch(&objects.shapes[shape]);
        __builtin_prefetch(&objects.bodies[objects.forms[shape].body].lists.first_contact, 1);
    }
    pairs.prefetch(a, b);
}

}  // namespace

void create_contacts(const ContactList& list, const WorldDef& settings,
                     std::span<const uint64_t> new_pairs) {
    const ObjectState& objects = list.touching.objects;
    for (size_t i = 0; i < new_pairs.size(); ++i) {
        if (i + pairs_ahead < new_pairs.size())
            prefetch_pair(objects, list.pairs, new_pairs[i + pairs_ahead]);
        create_contact(list, settings, uint32_t(new_pairs[i]), uint32_t(new_pairs[i] >> 32));
        if (objects.contact_slots.free == none) continue;
        objects.contacts[objects.contact_slots.free].prefetch();
        __builtin_prefetch(&objects.contact_links[objects.contact_slots.free], 1);
    }
}

void find_pairs(ObjectState& objects, const Columns& columns, BroadPhaseState& boxes,
                const WorldDef& settings, uint64_t step, PairScratch& scratch,
                const UserFilter& filter, FindOverlaps overlaps, ThreadPool* threads) {
    const std::vector<uint32_t>& moved = boxes.moved_shapes;
    scratch.relocated.resize(objects.shapes.size(), 0);
    scratch.finds.resize(objects.shapes.size(), 0);
    scratch.new_pairs.clear();
    if (moved.empty()) return;
    boxes.moving_tree.rebuild(threads, boxes.paired_boxes);
    boxes.fixed_tree.rebuild(threads, boxes.paired_boxes);
    PairSearch search = {objects, columns.shape_generations, boxes, scratch, overlaps, threads};
    if (4 * moved.size() < boxes.moving_tree.size())
        search.search_around_moved();
    else
        search.walk_trees();
    if (settings.bounds) search.search_at_border();
    remove_crowded_pairs(objects, scratch);
    choose_crowded_pairs(objects, columns, boxes, settings, step, scratch, threads);
    order_pairs(scratch.new_pairs, scratch.spare_pairs, objects.shapes.size(), filter);
    for (const uint32_t shape : moved) scratch.relocated[shape] = 1;
    boxes.moving_tree.clear_moves();
    boxes.fixed_tree.clear_moves();
}

}  // namespace fettle::physics::detail
