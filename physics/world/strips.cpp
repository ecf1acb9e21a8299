#include <world/world_data.h>

#include <algorithm>
#include <array>

// Where the world is cut for several threads, and that what is in a strip stands together in the
// lists. All of it follows from the state of the world, of which the strips are a part: a restored
// world is cut like the one that was saved.

namespace fettle::physics::detail {
namespace {

/// Bodies that are asked where they are: halves come out a hundredth or two from equal.
constexpr size_t sample_count = 1024;

/// What a body in a heap has at most, if it is no larger than the others.
constexpr uint32_t usual_neighbors = 8;

/// Steps between two cuts: in a few, work does not go far.
constexpr uint64_t cut_interval = 8;

/// Steps between two looks at whether the lists are in the order of the strips: bodies take their
/// time from one strip to another, contacts come and go at the end of the list. What is in order
/// within a strip stays so for longer.
constexpr uint64_t order_interval = 16, sort_interval = 64;

/// What a thread takes at a time, and far enough that a record is there when its turn comes.
constexpr size_t piece_length = 512, records_ahead = 8;

/// Stable. `records`: where what is in the list is asked for; `strip_of(slot)`; `place(slot, i)`:
/// told where it is now. `placed`: so far all know where they are.
template <typename Records, typename StripOf, typename Place>
void order_by_strip(ThreadPool* threads, Reordering& scratch, std::vector<uint32_t>& list,
                    bool placed, Records& records, StripOf&& strip_of, Place&& place) {
    const auto each = [&](auto&& visit) {
        share_out_range(threads, list.size(), piece_length, [&](size_t begin, size_t end) {
            for (size_t i = begin; i < end; ++i) {
                if (i + records_ahead < end)
                    __builtin_prefetch(&records[list[i + records_ahead]], 1);
                visit(i);
            }
        });
    };
    std::vector<StripNode>& strips = scratch.strips;
    strips.resize(list.size());
    each([&](size_t i) { strips[i] = strip_of(list[i]); });
    if (!std::ranges::is_sorted(strips)) {
        NodeRanges ranges;
        for (const StripNode strip : strips) ranges.count(strip);
        ranges.sum_up();
        auto next = ranges.places();
        scratch.list.resize(list.size());
        for (size_t i = 0; i < list.size(); ++i) scratch.list[next[strips[i]]++] = list[i];
        list.swap(scratch.list);
    } else if (placed) {
        return;
    }
    each([&](size_t i) { place(list[i], uint32_t(i)); });
}

}  // namespace

void WorldData::cut_into_strips() {
    size_t links = awake_contacts.size();
    for (const auto& list : awake_joints) links += list.size();
    const bool groups = settings.solver == Solver::soft_step;  // the others solve all as one
    const uint32_t count = groups ? Strips::count_for(links) : 1;
    if (count == 1 || awake_bodies.empty()) {
        strips = {};
        return;
    }
    if (count == strips.count() && steps % cut_interval != 0) return;
    // One of every so many, not always at the same distance: rows of bodies have their own.
    std::array<const BodyRecord*, sample_count> sampled;
    const size_t all = awake_bodies.size(), size = std::min(all, sample_count);
    uint32_t random = 0x9e3779b9u;
    for (size_t i = 0; i < size; ++i) {
        random = random * 1664525u + 1013904223u;
        const size_t begin = i * all / size, end = (i + 1) * all / size;
        sampled[i] = &bodies[awake_bodies[begin + (random >> 8) % (end - begin)]];
        __builtin_prefetch(sampled[i]);
    }
    std::array<StripSample, sample_count> samples;
    for (size_t i = 0; i < size; ++i) {
        const BodyRecord& body = *sampled[i];
        // One that everything lies on says little about where the others are.
        const uint32_t neighbors = std::min(body.contact_count + body.joint_count, usual_neighbors);
        samples[i] = {body.center, float(1 + neighbors)};
    }
    strips.cut(std::span(samples).first(size), count);
}

/// What is solved together stands together in the lists: in all stages a thread then has what it
/// has in its cache from the stage before.
void WorldData::order_lists() {
    if (strips.count() == 1 || steps % order_interval != 0) return;
    const auto strip_of = [&](uint32_t body_a, uint32_t body_b) {
        const SolverEnd a = solver_ends[body_a], b = solver_ends[body_b];
        return a.moves() && !a.is_hub() ? a.strip() : b.strip();
    };
    const auto order = [&](std::vector<uint32_t>& list, bool placed, auto& records,
                           auto&& strip_of_one, auto&& place) {
        order_by_strip(threads, reordering, list, placed, records, strip_of_one, place);
    };
    // Those of a strip in the order in which they are in memory.
    const bool in_order = steps % sort_interval != 0 || std::ranges::is_sorted(awake_bodies);
    if (!in_order) std::ranges::sort(awake_bodies);
    order(
        awake_bodies, in_order, bodies, [&](uint32_t body) { return solver_ends[body].strip(); },
        [&](uint32_t body, uint32_t i) { bodies[body].solver_index = i + 1; });
    order(
        awake_contacts, true, contacts,
        [&](uint32_t slot) { return strip_of(contacts[slot].body_a, contacts[slot].body_b); },
        [&](uint32_t slot, uint32_t i) { contacts[slot].awake_index = i; });
    for (auto& list : awake_joints) {
        order(
            list, true, joints,
            [&](uint32_t slot) { return strip_of(joints[slot].bodies[0], joints[slot].bodies[1]); },
            [&](uint32_t slot, uint32_t i) { joints[slot].awake_index = i; });
    }
}

}  // namespace fettle::physics::detail
