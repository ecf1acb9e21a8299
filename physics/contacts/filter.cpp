// Filters: which pairs of shapes may collide.

#include <contacts/contact_list.h>

#include <utility>

namespace fettle::physics::detail {

bool filters_agree(const ObjectState& objects, uint32_t a, uint32_t b) {
    const uint32_t body_a = objects.forms[a].body, body_b = objects.forms[b].body;
    if (body_a == body_b) return false;
    const Mobility mobility_a = objects.bodies[body_a].mobility;
    const Mobility mobility_b = objects.bodies[body_b].mobility;
    const ShapeDef& sa = objects.shapes[a].surface;
    const ShapeDef& sb = objects.shapes[b].surface;
    // Nothing pushes a kinematic body, but it enters sensors.
    if (mobility_a != Mobility::dynamic && mobility_b != Mobility::dynamic &&
        !(sa.sensor && mobility_b == Mobility::kinematic) &&
        !(sb.sensor && mobility_a == Mobility::kinematic))
        return false;
    if (sa.sensor && (sb.sensor || objects.shapes[b].type == ShapeType::border)) return false;
    if (sb.sensor && objects.shapes[a].type == ShapeType::border) return false;
    if (sa.group != 0 && sa.group == sb.group) return sa.group > 0;
    return (sa.mask & sb.category) != 0 && (sb.mask & sa.category) != 0;
}

bool keeps_apart(const JointRecord& joint) {
    return joint.acts() && !joint.collide && joint.bodies[0] != 0 && joint.bodies[1] != 0;
}

bool joint_forbids_contact(const ObjectState& objects, uint32_t body_a, uint32_t body_b) {
    const std::vector<BodyRecord>& bodies = objects.bodies;
    if (bodies[body_a].lists.joint_count > bodies[body_b].lists.joint_count)
        std::swap(body_a, body_b);
    for (uint32_t edge = bodies[body_a].lists.first_joint; edge != none;) {
        const JointRecord& joint = objects.joints[edge >> 1];
        if (joint.bodies[~edge & 1] == body_b && keeps_apart(joint)) return true;
        edge = joint.edges[edge & 1].next;
    }
    return false;
}

bool may_collide(const ObjectState& objects, const UserFilter& filter, uint32_t a, uint32_t b) {
    return filters_agree(objects, a, b) &&
           !joint_forbids_contact(objects, objects.forms[a].body, objects.forms[b].body) &&
           filter(a, b);
}

}  // namespace fettle::physics::detail
