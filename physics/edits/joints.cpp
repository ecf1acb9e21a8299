#include <edits/edits.h>
#include <state/active_lists.h>

#include <utility>

// A joint has a slot, which is linked into the lists of both bodies. Joints with an awake body are
// also listed by type.

namespace fettle::physics::detail {
namespace {

void link_joint(ObjectState& objects, uint32_t joint, uint32_t side) {
    BodyRecord& body = objects.bodies[objects.joints[joint].bodies[side]];
    link_edge(body.lists.first_joint, joint << 1 | side,
              [&](uint32_t edge) -> ListEdge& { return objects.joint_edge(edge); });
    ++body.lists.joint_count;
}

void unlink_joint(ObjectState& objects, uint32_t joint, uint32_t side) {
    BodyRecord& body = objects.bodies[objects.joints[joint].bodies[side]];
    unlink_edge(body.lists.first_joint, joint << 1 | side,
                [&](uint32_t edge) -> ListEdge& { return objects.joint_edge(edge); });
    --body.lists.joint_count;
}

/// Called after an edit: contacts between the two bodies end, or their pairs are searched.
void refilter_joint(const Editing& e, uint32_t joint) {
    ObjectState& objects = e.objects;
    uint32_t a = objects.joints[joint].bodies[0], b = objects.joints[joint].bodies[1];
    if (a == 0 || b == 0) return;
    if (objects.bodies[a].lists.contact_count > objects.bodies[b].lists.contact_count)
        std::swap(a, b);
    if (joint_forbids_contact(objects, a, b)) {
        objects.for_each_contact(a, [&](uint32_t contact) {
            if (objects.other_body(contact, a) == b) destroy_contact(e.contacts, contact);
        });
        return;
    }
    for (uint32_t body : {a, b}) {
        for (uint32_t s = objects.bodies[body].lists.first_shape; s != none;
             s = objects.shapes[s].next)
            mark_moved(objects, e.broad_phase, s);
    }
}

/// Must be called after an edit that may change the effect of the joint.
void update_joint(const Editing& e, uint32_t joint) {
    edit_joint(e.activity, joint);
    list_joint(e.objects, e.active, joint);
    refilter_joint(e, joint);
}

}  // namespace

void edit_joint(const Activity& activity, uint32_t joint) {
    wake_joint(activity, joint);
    for (const uint32_t body : activity.objects.joints[joint].bodies)
        mark_joints(activity.objects, activity.active, body);
}

uint32_t create_joint(const Editing& e, const JointRecord& record) {
    const uint32_t slot =
        e.objects.joint_slots.allocate(e.objects.joints, e.columns.joint_generations);
    e.objects.joints[slot] = record;
    e.columns.joint_generations[slot] = e.generations.create();
    link_joint(e.objects, slot, 0);
    link_joint(e.objects, slot, 1);
    e.objects.dormant_joints += record.dormant();
    update_joint(e, slot);
    return slot;
}

void destroy_joint(const Editing& e, uint32_t joint) {
    edit_joint(e.activity, joint);
    e.objects.joints[joint].enabled = false;
    list_joint(e.objects, e.active, joint);
    refilter_joint(e, joint);
    unlink_joint(e.objects, joint, 0);
    unlink_joint(e.objects, joint, 1);
    e.objects.dormant_joints -= e.objects.joints[joint].dormant();
    e.objects.joint_slots.release(e.objects.joints, joint);
    e.columns.joint_generations[joint] = 0;
}

void set_joint_bodies(const Editing& e, uint32_t joint, uint32_t a, uint32_t b) {
    JointRecord& record = e.objects.joints[joint];
    edit_joint(e.activity, joint);
    const bool enabled = std::exchange(record.enabled, false);
    refilter_joint(e, joint);  // the two bodies may collide now
    e.objects.dormant_joints -= record.dormant();
    for (const uint32_t side : {0, 1}) {
        const uint32_t body = side == 0 ? a : b;
        if (record.bodies[side] == body) continue;
        unlink_joint(e.objects, joint, side);
        record.bodies[side] = body;
        link_joint(e.objects, joint, side);
    }
    e.objects.dormant_joints += record.dormant();
    record.enabled = enabled;
    clear_impulses(e.objects, joint);
    update_joint(e, joint);
}

void set_joint_enabled(const Editing& e, uint32_t joint, bool enabled) {
    e.objects.joints[joint].enabled = enabled;
    update_joint(e, joint);
}

void set_joint_broken(const Editing& e, uint32_t joint, bool broken) {
    e.objects.joints[joint].broken = broken;
    update_joint(e, joint);
}

void set_joint_collide(const Editing& e, uint32_t joint, bool collide) {
    e.objects.joints[joint].collide = collide;
    edit_joint(e.activity, joint);
    refilter_joint(e, joint);
}

}  // namespace fettle::physics::detail
