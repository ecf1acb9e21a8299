#include <world/world_data.h>

#include <algorithm>

// When shapes begin and end to touch, and who hears of it. A chain or a concave polygon touches as
// one: who goes on from one of its parts to the next neither leaves nor arrives.

namespace fettle::physics::detail {

bool WorldData::of_outline(const ContactRecord& c) const {
    return forms[c.shape_a].kind == FormKind::piece || forms[c.shape_b].kind == FormKind::piece;
}

bool WorldData::same_pair(const ContactRecord& c, const ContactRecord& d) const {
    const uint32_t a = named_shape(c.shape_a), b = named_shape(c.shape_b);
    const uint32_t e = named_shape(d.shape_a), f = named_shape(d.shape_b);
    // Parts of two outlines are in any order.
    return c.sensor == d.sensor && ((a == e && b == f) || (a == f && b == e));
}

/// Whether the two shapes touch in another pair of parts.
bool WorldData::touch_elsewhere(uint32_t slot) const {
    const ContactRecord& c = contacts[slot];
    const bool fewer = bodies[c.body_a].contact_count < bodies[c.body_b].contact_count;
    const uint32_t body = fewer ? c.body_a : c.body_b;
    const ListEdge& own = contact_links[slot].edges[fewer ? 0 : 1];
    const auto touches = [&](uint32_t other) {
        const ContactRecord& d = contacts[other];
        return d.touching && !d.disabled && same_pair(c, d);
    };
    // From its own place on: those made beside it began, and are destroyed, beside it as well.
    return any_contact(own.next, none, touches) ||
           any_contact(bodies[body].first_contact, slot, touches);
}

void WorldData::set_touching(uint32_t slot, bool touching) {
    ContactRecord& c = contacts[slot];
    c.touching = touching;
    if (!c.sensor) {
        bodies[c.body_a].touching += touching ? 1u : ~0u;  // ± 1, modulo 2³²
        bodies[c.body_b].touching += touching ? 1u : ~0u;
    }
    if (!of_outline(c)) {
        if (touching) contact_links[slot].began = uint32_t(steps);
        tell_touching(c, touching);
        return;
    }
    if (touch_elsewhere(slot)) return;
    if (!touching) {
        if (stepping)
            parted.push_back(c);
        else
            tell_touching(c, false);
        return;
    }
    const auto gone = std::find_if(parted.begin(), parted.end(),
                                   [&](const ContactRecord& d) { return same_pair(c, d); });
    if (gone != parted.end()) {
        parted.erase(gone);  // only gone on to another part
        return;
    }
    contact_links[slot].began = uint32_t(steps);
    tell_touching(c, true);
}

/// Those that left a part in this step and came to no other.
void WorldData::tell_parted() {
    for (const ContactRecord& c : parted) tell_touching(c, false);
    parted.clear();
}

void WorldData::tell_touching(const ContactRecord& c, bool touching) {
    const uint32_t step = touching ? 1u : ~0u;
    shapes[named_shape(c.shape_a)].touching += step;
    shapes[named_shape(c.shape_b)].touching += step;
    const ShapeId a = shape_id(c.shape_a), b = shape_id(c.shape_b);
    const BodyId body_a = body_id(c.body_a), body_b = body_id(c.body_b);
    Events& sink = event_sink();
    if (c.sensor) {
        auto& list = touching ? sink.sensor_begin : sink.sensor_end;
        if (shapes[c.shape_a].surface.sensor)
            list.push_back({a, b, body_a, body_b});
        else
            list.push_back({b, a, body_b, body_a});
        return;
    }
    if (touching) {
        const V2 point = middle_of(c);
        const float speed = approach_speed(c, point);
        sink.contact_begin.push_back({a, b, body_a, body_b, to_vec2(point),
                                      to_vec2(c.manifold.normal), speed,
                                      speed * impact_mass(c, point), c.friction, c.restitution});
    } else {
        sink.contact_end.push_back({a, b, body_a, body_b});
    }
}

/// Once for two shapes, however many parts of them touch.
bool WorldData::tells_for_pair(uint32_t slot) const {
    const ContactRecord& c = contacts[slot];
    if (!of_outline(c)) return true;
    const bool fewer = bodies[c.body_a].contact_count < bodies[c.body_b].contact_count;
    const uint32_t body = fewer ? c.body_a : c.body_b;
    return !any_contact(bodies[body].first_contact, none, [&](uint32_t other) {
        const ContactRecord& d = contacts[other];
        return other < slot && d.touching && !d.disabled && same_pair(c, d);
    });
}

}  // namespace fettle::physics::detail
