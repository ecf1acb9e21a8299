// Cutting the world into strips, and sorting of lists by strips.

#include <schedule/schedule.h>

#include <algorithm>
#include <array>

namespace fettle::physics::detail {
namespace {

/// Number of sampled bodies: with this number, the work of two halves differs by one or two
/// percent.
constexpr size_t sample_count = 1024;

/// Maximum number of neighbors of a body in a heap of bodies of similar size.
constexpr uint32_t usual_neighbors = 8;

/// Steps between two cuts. Bodies do not move far within a few steps.
constexpr uint64_t cut_interval = 8;

/// Steps after which the lists are sorted by strips again; few bodies change their strip in a step.
/// The order inside a strip stays useful for longer.
constexpr uint64_t order_interval = 16, sort_interval = 64;

/// Number of entries in a task of a thread, and the prefetch distance.
constexpr size_t entries_at_a_time = 512, records_ahead = 8;

/// Stable sort of a list of slots of `records`. `strip_of(slot)` is the sort key; `place(slot, i)`
/// stores the new index. `placed`: the stored indices are correct before the sort.
template <typename Records, typename StripOf, typename Place>
void order_by_strip(ThreadPool* threads, Reordering& scratch, std::vector<uint32_t>& list,
                    bool placed, Records& records, StripOf&& strip_of, Place&& place) {
    const auto each = [&](auto&& visit) {
        parallel_for(threads, list.size(), entries_at_a_time, [&](size_t begin, size_t end) {
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
    if (!std::is_sorted(strips.begin(), strips.end())) {
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

void cut_into_strips(const ObjectState& objects, const ActiveLists& active, bool groups,
                     uint64_t step, Strips& strips) {
    const std::vector<uint32_t>& awake = active.awake_bodies;
    size_t links = active.awake_contacts.size();
    for (const auto& list : active.awake_joints) links += list.size();
    const uint32_t count = groups ? Strips::count_for(links) : 1;
    if (count == 1 || awake.empty()) {
        strips = {};
        return;
    }
    if (count == strips.count() && step % cut_interval != 0) return;
    // Evenly distributed, but at random distances, because rows of bodies have a regular distance.
    std::array<const BodyRecord*, sample_count> sampled;
    const size_t all = awake.size(), size = std::min(all, sample_count);
    uint32_t random = 0x9e3779b9u;
    for (size_t i = 0; i < size; ++i) {
        random = random * 1664525u + 1013904223u;
        const size_t begin = i * all / size, end = (i + 1) * all / size;
        sampled[i] = &objects.bodies[awake[begin + (random >> 8) % (end - begin)]];
        __builtin_prefetch(sampled[i]);
    }
    std::array<StripSample, sample_count> samples;
    for (size_t i = 0; i < size; ++i) {
        const BodyRecord& body = *sampled[i];
        // A body with many neighbors, such as a platform, has at most the weight of a body in a
        // heap.
        const uint32_t neighbors =
            std::min(body.lists.contact_count + body.lists.joint_count, usual_neighbors);
        samples[i] = {Vec2(body.center), float(1 + neighbors)};
    }
    strips.cut(std::span(samples).first(size), count);
}

void order_lists(ObjectState& objects, ActiveLists& active, const Strips& strips,
                 const BodyScratch& bodies, uint64_t step, Reordering& reordering,
                 ThreadPool* threads) {
    if (strips.count() == 1 || step % order_interval != 0) return;
    const auto strip_of = [&](uint32_t body_a, uint32_t body_b) {
        const SolverEnd a = bodies.solver_ends[body_a], b = bodies.solver_ends[body_b];
        return a.moves() && !a.is_hub() ? a.strip() : b.strip();
    };
    const auto order = [&](std::vector<uint32_t>& list, bool placed, auto& records,
                           auto&& strip_of_one, auto&& place) {
        order_by_strip(threads, reordering, list, placed, records, strip_of_one, place);
    };
    // The bodies of a strip in the order of their memory.
    std::vector<uint32_t>& awake = active.awake_bodies;
    const bool in_order = step % sort_interval != 0 || std::is_sorted(awake.begin(), awake.end());
    if (!in_order) std::sort(awake.begin(), awake.end());
    order(
        active.awake_bodies, in_order, objects.bodies,
        [&](uint32_t body) { return bodies.solver_ends[body].strip(); },
        [&](uint32_t body, uint32_t i) { objects.bodies[body].solver_index = i + 1; });
    order(
        active.awake_contacts, true, objects.contacts,
        [&](uint32_t slot) {
            return strip_of(objects.contacts[slot].body_a, objects.contacts[slot].body_b);
        },
        [&](uint32_t slot, uint32_t i) { objects.contacts[slot].awake_index = i; });
    for (auto& list : active.awake_joints) {
        order(
            list, true, objects.joints,
            [&](uint32_t slot) {
                return strip_of(objects.joints[slot].bodies[0], objects.joints[slot].bodies[1]);
            },
            [&](uint32_t slot, uint32_t i) { objects.joints[slot].awake_index = i; });
    }
}

}  // namespace fettle::physics::detail
