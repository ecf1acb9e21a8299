#include <world/world_data.h>

#include <utility>

// Joints: what all of them have in slots, linked into lists of both bodies, and what a type adds in
// a list of that type without gaps. Those that act on something awake are listed by type.

namespace fettle::physics::detail {
uint32_t WorldData::add_joint(const JointRecord& record, JointType type, uint32_t place) {
    uint32_t slot = joint_slots.free;
    if (slot != none) {
        joint_slots.free = joints[slot].next_free;
    } else {
        slot = uint32_t(joints.size());
        joints.emplace_back();
        joint_generations.push_back(0);
    }
    joints[slot] = record;
    joints[slot].type = type;
    joints[slot].place = place;
    joint_generations[slot] = new_generation();
    ++joint_slots.count;
    link_joint(slot, 0);
    link_joint(slot, 1);
    wake_joint(activity(), slot);
    list_joint(*this, *this, slot);
    refilter_joint(slot);
    return slot;
}

void WorldData::destroy_joint(uint32_t joint) {
    wake_joint(activity(), joint);
    joints[joint].enabled = false;
    list_joint(*this, *this, joint);
    refilter_joint(joint);
    unlink_joint(joint, 0);
    unlink_joint(joint, 1);
    const uint32_t place = joints[joint].place;
    auto erase = [&](auto& list) {
        list[place] = list.back();
        joints[list[place].joint].place = place;
        list.pop_back();
    };
    with_list(joint_lists, joints[joint].type, erase);
    joints[joint] = {};
    joints[joint].next_free = joint_slots.free;
    joint_slots.free = joint;
    joint_generations[joint] = 0;
    --joint_slots.count;
}

void WorldData::link_joint(uint32_t joint, uint32_t side) {
    JointRecord& record = joints[joint];
    BodyRecord& body = bodies[record.bodies[side]];
    record.edges[side] = {none, body.first_joint};
    if (body.first_joint != none)
        joints[body.first_joint >> 1].edges[body.first_joint & 1].previous = joint << 1 | side;
    body.first_joint = joint << 1 | side;
    ++body.joint_count;
}

void WorldData::unlink_joint(uint32_t joint, uint32_t side) {
    BodyRecord& body = bodies[joints[joint].bodies[side]];
    const ListEdge edge = joints[joint].edges[side];
    if (edge.previous != none)
        joints[edge.previous >> 1].edges[edge.previous & 1].next = edge.next;
    else
        body.first_joint = edge.next;
    if (edge.next != none) joints[edge.next >> 1].edges[edge.next & 1].previous = edge.previous;
    --body.joint_count;
}

void WorldData::set_joint_body(uint32_t joint, uint32_t side, uint32_t body) {
    wake_joint(activity(), joint);
    const bool enabled = std::exchange(joints[joint].enabled, false);
    refilter_joint(joint);  // those who part may collide
    unlink_joint(joint, side);
    joints[joint].bodies[side] = body;
    link_joint(joint, side);
    joints[joint].enabled = enabled;
    forget_impulses(*this, joint);
    wake_joint(activity(), joint);
    list_joint(*this, *this, joint);
    refilter_joint(joint);
}

void WorldData::set_joint_enabled(uint32_t joint, bool enabled) {
    joints[joint].enabled = enabled;
    wake_joint(activity(), joint);
    list_joint(*this, *this, joint);
    refilter_joint(joint);
}

void WorldData::set_joint_broken(uint32_t joint, bool broken) {
    joints[joint].broken = broken;
    wake_joint(activity(), joint);
    list_joint(*this, *this, joint);
    refilter_joint(joint);
}

/// Breaks the joints that bore more than they can, as the mean over the step.
void WorldData::break_joints(const JointStep& step) {
    const float rate = step.inverse_h / float(settings.substeps);
    for (const Strain& strain : strains) {
        const JointRecord& joint = joints[strain.joint];
        const V2 force = rate * strain.force;
        const float torque = rate * strain.torque;
        if (length(force) <= joint.break_force && std::fabs(torque) <= joint.break_torque) continue;
        const auto [a, b] = joint.bodies;
        event_sink().joint_broke.push_back({{strain.joint, joint_generations[strain.joint]},
                                            body_id(a),
                                            body_id(b),
                                            to_vec2(force),
                                            torque});
        set_joint_broken(strain.joint, true);
    }
}

void WorldData::set_joint_collide(uint32_t joint, bool collide) {
    joints[joint].collide = collide;
    wake_joint(activity(), joint);
    refilter_joint(joint);
}

/// After an edit: contacts between the two bodies end, or are looked for.
void WorldData::refilter_joint(uint32_t joint) {
    uint32_t a = joints[joint].bodies[0], b = joints[joint].bodies[1];
    if (bodies[a].contact_count > bodies[b].contact_count) std::swap(a, b);
    if (joint_forbids_contact(*this, a, b)) {
        for_each_contact(a, [&](uint32_t contact) {
            if (other_body(contact, a) == b) destroy_contact(contact_list(), contact);
        });
        return;
    }
    if (a == 0 || b == 0) return;
    for (uint32_t body : {a, b}) {
        for (uint32_t s = bodies[body].first_shape; s != none; s = shapes[s].next) mark_moved(s);
    }
}

}  // namespace fettle::physics::detail
