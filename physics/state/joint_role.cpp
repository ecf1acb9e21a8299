#include <state/joint_role.h>

namespace fettle::physics::detail {

JointRole role_of(const ObjectState& objects, const JointRecord& joint) {
    JointRole role = JointRole::idle;
    for (uint32_t body : joint.bodies) {
        if (!joint.acts() || objects.bodies[body].mobility != Mobility::dynamic) continue;
        if (objects.bodies[body].solver_index != 0) return JointRole::acting;
        role = JointRole::asleep;
    }
    return role;
}

void forget_impulses(ObjectState& objects, uint32_t joint) {
    auto forget = [&](auto& list) { list[objects.joints[joint].place].impulses = {}; };
    with_list(objects.joint_lists, objects.joints[joint].type, forget);
    objects.joints[joint].force = {};
    objects.joints[joint].torque = 0.0f;
}

}  // namespace fettle::physics::detail
