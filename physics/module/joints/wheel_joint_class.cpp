// WheelJoint: a sprung and driven wheel.

#include <joints/joint_bindings.h>

namespace fettle::physics_module {

void define_wheel_joint(Hosting& hosting) {
    using physics::WheelJoint;
    property::ClassDescriptor wheel = pair_joint<physics::JointType::wheel>(
        hosting, "WheelJoint",
        "A wheel, body_b, that is sprung along an axis of body_a and may be driven.",
        {
            figure("translation", "m",
                   "Distance of the axle from the position at which the spring rests.",
                   reading<&WheelJoint::translation>(hosting)),
            vector("axis", {0, 1}, "",
                   "Direction of the spring, in the coordinates of body_a; of any length but 0.",
                   setting<&WheelJoint::axis, &WheelJoint::set_axis>(hosting)),
            amount(
                "hertz", 4, "Hz",
                "Stiffness of the spring: how often both bodies swing against each other in a "
                "second "
                "when nothing else touches them; 0: no spring. A heavy body on light wheels, which "
                "stand on the ground, swings slower.",
                setting<&WheelJoint::hertz, &WheelJoint::set_hertz>(hosting)),
            amount("damping_ratio", 0.7f, "",
                   "Damping ratio of the spring; with 1 it comes to rest without "
                   "swinging.",
                   setting<&WheelJoint::damping_ratio, &WheelJoint::set_damping_ratio>(hosting)),
            limit_number(
                "lower_translation", -physics::infinity, "m", "Smallest translation of the axle.",
                limit_setting<&WheelJoint::lower_translation, &WheelJoint::set_lower_translation>(
                    hosting)),
            limit_number(
                "upper_translation", physics::infinity, "m",
                "Largest translation of the axle. If lower_translation is larger, both are this "
                "translation.",
                limit_setting<&WheelJoint::upper_translation, &WheelJoint::set_upper_translation>(
                    hosting)),
            number("motor_speed", 0, "rad/s",
                   "Angular velocity to which the motor drives the wheel, counter-clockwise.",
                   setting<&WheelJoint::motor_speed, &WheelJoint::set_motor_speed>(hosting)),
            amount(
                "max_motor_torque", 0, "N m", "Largest torque of the motor; 0: no motor.",
                setting<&WheelJoint::max_motor_torque, &WheelJoint::set_max_motor_torque>(hosting)),
            figure("motor_torque", "N m", "Torque of the motor in the last step.",
                   reading<&WheelJoint::motor_torque>(hosting)),
        });
    wheel.properties[7].infinity = true;
    hosting.tree.define(std::move(wheel));
}

}  // namespace fettle::physics_module
