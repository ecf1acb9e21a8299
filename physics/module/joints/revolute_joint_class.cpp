// RevoluteJoint: a pin, with limits, a motor and a spring.

#include <joints/joint_bindings.h>

namespace fettle::physics_module {
namespace {

using physics::JointType;
using physics::RevoluteJoint;

Binding revolute_angle(Hosting& hosting) {
    return accessor(hosting, [](Hosting& h, Row row) {
        const bool known = h.joints.ties(row).source != Source::none;
        const float reference = h.joints.at<RevoluteJoint>(row).reference_angle();
        return widened(known ? angle_between(h, row) - reference : 0.0f);
    });
}

std::vector<Property> properties(Hosting& hosting) {
    return {
        figure("angle", "rad", "Of body_b against body_a, less the reference_angle.",
               revolute_angle(hosting)),
        measured_number(
            "reference_angle", "rad",
            "The angle that counts as 0. Unless one is given, the angle when the joint "
            "began to act.",
            measured_setting<JointType::revolute, &RevoluteJoint::reference_angle,
                             &RevoluteJoint::set_reference_angle, angle_between>(hosting)),
        limit_number(
            "lower_angle", -physics::infinity, "rad", "It turns no further back.",
            setting<&RevoluteJoint::lower_angle, &RevoluteJoint::set_lower_angle>(hosting)),
        limit_number(
            "upper_angle", physics::infinity, "rad",
            "It turns no further on. Where lower_angle is above it, this counts.",
            setting<&RevoluteJoint::upper_angle, &RevoluteJoint::set_upper_angle>(hosting)),
        number("motor_speed", 0, "rad/s", "What the motor turns body_b with.",
               setting<&RevoluteJoint::motor_speed, &RevoluteJoint::set_motor_speed>(hosting)),
        amount("max_motor_torque", 0, "N m", "The motor is no stronger; 0: there is none.",
               setting<&RevoluteJoint::max_motor_torque, &RevoluteJoint::set_max_motor_torque>(
                   hosting)),
        figure("motor_torque", "N m", "What the motor gave in the last step.",
               told<&RevoluteJoint::motor_torque>(hosting)),
        amount("hertz", 0, "Hz", "Stiffness of a spring to the target_angle; 0: none.",
               setting<&RevoluteJoint::hertz, &RevoluteJoint::set_hertz>(hosting)),
        amount("damping_ratio", 0, "", "Of the spring; 1 comes to rest without swinging.",
               setting<&RevoluteJoint::damping_ratio, &RevoluteJoint::set_damping_ratio>(hosting)),
        number("target_angle", 0, "rad", "What the spring turns it to.",
               setting<&RevoluteJoint::target_angle, &RevoluteJoint::set_target_angle>(hosting)),
    };
}

}  // namespace

void define_revolute_joint(Hosting& hosting) {
    property::ClassDescriptor revolute = pair_joint<JointType::revolute>(
        hosting, "RevoluteJoint", "revolute_joint",
        "A pin through two bodies, about which they turn.", properties(hosting));
    for (Property& property : revolute.properties)
        if (property.name == "max_motor_torque") property.infinity = true;
    hosting.tree.define(std::move(revolute));
}

}  // namespace fettle::physics_module
