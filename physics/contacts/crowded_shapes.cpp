#include <contacts/crowded_shapes.h>
#include <contacts/narrow_phase.h>
#include <geometry/bits.h>
#include <state/limits.h>

#include <algorithm>

namespace fettle::physics::detail {
namespace {

/// A crowded shape makes contacts until it touches this many shapes, and looks for more when it
/// touches half of them.
constexpr uint32_t most_touched = 8;

/// Number of crowded shapes in a task of a thread.
constexpr size_t crowded_at_a_time = 16;

uint64_t hash_of(uint64_t pair) {
    pair ^= pair >> 31;
    pair *= 0x9e3779b97f4a7c15u;  // 2⁶⁴ divided by the golden ratio
    return pair ^ pair >> 29;
}

/// Areas of the same power of two count as equal.
uint32_t size_class(const ShapeRecord& shape) {
    return bits_of(shape.area) >> 23;
}

struct Candidate {
    uint64_t order;
    uint32_t shape;

    friend bool operator<(const Candidate& a, const Candidate& b) { return a.order < b.order; }
};

struct Choice {
    const ObjectState& objects;
    const Columns& columns;
    const BroadPhaseState& boxes;
    const WorldDef& settings;
    uint64_t step;

    bool is_awake(uint32_t shape) const {
        return objects.bodies[objects.forms[shape].body].solver_index != 0;
    }

    bool touch(uint32_t a, uint32_t b) const {
        if (!overlap(grow(boxes.boxes[a], speculative_margin), boxes.boxes[b])) return false;
        ContactRecord contact;
        contact.shape_a = a, contact.shape_b = b;
        contact.body_a = objects.forms[a].body, contact.body_b = objects.forms[b].body;
        const ShapeForm &form_a = objects.forms[a], &form_b = objects.forms[b];
        Manifold& m = contact.manifold;
        if (usual_forms(form_a, form_b))
            collide(objects.convex(a), objects.convex(b), form_b.center - form_a.center,
                    speculative_margin, m);
        else
            collide_special_forms(objects, columns, settings, contact, speculative_margin, false,
                                  m);
        return m.count > 0;
    }

    /// Appends the pairs that the shape chooses. Returns whether it is still crowded.
    bool choose(uint32_t shape, std::vector<uint64_t>& found) const {
        uint32_t decided = 0, touched = 0;
        objects.for_each_contact_of(shape, [&](uint32_t contact) {
            const ContactRecord& c = objects.contacts[contact];
            if (decider_of(objects, c.shape_a, c.shape_b) != shape) return;
            ++decided;
            touched += c.manifold.count > 0;
        });
        const bool awake = is_awake(shape);
        if (awake && 2 * touched > most_touched) return true;
        const auto add = [&](uint32_t other) {
            found.push_back(uint64_t{std::max(shape, other)} << 32 | std::min(shape, other));
        };
        std::vector<Candidate> candidates;
        boxes.moving_tree.query(boxes.fat_boxes[shape], [&](uint32_t other) {
            if (other == shape || !filters_agree(objects, shape, other)) return;
            const uint32_t decider = decider_of(objects, shape, other);
            if (decider == none || (awake && decider != shape)) return;
            if (joint_forbids_contact(objects, objects.forms[shape].body,
                                      objects.forms[other].body) ||
                boxes.pairs.find(shape, other) != PairSet::absent)
                return;
            const uint64_t pair = uint64_t{std::max(shape, other)} << 32 | std::min(shape, other);
            if (decider == shape)
                candidates.push_back({hash_of(pair + step), other});
            else if (!objects.shapes[decider].crowded)
                add(other);  // the shape has fallen asleep near a body that is awake
        });
        if (decided + candidates.size() <= most_decided) {
            for (const Candidate& candidate : candidates) add(candidate.shape);
            return false;
        }
        if (!awake) return true;
        // Another order in every step, since the filter of the user may refuse some of them.
        std::make_heap(candidates.begin(), candidates.end());
        while (touched < most_touched && !candidates.empty()) {
            std::pop_heap(candidates.begin(), candidates.end());
            const uint32_t other = candidates.back().shape;
            candidates.pop_back();
            if (!touch(std::min(shape, other), std::max(shape, other))) continue;
            add(other);
            ++touched;
        }
        return true;
    }
};

/// Number of contacts that the shape decides about.
uint32_t decided_contacts(const ObjectState& objects, uint32_t shape) {
    uint32_t count = 0;
    objects.for_each_contact_of(shape, [&](uint32_t contact) {
        const ContactRecord& c = objects.contacts[contact];
        count += decider_of(objects, c.shape_a, c.shape_b) == shape;
    });
    return count;
}

}  // namespace

uint32_t decider_of(const ObjectState& objects, uint32_t a, uint32_t b) {
    const BodyRecord& body_a = objects.bodies[objects.forms[a].body];
    const BodyRecord& body_b = objects.bodies[objects.forms[b].body];
    if (body_a.mobility != Mobility::dynamic || body_b.mobility != Mobility::dynamic) return none;
    const ShapeRecord &shape_a = objects.shapes[a], &shape_b = objects.shapes[b];
    if (shape_a.surface.sensor || shape_b.surface.sensor) return none;
    const bool awake_a = body_a.solver_index != 0, awake_b = body_b.solver_index != 0;
    if (awake_a != awake_b) return awake_a ? a : b;
    const uint32_t size_a = size_class(shape_a), size_b = size_class(shape_b);
    if (size_a != size_b) return size_a < size_b ? a : b;
    const uint64_t pair = uint64_t{std::max(a, b)} << 32 | std::min(a, b);
    return (hash_of(pair) >> 63) != 0 ? std::min(a, b) : std::max(a, b);
}

void remove_crowded_pairs(ObjectState& objects, PairScratch& scratch) {
    std::vector<uint32_t>& finds = scratch.finds;
    const auto decider_of_pair = [&](uint64_t pair) {
        return decider_of(objects, uint32_t(pair), uint32_t(pair >> 32));
    };
    bool any = false;
    for (const uint64_t pair : scratch.new_pairs) {
        const uint32_t decider = decider_of_pair(pair);
        if (decider == none || objects.shapes[decider].crowded) continue;
        const uint32_t found = finds[decider];
        if (found + objects.bodies[objects.forms[decider].body].lists.contact_count <= most_decided)
            continue;
        if (found <= most_decided && found + decided_contacts(objects, decider) <= most_decided)
            continue;
        objects.set_crowded(decider, true);
        any = true;
    }
    for (const uint64_t pair : scratch.new_pairs)
        if (const uint32_t decider = decider_of_pair(pair); decider != none) finds[decider] = 0;
    if (!any) return;
    std::erase_if(scratch.new_pairs, [&](uint64_t pair) {
        const uint32_t decider = decider_of_pair(pair);
        return decider != none && objects.shapes[decider].crowded;
    });
}

void choose_crowded_pairs(ObjectState& objects, const Columns& columns,
                          const BroadPhaseState& boxes, const WorldDef& settings, uint64_t step,
                          PairScratch& scratch, ThreadPool* threads) {
    if (objects.crowded_shapes == 0) return;
    std::vector<uint32_t>& crowded = scratch.crowded;
    crowded.clear();
    for (const uint32_t shape : boxes.moved_shapes)
        if (objects.shapes[shape].crowded && objects.shapes[shape].proxy != Tree::none)
            crowded.push_back(shape);
    scratch.still_crowded.resize(crowded.size());
    const Choice choice = {objects, columns, boxes, settings, step};
    const size_t pieces = (crowded.size() + crowded_at_a_time - 1) / crowded_at_a_time;
    search_in_pieces(scratch, pieces, threads, [&](size_t piece, std::vector<uint64_t>& found) {
        const size_t end = std::min((piece + 1) * crowded_at_a_time, crowded.size());
        for (size_t i = piece * crowded_at_a_time; i < end; ++i)
            scratch.still_crowded[i] = choice.choose(crowded[i], found);
    });
    for (size_t i = 0; i < crowded.size(); ++i)
        objects.set_crowded(crowded[i], scratch.still_crowded[i] != 0);
}

}  // namespace fettle::physics::detail
