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
        hosting, "DistanceJoint",
        "Keeps two points at a distance: a rod; with a finite hertz a spring; with hertz 0 and a "
        "max_length a rope.",
        {
            measured_number(
                "length", "m",
                "Length of the rod, or of the spring at rest. Unless it is set, the distance "
                "when the joint began to act.",
                measured_setting<JointType::distance, &DistanceJoint::length,
                                 &DistanceJoint::set_length, length_now>(hosting)),
            amount(
                "min_length", 0, "m", "Smallest distance of the anchors.",
                limit_setting<&DistanceJoint::min_length, &DistanceJoint::set_min_length>(hosting)),
            amount(
                "max_length", physics::infinity, "m",
                "Largest distance of the anchors. If min_length is larger, both are this "
                "distance.",
                limit_setting<&DistanceJoint::max_length, &DistanceJoint::set_max_length>(hosting)),
            amount("hertz", physics::infinity, "Hz",
                   "Stiffness of the spring; infinite is a rod, 0 is free between the limits.",
                   setting<&DistanceJoint::hertz, &DistanceJoint::set_hertz>(hosting)),
            amount(
                "damping_ratio", 0, "",
                "Damping ratio of the spring; with 1 it comes to rest without "
                "swinging.",
                setting<&DistanceJoint::damping_ratio, &DistanceJoint::set_damping_ratio>(hosting)),
            within({.max = 0},
                   limit_number("lower_spring_force", -physics::infinity, "N",
                                "The spring does not pull with more than this; 0: it only pushes.",
                                setting<&DistanceJoint::lower_spring_force,
                                        &DistanceJoint::set_lower_spring_force>(hosting))),
            within(not_negative,
                   limit_number("upper_spring_force", physics::infinity, "N",
                                "The spring does not push with more than this; 0: it only pulls.",
                                setting<&DistanceJoint::upper_spring_force,
                                        &DistanceJoint::set_upper_spring_force>(hosting))),
            number("motor_speed", 0, "m/s",
                   "Speed with which the motor changes the distance. A rod has no motor.",
                   setting<&DistanceJoint::motor_speed, &DistanceJoint::set_motor_speed>(hosting)),
            amount("max_motor_force", 0, "N", "Largest force of the motor; 0: no motor.",
                   setting<&DistanceJoint::max_motor_force, &DistanceJoint::set_max_motor_force>(
                       hosting)),
            figure("motor_force", "N",
                   "Force of the motor in the last step; positive pushes the anchors apart.",
                   reading<&DistanceJoint::motor_force>(hosting)),
        });
    for (Property& property : distance.properties)
        if (property.name == "max_motor_force") property.infinity = true;
    distance.properties[0].range = not_negative;
    distance.properties[2].infinity = distance.properties[3].infinity = true;
    hosting.tree.define(std::move(distance));
}

}  // namespace fettle::physics_module
