#include <geometry/growth.h>
#include <world/world_data.h>

#include <algorithm>

// Pairs of shapes: kept while their fat boxes overlap, given a manifold each step while one of the
// two bodies is awake.

namespace fettle::physics::detail {

bool WorldData::filters_agree(uint32_t a, uint32_t b) const {
    const uint32_t body_a = forms[a].body, body_b = forms[b].body;
    if (body_a == body_b) return false;
    if (bodies[body_a].mobility != Mobility::dynamic &&
        bodies[body_b].mobility != Mobility::dynamic)
        return false;
    const ShapeDef& sa = shapes[a].surface;
    const ShapeDef& sb = shapes[b].surface;
    if (sa.sensor && (sb.sensor || shapes[b].type == ShapeType::border)) return false;
    if (sb.sensor && shapes[a].type == ShapeType::border) return false;
    if (sa.group != 0 && sa.group == sb.group) return sa.group > 0;
    return (sa.mask & sb.category) != 0 && (sb.mask & sa.category) != 0;
}

bool WorldData::may_collide(uint32_t a, uint32_t b) const {
    return filters_agree(a, b) && !joint_forbids_contact(forms[a].body, forms[b].body) &&
           callback_agrees(a, b);
}

/// A filter that throws says nothing: yes.
bool WorldData::callback_agrees(uint32_t a, uint32_t b) const {
    if (!self.filter) return true;
    bool agrees = true;
    const bool answered = self.ask(in_filter, [&] {
        World* const world = self.link->world;
        agrees = self.filter({world, shape_id(std::min(a, b))}, {world, shape_id(std::max(a, b))});
    });
    return agrees || !answered;
}

namespace {

float mixed(MixRule rule, float a, float b) {
    switch (rule) {
        case MixRule::average:
            return 0.5f * (a + b);
        case MixRule::minimum:
            return min(a, b);
        case MixRule::maximum:
            return max(a, b);
        case MixRule::multiply:
            return a * b;
        default:
            return std::sqrt(a * b);
    }
}

}  // namespace

void WorldData::remix(ContactRecord& c) const {
    const ShapeDef& a = shapes[c.shape_a].surface;
    const ShapeDef& b = shapes[c.shape_b].surface;
    // Bounded as what callbacks answer: two greatest numbers multiplied are none.
    c.friction = bounded(mixed(settings.friction_mix, a.friction, b.friction), greatest_grip);
    c.restitution = mixed(settings.restitution_mix, a.restitution, b.restitution);
    c.rolling_resistance = bounded(max(a.rolling_resistance * forms[c.shape_a].radius,
                                       b.rolling_resistance * forms[c.shape_b].radius),
                                   greatest_grip);
    c.surface_speed = bounded(a.surface_speed + b.surface_speed, greatest_speed);
    c.hit_events = a.hit_events || b.hit_events;
    c.special = c.restitution > 0.0f || c.rolling_resistance > 0.0f || c.surface_speed != 0.0f;
}

void WorldData::remix_shape(uint32_t shape) {
    for_each_contact_of(shape, [&](uint32_t contact) { remix(contacts[contact]); });
}

void WorldData::create_contact(uint32_t shape_a, uint32_t shape_b) {
    uint32_t slot = contact_slots.free;
    if (slot != none) {
        contact_slots.free = contact_links[slot].edges[0].next;
        contacts[slot] = {};
    } else {
        slot = uint32_t(contacts.size());
        make_room_in_each(contacts, contact_links);
        contacts.emplace_back();
        contact_links.emplace_back();
    }
    ++contact_slots.count;
    ContactRecord& c = contacts[slot];
    c.shape_a = shape_a;
    c.shape_b = shape_b;
    c.body_a = forms[shape_a].body;
    c.body_b = forms[shape_b].body;
    c.sensor = shapes[shape_a].surface.sensor || shapes[shape_b].surface.sensor;
    c.curved = forms[shape_a].kind == FormKind::ellipse || forms[shape_b].kind == FormKind::ellipse;
    remix(c);
    const uint32_t owners[2] = {c.body_a, c.body_b};
    for (uint32_t side = 0; side < 2; ++side) {
        BodyRecord& body = bodies[owners[side]];
        const uint32_t edge = slot << 1 | side;
        contact_links[slot].edges[side] = {none, body.first_contact};
        if (body.first_contact != none) {
            contact_links[body.first_contact >> 1].edges[body.first_contact & 1].previous = edge;
        }
        body.first_contact = edge;
        ++body.contact_count;
    }
    pairs.insert(shape_a, shape_b, slot);
    if (bodies[c.body_a].solver_index != 0 || bodies[c.body_b].solver_index != 0)
        add_awake_contact(*this, *this, slot);
}

void WorldData::destroy_contact(uint32_t slot) {
    ContactRecord& c = contacts[slot];
    if (c.touching) set_touching(touching(), slot, false);
    if (c.awake_index != none) remove_awake_contact(*this, *this, slot);
    const uint32_t owners[2] = {c.body_a, c.body_b};
    for (uint32_t side = 0; side < 2; ++side) {
        BodyRecord& body = bodies[owners[side]];
        const ListEdge edge = contact_links[slot].edges[side];
        if (edge.previous != none)
            contact_links[edge.previous >> 1].edges[edge.previous & 1].next = edge.next;
        else
            body.first_contact = edge.next;
        if (edge.next != none)
            contact_links[edge.next >> 1].edges[edge.next & 1].previous = edge.previous;
        --body.contact_count;
    }
    pairs.erase(c.shape_a, c.shape_b);
    c = {};
    contact_links[slot].edges[0].next = contact_slots.free;
    contact_slots.free = slot;
    --contact_slots.count;
}

void WorldData::destroy_contacts_of_shape(uint32_t shape) {
    for_each_contact_of(shape, [&](uint32_t contact) { destroy_contact(contact); });
}

void WorldData::destroy_contacts_of_body(uint32_t body) {
    for_each_contact(body, [&](uint32_t contact) { destroy_contact(contact); });
}

void WorldData::refilter(uint32_t shape) {
    const uint32_t body = forms[shape].body;
    if (body == none) return;
    wake_for_edit(body);
    for_each_contact_of(shape, [&](uint32_t contact) {
        const ContactRecord& c = contacts[contact];
        const bool sensor = shapes[c.shape_a].surface.sensor || shapes[c.shape_b].surface.sensor;
        if (c.sensor != sensor || !may_collide(c.shape_a, c.shape_b)) destroy_contact(contact);
    });
    for_each_solid(shape, [&](uint32_t solid) { mark_moved(solid); });
}

Contact WorldData::view(const ContactRecord& c) const {
    Contact contact;
    contact.body_a = body_id(c.body_a);
    contact.body_b = body_id(c.body_b);
    contact.shape_a = shape_id(c.shape_a);
    contact.shape_b = shape_id(c.shape_b);
    contact.normal = to_vec2(c.manifold.normal);
    contact.point_count = c.manifold.count;
    contact.friction = c.friction;
    contact.restitution = c.restitution;
    // The point as each body carries it: a point of the ground stays behind when a body slides on.
    const BodyRecord &a = bodies[c.body_a], &b = bodies[c.body_b];
    const bool a_moves = a.mobility != Mobility::fixed, b_moves = b.mobility != Mobility::fixed;
    const float share_a = a_moves == b_moves ? 0.5f : a_moves ? 1.0f : 0.0f;
    for (int k = 0; k < c.manifold.count; ++k) {
        const ManifoldPoint& p = c.manifold.points[k];
        const V2 on_a = a.center + p.anchor_a, on_b = b.center + p.anchor_b;
        contact.points[size_t(k)] = {to_vec2(on_b + share_a * (on_a - on_b)), p.separation,
                                     p.normal_impulse, p.tangent_impulse, uint16_t(p.feature)};
        if (last_substep > 0.0f) contact.normal_force += p.normal_impulse / last_substep;
    }
    return contact;
}

}  // namespace fettle::physics::detail
