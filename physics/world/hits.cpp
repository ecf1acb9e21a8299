#include <world/world_data.h>

#include <bit>

// Hits: who met whom faster than the threshold, with what impulse. Whoever listens has every
// touching contact looked at in every step, so several threads look; the events are then put one
// after the other in the order of the contacts.

namespace fettle::physics::detail {
namespace {

/// Of 64 contacts each, that a thread takes at a time.
constexpr size_t words_at_a_time = 8;

}  // namespace

/// From what is known anyway: that somebody wants to hear of hits must change nothing.
std::optional<ContactHitEvent> WorldData::hit_of(uint32_t contact,
                                                 const ContactExtra* extra) const {
    const ContactRecord& record = contacts[contact];
    if (!record.hit_events || !record.touching) return {};
    float speed = 0.0f;
    V2 point;
    for (int k = 0; k < record.manifold.count; ++k) {
        const ManifoldPoint& p = record.manifold.points[k];
        const bool met = p.normal_impulse > 0.0f || p.separation <= touch_distance ||
                         (extra != nullptr && extra->greatest[k] > 0.0f);
        const V2 here = bodies[record.body_a].center + p.anchor_a;
        const float approach = met ? approach_speed(record, here) : 0.0f;
        if (approach <= speed) continue;
        speed = approach;
        point = here;
    }
    if (!(speed > settings.hit_threshold) || !tells_for_pair(contact)) return {};
    const float impulse =
        extra != nullptr ? extra->total[0] + extra->total[1] : speed * impact_mass(record, point);
    return ContactHitEvent{shape_id(record.shape_a),
                           shape_id(record.shape_b),
                           body_id(record.body_a),
                           body_id(record.body_b),
                           to_vec2(point),
                           to_vec2(record.manifold.normal),
                           speed,
                           impulse,
                           record.friction,
                           record.restitution};
}

/// Of the wide contacts that are told of.
void WorldData::tell_hits() {
    const auto visit = [&](size_t begin, size_t end, auto&& act) {
        for (size_t word = begin; word < end; ++word) {
            for (uint64_t left = told[word]; left != 0; left &= left - 1)
                act(acting[word * 64 + size_t(std::countr_zero(left))]);
        }
    };
    hits.resize((told.size() + words_at_a_time - 1) / words_at_a_time);
    share_out_range(threads, told.size(), words_at_a_time, [&](size_t begin, size_t end) {
        auto& found = hits[begin / words_at_a_time];
        found.clear();
        visit(begin, end, [&](const ActingContact& c) { contacts[c.slot].prefetch(); });
        visit(begin, end, [&](const ActingContact& c) {
            if (!c.hit_events()) return;
            if (const auto hit = hit_of(c.slot, nullptr)) found.push_back(*hit);
        });
    });
    for (const auto& found : hits)
        events.contact_hit.insert(events.contact_hit.end(), found.begin(), found.end());
}

}  // namespace fettle::physics::detail
