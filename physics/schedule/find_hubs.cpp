// Search for hubs among the awake bodies.

#include <schedule/schedule.h>

namespace fettle::physics::detail {
namespace {

/// Number of contacts of a body that are examined, and how many of these must be with a much
/// lighter body.
constexpr uint32_t examined = 16, least_lighter = 12;

/// Inverse of the mass that a push at the rim accelerates, by translation and rotation together.
float inverse_mass_at_rim(const BodyRecord& record) {
    return record.inverse_mass + record.inverse_inertia * record.extent * record.extent;
}

bool is_hub(const ObjectState& objects, const Hubs& hubs, uint32_t body) {
    const BodyRecord& record = objects.bodies[body];
    if (record.lists.contact_count < Hubs::least_contacts || record.mobility != Mobility::dynamic ||
        record.flags.locked_x || record.flags.locked_y || record.flags.locked_rotation)
        return false;
    const float at_rim = inverse_mass_at_rim(record);
    uint32_t seen = 0, lighter = 0;
    for (uint32_t edge = record.lists.first_contact; edge != none && seen < examined; ++seen) {
        const uint32_t other = objects.other_body(edge >> 1, body);
        lighter += hubs.outweighs(at_rim, objects.bodies[other].inverse_mass);
        edge = objects.contact_links[edge >> 1].edges[edge & 1].next;
    }
    return lighter >= least_lighter;
}

}  // namespace

void find_hubs(const ObjectState& objects, std::span<const uint32_t> awake, size_t begin,
               size_t end, BodyScratch& bodies, Hubs& hubs) {
    for (size_t i = begin; i < end && !hubs.full(); ++i) {
        const uint32_t body = awake[i];
        if (!is_hub(objects, hubs, body)) continue;
        const auto index = uint32_t(i + 1);
        bodies.solver_ends[body] = SolverEnd::of_hub(index);
        hubs.add(index, inverse_mass_at_rim(objects.bodies[body]), bodies.solver_bodies);
    }
}

}  // namespace fettle::physics::detail
