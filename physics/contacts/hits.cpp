#include <contacts/hits.h>
#include <contacts/impact.h>
#include <contacts/touching.h>
#include <state/limits.h>

#include <bit>

// Where shapes ask for hit events, every touching contact is looked at in every step, so several
// threads look. The events are then put into the order of the contacts.

namespace fettle::physics::detail {
namespace {

/// Words of 64 contacts each, that a thread takes at a time.
constexpr size_t words_at_a_time = 8;

}  // namespace

std::optional<ContactHitEvent> hit_of(const ObjectState& objects, const Columns& columns,
                                      float threshold, uint32_t contact,
                                      const ContactExtra* extra) {
    const ContactRecord& record = objects.contacts[contact];
    if (!record.hit_events || !record.touching) return {};
    float speed = 0.0f;
    V2 point;
    for (int k = 0; k < record.manifold.count; ++k) {
        const ManifoldPoint& p = record.manifold.points[k];
        const bool met = p.normal_impulse > 0.0f || p.separation <= touch_distance ||
                         (extra != nullptr && extra->greatest[k] > 0.0f);
        const V2 here = objects.bodies[record.body_a].center + p.anchor_a;
        const float approach = met ? approach_speed(objects, columns, record, here) : 0.0f;
        if (approach <= speed) continue;
        speed = approach;
        point = here;
    }
    if (!(speed > threshold) || !reports_for_pair(objects, contact)) return {};
    const float impulse = extra != nullptr ? extra->total[0] + extra->total[1]
                                           : speed * impact_mass(objects, record, point);
    return ContactHitEvent{shape_id(objects, columns, record.shape_a),
                           shape_id(objects, columns, record.shape_b),
                           body_id(columns, record.body_a),
                           body_id(columns, record.body_b),
                           to_vec2(point),
                           to_vec2(record.manifold.normal),
                           speed,
                           impulse,
                           record.friction,
                           record.restitution};
}

void report_wide_hits(const ObjectState& objects, const Columns& columns, float threshold,
                      ContactScratch& scratch, ThreadPool* threads, Events& events) {
    const std::vector<uint64_t>& told = scratch.told;
    const auto visit = [&](size_t begin, size_t end, auto&& act) {
        for (size_t word = begin; word < end; ++word) {
            for (uint64_t left = told[word]; left != 0; left &= left - 1)
                act(scratch.acting[word * 64 + size_t(std::countr_zero(left))]);
        }
    };
    scratch.hits.resize((told.size() + words_at_a_time - 1) / words_at_a_time);
    share_out_range(threads, told.size(), words_at_a_time, [&](size_t begin, size_t end) {
        auto& found = scratch.hits[begin / words_at_a_time];
        found.clear();
        visit(begin, end, [&](const ActingContact& c) { objects.contacts[c.slot].prefetch(); });
        visit(begin, end, [&](const ActingContact& c) {
            if (!c.hit_events()) return;
            if (const auto hit = hit_of(objects, columns, threshold, c.slot, nullptr))
                found.push_back(*hit);
        });
    });
    for (const auto& found : scratch.hits)
        events.contact_hit.insert(events.contact_hit.end(), found.begin(), found.end());
}

}  // namespace fettle::physics::detail
