// WheelJoint: a sprung and driven wheel.

#include <joints/joint_bindings.h>

namespace fettle::physics_module {

void define_wheel_joint(Hosting& hosting) {
    using physics::WheelJoint;
    property::ClassDescriptor wheel = pair_joint<physics::JointType::wheel>(
        hosting, "WheelJoint", "wheel_joint",
        "A wheel, body_b, that is sprung along an axis of body_a and may be driven.",
        {
            figure("translation", "m", "How far the axle is from where the spring rests.",
                   told<&WheelJoint::translation>(hosting)),
            vector("axis", {0, 1}, "",
                   "Of the spring, in the coordinates of body_a; of any length but 0.",
                   setting<&WheelJoint::axis, &WheelJoint::set_axis>(hosting)),
            amount("hertz", 4, "Hz", "How stiff the spring is; 0: there is none.",
                   setting<&WheelJoint::hertz, &WheelJoint::set_hertz>(hosting)),
            amount("damping_ratio", 0.7f, "", "Of the spring; 1 comes to rest without swinging.",
                   setting<&WheelJoint::damping_ratio, &WheelJoint::set_damping_ratio>(hosting)),
            limit_number(
                "lower_translation", -physics::infinity, "m", "The axle goes no further down.",
                setting<&WheelJoint::lower_translation, &WheelJoint::set_lower_translation>(
                    hosting)),
            limit_number(
                "upper_translation", physics::infinity, "m",
                "The axle goes no further up. Where lower_translation is above it, this counts.",
                setting<&WheelJoint::upper_translation, &WheelJoint::set_upper_translation>(
                    hosting)),
            number("motor_speed", 0, "rad/s",
                   "What the motor turns the wheel with, counter-clockwise.",
                   setting<&WheelJoint::motor_speed, &WheelJoint::set_motor_speed>(hosting)),
            amount(
                "max_motor_torque", 0, "N m", "The motor is no stronger; 0: there is none.",
                setting<&WheelJoint::max_motor_torque, &WheelJoint::set_max_motor_torque>(hosting)),
            figure("motor_torque", "N m", "What the motor gave in the last step.",
                   told<&WheelJoint::motor_torque>(hosting)),
        });
    wheel.properties[7].infinity = true;
    hosting.tree.define(std::move(wheel));
}

}  // namespace fettle::physics_module
