#include <world/world_data.h>

#include <bit>

// Between the records and the solver: which contacts act and how they are solved, and what came of
// it.

namespace fettle::physics::detail {
namespace {

/// A path that bends by less in a step is straight, m.
constexpr float negligible_bend = 5e-5f;

}  // namespace

/// The cores are half a radius and a bit away from the anchors, along the normal.
Corner WorldData::corner_of(const ContactRecord& record) const {
    const Manifold& m = record.manifold;
    const ManifoldPoint& point = m.points[0];
    const V2 t = right_perp(m.normal);
    const float half_gap = 0.5f * point.separation;
    return {m.corner, cross(point.anchor_a, t) + forms[record.shape_a].radius + half_gap,
            cross(point.anchor_b, t) - forms[record.shape_b].radius - half_gap};
}

/// Passing a corner so fast that the bend of the way shows within the step. Two circles do without:
/// they meet in piles, where all move slowly. So do bare corners: they have no way round.
bool WorldData::passes_corner(const ContactRecord& record, float dt) const {
    const Manifold& m = record.manifold;
    if (m.corner == 0.0f) return false;
    const ShapeForm &form_a = forms[record.shape_a], &form_b = forms[record.shape_b];
    if (form_a.count == 1 && form_b.count == 1) return false;
    if (form_a.radius + form_b.radius == 0.0f) return false;
    const Corner corner = corner_of(record);
    const SolverBody& a = solver_bodies[solver_ends[record.body_a].index()];
    const SolverBody& b = solver_bodies[solver_ends[record.body_b].index()];
    const float u =
        dt * (dot(right_perp(m.normal), b.velocity - a.velocity) +
              corner.lever_b * b.angular_velocity - corner.lever_a * a.angular_velocity);
    return u * u > 2.0f * corner.distance * negligible_bend;
}

/// Of a body that is locked along one axis. Most worlds have none: their records are not touched.
bool WorldData::on_locked_axis(const ContactRecord& contact) const {
    if (!axes_locked) return false;
    const BodyRecord &a = bodies[contact.body_a], &b = bodies[contact.body_b];
    return a.locked_x || a.locked_y || b.locked_x || b.locked_y;
}

void WorldData::prepare_contacts(float dt, float h, const ContactStiffness& stiffness) {
    find_acting(dt);
    color_contacts();
    const float ratio = last_substep > 0.0f ? h / last_substep : 1.0f;
    prepare_serial(dt, ratio, stiffness);
}

/// What came of the wide contacts is told in the order of the records, not of the colors.
void WorldData::tell_of_groups() {
    told.assign((acting.size() + 63) / 64, 0);
    for (size_t group = 0; group < news.size(); ++group) {
        for (uint32_t left = news[group].told; left != 0; left &= left - 1) {
            const uint32_t i = lane_contacts[group * lanes + size_t(std::countr_zero(left))];
            told[i / 64] |= uint64_t{1} << i % 64;
        }
    }
    bool any_hits = false;
    for (size_t word = 0; word < told.size(); ++word) {
        for (uint64_t left = told[word]; left != 0; left &= left - 1) {
            const ActingContact& c = acting[word * 64 + size_t(std::countr_zero(left))];
            const bool touching = (news[c.place / lanes].touches >> c.place % lanes & 1) != 0;
            if (touching != c.touching()) set_touching(c.slot, touching);
            any_hits |= c.hit_events();
        }
    }
    if (any_hits) tell_hits();
}

void WorldData::store_contacts() {
    tell_of_groups();
    store_serial();
}

}  // namespace fettle::physics::detail
