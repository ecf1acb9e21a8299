// RevoluteJoint: a pin, with limits, a motor and a spring.

#include <joints/joint_bindings.h>

namespace fettle::physics_module {
namespace {

using S = RevoluteSettings;
using physics::RevoluteJoint;

Binding revolute_angle(Hosting& hosting) {
    return accessor(hosting, [](Hosting& h, Row row) {
        const auto& reference = h.joints.settings<S>(row).reference_angle.value;
        return to_value(reference ? angle_between(h.joints, h.joints.at(row)) - *reference : 0.0f);
    });
}

std::vector<Property> properties(Hosting& hosting) {
    return {
        figure("angle", "rad", "Of body_b against body_a, less the reference_angle.",
               revolute_angle(hosting)),
        found_number(
            "reference_angle", "rad",
            "The angle that counts as 0. Unless one is given, the angle when the joint "
            "began to act.",
            found_setting<&S::reference_angle, &RevoluteJoint::set_reference_angle, angle_between>(
                hosting)),
        limit_number("lower_angle", -physics::infinity, "rad", "It turns no further back.",
                     joint_setting<&S::lower_angle, &RevoluteJoint::set_lower_angle>(hosting)),
        limit_number("upper_angle", physics::infinity, "rad",
                     "It turns no further on. Where lower_angle is above it, this counts.",
                     joint_setting<&S::upper_angle, &RevoluteJoint::set_upper_angle>(hosting)),
        number("motor_speed", 0, "rad/s", "What the motor turns body_b with.",
               joint_setting<&S::motor_speed, &RevoluteJoint::set_motor_speed>(hosting)),
        amount("max_motor_torque", 0, "N m", "The motor is no stronger; 0: there is none.",
               joint_setting<&S::max_motor_torque, &RevoluteJoint::set_max_motor_torque>(hosting)),
        figure("motor_torque", "N m", "What the motor gave in the last step.",
               told<RevoluteJoint, &RevoluteJoint::motor_torque>(hosting)),
        amount("hertz", 0, "Hz", "Stiffness of a spring to the target_angle; 0: none.",
               joint_setting<&S::hertz, &RevoluteJoint::set_hertz>(hosting)),
        amount("damping_ratio", 0, "", "Of the spring; 1 comes to rest without swinging.",
               joint_setting<&S::damping_ratio, &RevoluteJoint::set_damping_ratio>(hosting)),
        number("target_angle", 0, "rad", "What the spring turns it to.",
               joint_setting<&S::target_angle, &RevoluteJoint::set_target_angle>(hosting)),
    };
}

}  // namespace

void define_revolute_joint(Hosting& hosting) {
    property::ClassDescriptor revolute =
        pair_joint<S>(hosting, "RevoluteJoint", "revolute_joint",
                      "A pin through two bodies, about which they turn.", properties(hosting));
    for (Property& property : revolute.properties)
        if (property.name == "max_motor_torque") property.infinity = true;
    hosting.tree.define(std::move(revolute));
}

}  // namespace fettle::physics_module
