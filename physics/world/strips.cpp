#include <world/world_data.h>

#include <algorithm>
#include <array>

// Where the world is cut for several threads, from what it is at the moment alone: a restored world
// is cut like the one that was saved.

namespace fettle::physics::detail {
namespace {

/// Bodies that are asked where they are: halves come out a few hundredths from equal.
constexpr size_t sample_count = 256;

/// What a body in a heap has at most, if it is no larger than the others.
constexpr uint32_t usual_neighbors = 8;

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
}

}  // namespace fettle::physics::detail
