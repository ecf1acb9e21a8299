#include <solver/contacts/lanes_of_rows.h>

namespace fettle::physics::detail {
namespace {

ConstraintPoint point_of_lane(const WidePoint& p, int lane) {
    return {p.normal_lever_a[lane],  p.normal_lever_b[lane], p.tangent_lever_a[lane],
            p.tangent_lever_b[lane], p.separation[lane],     p.normal_mass[lane],
            p.tangent_mass[lane],    p.normal_impulse[lane], p.tangent_impulse[lane]};
}

/// A point without mass stays without impulse, so the number of points makes no difference.
ContactConstraint constraint_of_lane(const WideContact& c, int lane,
                                     std::span<const SolverBody> bodies) {
    ContactConstraint to = {};
    to.a = c.a[lane];
    to.b = c.b[lane];
    to.normal = {c.normal_x[lane], c.normal_y[lane]};
    to.friction = c.friction[lane];
    to.count = 2;
    to.coupling_normal = c.coupling_normal[lane];
    to.coupling_tangent = c.coupling_tangent[lane];
    const float inverse_a = bodies[to.a].inverse_mass, inverse_b = bodies[to.b].inverse_mass;
    to.inverse_a = {inverse_a, inverse_a};
    to.inverse_b = {inverse_b, inverse_b};
    for (int k = 0; k < 2; ++k) to.points[k] = point_of_lane(c.points[k], lane);
    return to;
}

}  // namespace

void list_lanes_of_rows(const SolverBlock& block, WideBlock& wide,
                        std::span<const SolverBody> bodies, UnsettledScratch& rows) {
    rows.lanes.clear();
    for (uint32_t group = block.first_group; group < block.group_end; ++group) {
        const WideContact& c = *wide.contacts_of(group);
        for (int lane = 0; lane < group_size && c.a[lane] != c.b[lane]; ++lane) {
            if (!rows.contacts.are_in_row(c.a[lane], c.b[lane])) continue;
            rows.contacts.count(bodies, c.a[lane], c.b[lane]);
            rows.lanes.push_back(group * group_size + uint32_t(lane));
        }
    }
}

void copy_lanes_of_rows(WideBlock& wide, std::span<const SolverBody> bodies,
                        UnsettledScratch& rows) {
    const auto contact_of = [&](uint32_t lane) -> const WideContact& {
        return *wide.contacts_of(lane / group_size);
    };
    std::erase_if(rows.lanes, [&](uint32_t lane) {
        const WideContact& c = contact_of(lane);
        return !rows.contacts.are_in_row(c.a[lane % group_size], c.b[lane % group_size]);
    });
    rows.constraints.clear();
    for (const uint32_t lane : rows.lanes)
        rows.constraints.push_back(
            constraint_of_lane(contact_of(lane), int(lane % group_size), bodies));
    rows.relaxed.assign(rows.lanes.size(), Relaxed::settled);
}

void write_lanes_of_rows(const UnsettledScratch& rows, WideBlock& wide) {
    for (size_t i = 0; i < rows.lanes.size(); ++i) {
        const uint32_t group = rows.lanes[i] / group_size, lane = rows.lanes[i] % group_size;
        const ContactConstraint& from = rows.constraints[i];
        for (int k = 0; k < 2; ++k) {
            WidePoint& to = wide.contacts_of(group)->points[k];
            to.normal_impulse[lane] = from.points[k].normal_impulse;
            to.tangent_impulse[lane] = from.points[k].tangent_impulse;
        }
        *wide.pushed_of(group) |= uint32_t{from.pushed} << lane;
    }
}

}  // namespace fettle::physics::detail
