#include <contacts/contact_list.h>
#include <contacts/mixing.h>
#include <geometry/make_room.h>
#include <state/active_lists.h>

namespace fettle::physics::detail {

void count_contact(ObjectState& objects, uint32_t shape_a, uint32_t shape_b) {
    for (const uint32_t shape : {shape_a, shape_b})
        ++objects.bodies[objects.forms[shape].body].lists.contact_count;
}

void create_contact(const ContactList& list, const WorldDef& settings, uint32_t shape_a,
                    uint32_t shape_b) {
    ObjectState& objects = list.touching.objects;
    const uint32_t slot = objects.contact_slots.allocate(objects.contact_links, objects.contacts,
                                                         objects.manifold_poses);
    ContactRecord& c = objects.contacts[slot];
    c.shape_a = shape_a;
    c.shape_b = shape_b;
    c.body_a = objects.forms[shape_a].body;
    c.body_b = objects.forms[shape_b].body;
    c.sensor = objects.shapes[shape_a].surface.sensor || objects.shapes[shape_b].surface.sensor;
    c.curved = objects.forms[shape_a].kind == FormKind::ellipse ||
               objects.forms[shape_b].kind == FormKind::ellipse;
    remix(objects, settings, c);
    for (uint32_t side = 0; side < 2; ++side) {
        BodyRecord& body = objects.bodies[side == 0 ? c.body_a : c.body_b];
        link_edge(body.lists.first_contact, slot << 1 | side,
                  [&](uint32_t edge) -> ListEdge& { return objects.contact_edge(edge); });
    }
    list.pairs.insert(shape_a, shape_b, slot);
    if (objects.bodies[c.body_a].solver_index != 0 || objects.bodies[c.body_b].solver_index != 0)
        add_awake_contact(objects, list.active, slot);
}

void destroy_contact(const ContactList& list, uint32_t slot) {
    ObjectState& objects = list.touching.objects;
    ContactRecord& c = objects.contacts[slot];
    if (c.touching) set_touching(list.touching, slot, false);
    if (c.awake_index != none) remove_awake_contact(objects, list.active, slot);
    for (uint32_t side = 0; side < 2; ++side) {
        BodyRecord& body = objects.bodies[side == 0 ? c.body_a : c.body_b];
        unlink_edge(body.lists.first_contact, slot << 1 | side,
                    [&](uint32_t edge) -> ListEdge& { return objects.contact_edge(edge); });
        --body.lists.contact_count;
    }
    list.pairs.erase(c.shape_a, c.shape_b);
    c = {};
    objects.contact_slots.release(objects.contact_links, slot);
}

void destroy_contacts_of_shape(const ContactList& list, uint32_t shape) {
    list.touching.objects.for_each_contact_of(
        shape, [&](uint32_t contact) { destroy_contact(list, contact); });
}

void destroy_contacts_of_body(const ContactList& list, uint32_t body) {
    list.touching.objects.for_each_contact(
        body, [&](uint32_t contact) { destroy_contact(list, contact); });
}

}  // namespace fettle::physics::detail
