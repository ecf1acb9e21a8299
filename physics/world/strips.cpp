#include <world/world_data.h>

#include <algorithm>
#include <array>

// Where the world is cut for several threads, and that what is in a strip stands together in the
// lists. All of it follows from the state of the world, of which the strips are a part: a restored
// world is cut like the one that was saved.

namespace fettle::physics::detail {
namespace {

/// Bodies that are asked where they are: halves come out a few hundredths from equal.
constexpr size_t sample_count = 256;

/// What a body in a heap has at most, if it is no larger than the others.
constexpr uint32_t usual_neighbors = 8;

/// Steps between two cuts: in a few, work does not go far.
constexpr uint64_t cut_interval = 8;

/// Steps between two looks at whether the lists are in the order of the strips: bodies take their
/// time from one strip to another.
constexpr uint64_t order_interval = 64;

/// Stable. `strip_of(slot)`; `place(slot, i)`: told where it is now.
template <typename StripOf, typename Place>
void order_by_strip(std::vector<uint32_t>& list, std::vector<uint32_t>& spare, StripOf&& strip_of,
                    Place&& place) {
    if (std::ranges::is_sorted(list, {}, strip_of)) return;
    NodeRanges ranges;
    for (const uint32_t slot : list) ranges.count(strip_of(slot));
    ranges.sum_up();
    auto next = ranges.places();
    spare.resize(list.size());
    for (const uint32_t slot : list) {
        const uint32_t i = next[strip_of(slot)]++;
        spare[i] = slot;
        place(slot, i);
    }
    list.swap(spare);
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
    // Those of a strip in the order in which they are in memory.
    const auto strip_of_body = [&](uint32_t body) { return solver_ends[body].strip(); };
    if (!std::ranges::is_sorted(awake_bodies, {}, strip_of_body)) std::ranges::sort(awake_bodies);
    order_by_strip(awake_bodies, reordered, strip_of_body,
                   [&](uint32_t body, uint32_t i) { bodies[body].solver_index = i + 1; });
    order_by_strip(
        awake_contacts, reordered,
        [&](uint32_t contact) {
            return strip_of(contacts[contact].body_a, contacts[contact].body_b);
        },
        [&](uint32_t contact, uint32_t i) { contacts[contact].awake_index = i; });
    for (auto& list : awake_joints) {
        order_by_strip(
            list, reordered,
            [&](uint32_t joint) {
                return strip_of(joints[joint].bodies[0], joints[joint].bodies[1]);
            },
            [&](uint32_t joint, uint32_t i) { joints[joint].awake_index = i; });
    }
}

}  // namespace fettle::physics::detail
