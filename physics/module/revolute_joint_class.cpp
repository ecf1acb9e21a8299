// RevoluteJoint: a pin, with limits, a motor and a spring.

#include "joint_bindings.h"

namespace fettle::physics_module {
namespace {

using S = RevoluteSettings;
using physics::RevoluteJoint;

float angle_between(const Joints& joints, const JointRecord& record) {
    return joints.angle_of(record, 1) - joints.angle_of(record, 0);
}

Property angle_number(std::string name, double default_value, std::string unit, std::string doc,
                      Binding binding) {
    Property property =
        joint_number(std::move(name), default_value, std::move(unit), std::move(doc), binding);
    property.range = {};
    return property;
}

Binding angle(Hosting& hosting) {
    return accessor(hosting, [](Hosting& h, Row row) {
        const auto& reference = h.joints.settings<S>(row).reference_angle.value;
        return to_value(reference ? angle_between(h.joints, h.joints.at(row)) - *reference : 0.0f);
    });
}

Binding motor_torque(Hosting& hosting) {
    return accessor(hosting, [](Hosting& h, Row row) {
        const RevoluteJoint joint = h.joints.native<RevoluteJoint>(row);
        return to_value(joint ? joint.motor_torque() : 0.0f);
    });
}

std::vector<Property> properties(Hosting& hosting) {
    return {
        joint_figure("angle", "rad", "Of body_b against body_a, less the reference_angle.",
                     angle(hosting)),
        found_number(
            "reference_angle", "rad",
            "The angle that counts as 0. Unless one is given, the angle when the joint "
            "began to act.",
            found_setting<&S::reference_angle, &RevoluteJoint::set_reference_angle, angle_between>(
                hosting)),
        angle_number("lower_angle", -physics::infinity, "rad", "It turns no further back.",
                     joint_setting<&S::lower_angle, &RevoluteJoint::set_lower_angle>(hosting)),
        angle_number("upper_angle", physics::infinity, "rad",
                     "It turns no further on. Where lower_angle is above it, this counts.",
                     joint_setting<&S::upper_angle, &RevoluteJoint::set_upper_angle>(hosting)),
        angle_number("motor_speed", 0, "rad/s", "What the motor turns body_b with.",
                     joint_setting<&S::motor_speed, &RevoluteJoint::set_motor_speed>(hosting)),
        joint_number(
            "max_motor_torque", 0, "N m", "The motor is no stronger; 0: there is none.",
            joint_setting<&S::max_motor_torque, &RevoluteJoint::set_max_motor_torque>(hosting)),
        joint_figure("motor_torque", "N m", "What the motor gave in the last step.",
                     motor_torque(hosting)),
        joint_number("hertz", 0, "Hz", "Stiffness of a spring to the target_angle; 0: none.",
                     joint_setting<&S::hertz, &RevoluteJoint::set_hertz>(hosting)),
        joint_number("damping_ratio", 0, "", "Of the spring; 1 comes to rest without swinging.",
                     joint_setting<&S::damping_ratio, &RevoluteJoint::set_damping_ratio>(hosting)),
        angle_number("target_angle", 0, "rad", "What the spring turns it to.",
                     joint_setting<&S::target_angle, &RevoluteJoint::set_target_angle>(hosting)),
    };
}

}  // namespace

void define_revolute_joint(Hosting& hosting) {
    property::ClassDescriptor revolute;
    revolute.name = "RevoluteJoint";
    revolute.base = "PairJoint";
    revolute.stem = "revolute_joint";
    revolute.doc = "A pin through two bodies, about which they turn.";
    revolute.lifecycle = joint_lifecycle<S>(hosting);
    revolute.properties = properties(hosting);
    for (Property& property : revolute.properties) {
        if (property.name == "lower_angle" || property.name == "upper_angle" ||
            property.name == "max_motor_torque")
            property.infinity = true;
    }
    hosting.tree.define(std::move(revolute));
}

}  // namespace fettle::physics_module
