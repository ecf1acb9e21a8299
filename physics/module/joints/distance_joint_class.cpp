// DistanceJoint: a rod, a rope or a spring.

#include <joints/joint_bindings.h>

namespace fettle::physics_module {

void define_distance_joint(Hosting& hosting) {
    using physics::DistanceJoint;
    using physics::JointType;
    constexpr auto length_now = [](Hosting& h, Row row) {
        return (h.joints.world_anchor(row, 1) - h.joints.world_anchor(row, 0)).length();
    };
    property::ClassDescriptor distance = pair_joint<JointType::distance>(
        hosting, "DistanceJoint", "distance_joint",
        "Keeps two points at a distance: a rod; with a finite hertz a spring; with hertz 0 and a "
        "max_length a rope.",
        {
            measured_number(
                "length", "m",
                "Length of the rod, or of the spring at rest. Unless it is set, the distance "
                "when the joint began to act.",
                measured_setting<JointType::distance, &DistanceJoint::length,
                                 &DistanceJoint::set_length, length_now>(hosting)),
            amount("min_length", 0, "m", "Smallest distance of the anchors.",
                   setting<&DistanceJoint::min_length, &DistanceJoint::set_min_length>(hosting)),
            amount("max_length", physics::infinity, "m",
                   "Largest distance of the anchors. If min_length is larger, both are this "
                   "distance.",
                   setting<&DistanceJoint::max_length, &DistanceJoint::set_max_length>(hosting)),
            amount("hertz", physics::infinity, "Hz",
                   "Stiffness of the spring; infinite is a rod, 0 is free between the limits.",
                   setting<&DistanceJoint::hertz, &DistanceJoint::set_hertz>(hosting)),
            amount(
                "damping_ratio", 0, "",
                "Damping ratio of the spring; with 1 it comes to rest without "
                "swinging.",
                setting<&DistanceJoint::damping_ratio, &DistanceJoint::set_damping_ratio>(hosting)),
        });
    distance.properties[0].range = not_negative;
    distance.properties[2].infinity = distance.properties[3].infinity = true;
    hosting.tree.define(std::move(distance));
}

}  // namespace fettle::physics_module
