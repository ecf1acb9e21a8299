#include <world/world_data.h>

#include <algorithm>
#include <array>
#include <numeric>

// Where the world is cut for several threads, from what it is at the moment alone: a restored world
// is cut like the one that was saved. From time to time the lists of what is awake are put in the
// order of the strips: then who gathers, collides, solves and finishes a body is the same thread,
// and the neighbors of a body in memory are its neighbors in the plane.

namespace fettle::physics::detail {
namespace {

/// Bodies that are asked where they are: halves come out a few hundredths from equal.
constexpr size_t sample_count = 256;

/// What a body in a heap has at most, if it is no larger than the others.
constexpr uint32_t usual_neighbors = 8;

/// Steps between two looks at the order.
constexpr uint64_t order_interval = 32;

/// Stable, by the turn of the node that each belongs to.
template <typename Turn>
void sort_by_turn(std::vector<uint32_t>& list, std::vector<uint32_t>& sorted,
                  std::vector<uint8_t>& turns, Turn&& turn) {
    std::array<uint32_t, 2 * most_strips> begin = {};
    turns.resize(list.size());
    for (size_t i = 0; i < list.size(); ++i) {
        turns[i] = turn(list[i]);
        ++begin[turns[i] + 1u];
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    sorted.resize(list.size());
    for (size_t i = 0; i < list.size(); ++i) sorted[begin[turns[i]]++] = list[i];
    list.swap(sorted);
}

/// The strips from left to right, each node after those below it.
std::array<uint8_t, 2 * most_strips> order_of_nodes(uint32_t strips) {
    std::array<uint8_t, 2 * most_strips> order = {};
    uint8_t next = 0;
    for (uint32_t leaf = strips; leaf < 2 * strips; ++leaf) {
        uint32_t node = leaf;
        for (order[node] = next++; node % 2 == 1 && node > 1; node /= 2) order[node / 2] = next++;
    }
    return order;
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
    // One of every so many, not always at the same distance: rows of bodies have their own.
    std::array<const BodyRecord*, sample_count> sampled;
    const size_t every = std::max<size_t>(awake_bodies.size() / sample_count, 1);
    const size_t size = std::min(awake_bodies.size(), sample_count);
    uint32_t random = 0x9e3779b9u;
    for (size_t i = 0; i < size; ++i) {
        random = random * 1664525u + 1013904223u;
        sampled[i] = &bodies[awake_bodies[i * every + (random >> 8) % every]];
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
    if (steps % order_interval == 0) order_by_strips();
}

void WorldData::order_by_strips() {
    const auto order = order_of_nodes(strips.count());
    const auto leaf = [&](uint32_t body) { return strips.leaf_at(bodies[body].center); };
    sort_by_turn(awake_bodies, reordered, turns, [&](uint32_t body) { return order[leaf(body)]; });
    for (size_t i = 0; i < awake_bodies.size(); ++i)
        bodies[awake_bodies[i]].solver_index = uint32_t(i + 1);
    sort_by_turn(awake_contacts, reordered, turns, [&](uint32_t contact) {
        const ContactRecord& c = contacts[contact];
        const bool moves_a = bodies[c.body_a].mobility == Mobility::dynamic;
        const bool moves_b = bodies[c.body_b].mobility == Mobility::dynamic;
        const StripNode a = leaf(moves_a ? c.body_a : c.body_b);
        const StripNode b = leaf(moves_b ? c.body_b : c.body_a);
        return order[above_both(a, b)];
    });
    for (size_t i = 0; i < awake_contacts.size(); ++i)
        contacts[awake_contacts[i]].awake_index = uint32_t(i);
}

}  // namespace fettle::physics::detail
