// RevoluteJoint: a pin, with limits, a motor and a spring.

#include <joints/joint_bindings.h>

namespace fettle::physics_module {
namespace {

using physics::JointType;
using physics::RevoluteJoint;

std::vector<Property> properties(Hosting& hosting) {
    return {
        figure("angle", "rad", "Angle of body_b relative to body_a, minus the reference_angle.",
               angle_from_reference<RevoluteJoint>(hosting)),
        measured_number(
            "reference_angle", "rad",
            "The angle that counts as 0. Unless it is set, the angle when the joint began to act.",
            measured_setting<JointType::revolute, &RevoluteJoint::reference_angle,
                             &RevoluteJoint::set_reference_angle, angle_between>(hosting)),
        limit_number(
            "lower_angle", -physics::infinity, "rad", "Smallest angle.",
            limit_setting<&RevoluteJoint::lower_angle, &RevoluteJoint::set_lower_angle>(hosting)),
        limit_number(
            "upper_angle", physics::infinity, "rad",
            "Largest angle. If lower_angle is larger, both are this angle.",
            limit_setting<&RevoluteJoint::upper_angle, &RevoluteJoint::set_upper_angle>(hosting)),
        number("motor_speed", 0, "rad/s", "Angular velocity to which the motor drives body_b.",
               setting<&RevoluteJoint::motor_speed, &RevoluteJoint::set_motor_speed>(hosting)),
        amount("max_motor_torque", 0, "N m", "Largest torque of the motor; 0: no motor.",
               setting<&RevoluteJoint::max_motor_torque, &RevoluteJoint::set_max_motor_torque>(
                   hosting)),
        figure("motor_torque", "N m", "Torque of the motor in the last step.",
               reading<&RevoluteJoint::motor_torque>(hosting)),
        amount("hertz", 0, "Hz", "Stiffness of a spring to the target_angle; 0: none.",
               setting<&RevoluteJoint::hertz, &RevoluteJoint::set_hertz>(hosting)),
        amount("damping_ratio", 0, "",
               "Damping ratio of the spring; with 1 it comes to rest without "
               "swinging.",
               setting<&RevoluteJoint::damping_ratio, &RevoluteJoint::set_damping_ratio>(hosting)),
        number("target_angle", 0, "rad", "Angle at which the spring rests.",
               setting<&RevoluteJoint::target_angle, &RevoluteJoint::set_target_angle>(hosting)),
    };
}

}  // namespace

void define_revolute_joint(Hosting& hosting) {
    property::ClassDescriptor revolute = pair_joint<JointType::revolute>(
        hosting, "RevoluteJoint", "A pin through two bodies, about which they turn.",
        properties(hosting));
    for (Property& property : revolute.properties)
        if (property.name == "max_motor_torque") property.infinity = true;
    hosting.tree.define(std::move(revolute));
}

}  // namespace fettle::physics_module
