// Begin and end of touches, and their events.

#include <contacts/contact_list.h>
#include <contacts/overlaps/crushed_bodies.h>
#include <contacts/reports.h>

#include <algorithm>

namespace fettle::physics::detail {
namespace {

/// The side, 0 or 1, whose body has fewer contacts.
uint32_t shorter_list(const ObjectState& objects, const ContactRecord& c) {
    return objects.bodies[c.body_a].lists.contact_count <
                   objects.bodies[c.body_b].lists.contact_count
               ? 0
               : 1;
}

bool same_pair(const ObjectState& objects, const ContactRecord& c, const ContactRecord& d) {
    const uint32_t a = objects.named_shape(c.shape_a), b = objects.named_shape(c.shape_b);
    const uint32_t e = objects.named_shape(d.shape_a), f = objects.named_shape(d.shape_b);
    // The order of the parts of two outlines may differ.
    return c.sensor == d.sensor && ((a == e && b == f) || (a == f && b == e));
}

/// A contact of two other parts of the same two shapes that touch; `none`: there is none.
uint32_t touching_elsewhere(const ObjectState& objects, uint32_t slot) {
    const ContactRecord& c = objects.contacts[slot];
    const uint32_t side = shorter_list(objects, c);
    const uint32_t body = side == 0 ? c.body_a : c.body_b;
    const ListEdge& own = objects.contact_links[slot].edges[side];
    uint32_t found = none;
    const auto touches = [&](uint32_t other) {
        const ContactRecord& d = objects.contacts[other];
        if (!d.touching || d.skipped != Skipped::no || !same_pair(objects, c, d)) return false;
        found = other;
        return true;
    };
    // The search begins at its own place in the list, because contacts that are created or
    // destroyed together are near each other.
    if (!objects.any_contact(own.next, none, touches))
        objects.any_contact(objects.bodies[body].lists.first_contact, slot, touches);
    return found;
}

/// True if a touch of the two shapes that begins now is reported.
bool are_reported(const ObjectState& objects, uint32_t shape_a, uint32_t shape_b, bool sensor) {
    const ShapeDef& a = objects.shapes[shape_a].surface;
    const ShapeDef& b = objects.shapes[shape_b].surface;
    return sensor ? a.sensor_events && b.sensor_events : a.contact_events && b.contact_events;
}

void report(const Touching& touching, const ContactRecord& c, bool begins) {
    ObjectState& objects = touching.objects;
    const Columns& columns = touching.columns;
    Events& events = touching.events;
    const uint32_t change = begins ? 1u : ~0u;  // ± 1, modulo 2³²
    objects.shapes[objects.named_shape(c.shape_a)].touching += change;
    objects.shapes[objects.named_shape(c.shape_b)].touching += change;
    if (!c.begin_reported) return;
    const ShapeId a = shape_id(objects, columns, c.shape_a);
    const ShapeId b = shape_id(objects, columns, c.shape_b);
    const BodyId body_a = body_id(columns, c.body_a), body_b = body_id(columns, c.body_b);
    if (c.sensor) {
        auto& list = begins ? events.sensor_begin : events.sensor_end;
        if (objects.shapes[c.shape_a].surface.sensor)
            list.push_back({a, b, body_a, body_b});
        else
            list.push_back({b, a, body_b, body_a});
        return;
    }
    if (begins) {
        const Position point = middle_of(objects, c);
        const float speed = meeting_speed(touching, c, point, nearest_separation(c.manifold));
        events.contact_begin.push_back(
            {a, b, body_a, body_b, point, c.manifold.normal, speed, impact_impulse(touching, c),
             c.friction, c.restitution, objects.part_number(c.shape_a),
             objects.part_number(c.shape_b), objects.shapes[c.shape_a].surface.material,
             objects.shapes[c.shape_b].surface.material});
    } else {
        events.contact_end.push_back({a, b, body_a, body_b});
    }
}

bool touches_kinematic(const ObjectState& objects, const ContactRecord& c) {
    return objects.bodies[c.body_a].mobility == Mobility::kinematic ||
           objects.bodies[c.body_b].mobility == Mobility::kinematic;
}

void begin_touch(const Touching& touching, uint32_t slot) {
    ContactRecord& c = touching.objects.contacts[slot];
    touching.objects.contact_links[slot].began = touching.step;
    c.begin_reported = are_reported(touching.objects, c.shape_a, c.shape_b, c.sensor);
}

}  // namespace

bool is_of_outline(const ObjectState& objects, const ContactRecord& c) {
    return objects.forms[c.shape_a].kind == FormKind::piece ||
           objects.forms[c.shape_b].kind == FormKind::piece;
}

void set_touching(const Touching& touching, uint32_t slot, bool begins) {
    ObjectState& objects = touching.objects;
    ContactRecord& c = objects.contacts[slot];
    c.touching = begins;
    if (!c.sensor) {
        objects.bodies[c.body_a].lists.touching += begins ? 1u : ~0u;  // ± 1, modulo 2³²
        objects.bodies[c.body_b].lists.touching += begins ? 1u : ~0u;
        if (!begins && touches_kinematic(objects, c)) release_pressed(objects, c);
    }
    if (!is_of_outline(objects, c)) {
        if (begins) begin_touch(touching, slot);
        report(touching, c, begins);
        return;
    }
    if (const uint32_t other = touching_elsewhere(objects, slot); other != none) {
        c.begin_reported = objects.contacts[other].begin_reported;
        return;
    }
    if (!begins) {
        if (touching.parted != nullptr)
            touching.parted->push_back(c);
        else
            report(touching, c, false);
        return;
    }
    if (touching.parted != nullptr) {
        auto& parted = *touching.parted;
        const auto left = std::find_if(parted.begin(), parted.end(), [&](const ContactRecord& d) {
            return same_pair(objects, c, d);
        });
        if (left != parted.end()) {
            c.begin_reported = left->begin_reported;
            parted.erase(left);  // the touch only moved to another part
            return;
        }
    }
    begin_touch(touching, slot);
    report(touching, c, true);
}

void skip_contact(const Touching& touching, uint32_t contact, Skipped reason) {
    ContactRecord& c = touching.objects.contacts[contact];
    c.skipped = reason;
    if (c.touching) set_touching(touching, contact, false);
    c.clear_impulses();
}

void report_parted(const Touching& touching) {
    for (const ContactRecord& c : *touching.parted) report(touching, c, false);
    touching.parted->clear();
}

void report_crossing(const Touching& touching, Events& later, uint32_t sensor, uint32_t visitor) {
    const ObjectState& objects = touching.objects;
    const Columns& columns = touching.columns;
    if (!are_reported(objects, sensor, visitor, true)) return;
    const SensorEvent event = {shape_id(objects, columns, sensor),
                               shape_id(objects, columns, visitor),
                               body_id(columns, objects.forms[sensor].body),
                               body_id(columns, objects.forms[visitor].body)};
    touching.events.sensor_begin.push_back(event);
    later.sensor_end.push_back(event);
}

bool touch(const ObjectState& objects, uint32_t shape_a, uint32_t shape_b) {
    if (objects.shapes[shape_a].touching == 0 || objects.shapes[shape_b].touching == 0)
        return false;
    const BodyRecord& a = objects.bodies[objects.forms[shape_a].body];
    const BodyRecord& b = objects.bodies[objects.forms[shape_b].body];
    const BodyRecord& shorter = a.lists.contact_count < b.lists.contact_count ? a : b;
    return objects.any_contact(shorter.lists.first_contact, none, [&](uint32_t slot) {
        const ContactRecord& c = objects.contacts[slot];
        const uint32_t e = objects.named_shape(c.shape_a), f = objects.named_shape(c.shape_b);
        return c.touching && ((e == shape_a && f == shape_b) || (e == shape_b && f == shape_a));
    });
}

bool reports_for_pair(const ObjectState& objects, uint32_t slot) {
    const ContactRecord& c = objects.contacts[slot];
    if (!is_of_outline(objects, c)) return true;
    const uint32_t body = shorter_list(objects, c) == 0 ? c.body_a : c.body_b;
    return !objects.any_contact(objects.bodies[body].lists.first_contact, none,
                                [&](uint32_t other) {
                                    const ContactRecord& d = objects.contacts[other];
                                    return other < slot && d.touching && d.skipped == Skipped::no &&
                                           same_pair(objects, c, d);
                                });
}

}  // namespace fettle::physics::detail
