#include <world/world_data.h>

namespace fettle::physics::detail {
namespace {

/// Contacts of a crowded body that are looked at, and how many have to be with something that is
/// much lighter.
constexpr uint32_t looked_at = 16, enough_of_them = 12;

}  // namespace

/// Of what it is made of as seen from its rim: of a push through the center and a turn there.
float WorldData::inverse_mass_at_rim(uint32_t body) const {
    const BodyRecord& record = bodies[body];
    return record.inverse_mass + record.inverse_inertia * record.extent * record.extent;
}

bool WorldData::is_hub(uint32_t body) const {
    const BodyRecord& record = bodies[body];
    if (record.contact_count < Hubs::least_contacts || record.mobility != Mobility::dynamic ||
        record.locked_x || record.locked_y || record.locked_rotation)
        return false;
    const float at_rim = inverse_mass_at_rim(body);
    uint32_t seen = 0, lighter = 0;
    for (uint32_t edge = record.first_contact; edge != none && seen < looked_at; ++seen) {
        const uint32_t other = other_body(edge >> 1, body);
        lighter += hubs.would_bear(at_rim, bodies[other].inverse_mass);
        edge = contact_links[edge >> 1].edges[edge & 1].next;
    }
    return lighter >= enough_of_them;
}

/// Among the awake bodies from `begin` to `end`.
void WorldData::find_hubs(size_t begin, size_t end) {
    for (size_t i = begin; i < end && !hubs.full(); ++i) {
        const uint32_t body = awake_bodies[i];
        if (!is_hub(body)) continue;
        const auto index = uint32_t(i + 1);
        solver_ends[body] = SolverEnd::of_hub(index);
        hubs.add(index, inverse_mass_at_rim(body), solver_bodies);
    }
}

}  // namespace fettle::physics::detail
