#include <state/active_lists.h>

namespace fettle::physics::detail {

JointRole role_of(const ObjectState& objects, const JointRecord& joint) {
    JointRole role = JointRole::idle;
    for (uint32_t body : joint.bodies) {
        if (!objects.may_act(joint) || objects.bodies[body].mobility != Mobility::dynamic) continue;
        if (objects.bodies[body].solver_index != 0) return JointRole::acting;
        role = JointRole::asleep;
    }
    return role;
}

void clear_impulses(ObjectState& objects, uint32_t joint) {
    JointRecord& record = objects.joints[joint];
    record.impulses = {};
    record.force = {};
    record.torque = 0.0f;
}

void add_awake(ObjectState& objects, ActiveLists& active, uint32_t body) {
    active.awake_bodies.push_back(body);
    objects.bodies[body].solver_index = uint32_t(active.awake_bodies.size());
}

void remove_awake(ObjectState& objects, ActiveLists& active, uint32_t body) {
    const uint32_t place = objects.bodies[body].solver_index - 1;
    active.awake_bodies[place] = active.awake_bodies.back();
    objects.bodies[active.awake_bodies[place]].solver_index = place + 1;
    active.awake_bodies.pop_back();
    objects.bodies[body].solver_index = 0;
}

void add_awake_contact(ObjectState& objects, ActiveLists& active, uint32_t contact) {
    objects.contacts[contact].awake_index = uint32_t(active.awake_contacts.size());
    active.awake_contacts.push_back(contact);
}

void remove_awake_contact(ObjectState& objects, ActiveLists& active, uint32_t contact) {
    const uint32_t place = objects.contacts[contact].awake_index;
    active.awake_contacts[place] = active.awake_contacts.back();
    objects.contacts[active.awake_contacts[place]].awake_index = place;
    active.awake_contacts.pop_back();
    objects.contacts[contact].awake_index = none;
}

void list_joint(ObjectState& objects, ActiveLists& active, uint32_t joint) {
    JointRecord& record = objects.joints[joint];
    auto& list = active.awake_joints[size_t(record.type)];
    const auto [a, b] = record.bodies;
    const bool wanted = objects.may_act(record) && (objects.bodies[a].solver_index != 0 ||
                                                    objects.bodies[b].solver_index != 0);
    if (!wanted && role_of(objects, record) == JointRole::idle) clear_impulses(objects, joint);
    if (wanted == (record.awake_index != none)) return;
    if (wanted) {
        record.awake_index = uint32_t(list.size());
        list.push_back(joint);
        return;
    }
    list[record.awake_index] = list.back();
    objects.joints[list.back()].awake_index = record.awake_index;
    list.pop_back();
    record.awake_index = none;
}

}  // namespace fettle::physics::detail
