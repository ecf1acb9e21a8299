#include <world/live_joint.h>

// The handles of the joints that slide.

namespace fettle::physics {

using namespace detail;

namespace {

const Vec2& check_axis(const char* what, const Vec2& axis) {
    check_finite(what, axis);
    if (!(length(to_v2(axis)) > 1e-6f))
        throw std::invalid_argument(std::string(what) + ": expected a direction, got no length");
    return axis;
}

/// How far anchor b is from anchor a along a direction in the coordinates of a.
float along(const Joint& joint, const Vec2& direction) {
    const V2 axis = normalized(to_v2(direction));
    const Body a = joint.body_a();
    const Vec2 turned = a ? a.world_vector(to_vec2(axis)) : to_vec2(axis);
    return turned.dot(gap_between(joint));
}

}  // namespace

FETTLE_JOINT_VECTOR(PrismaticJoint, PrismaticData, axis, rail.axis, check_axis("axis", value))
FETTLE_JOINT_FIELD(PrismaticJoint, PrismaticData, lower_translation, rail.lower,
                   check_limit("lower_translation", value))
FETTLE_JOINT_FIELD(PrismaticJoint, PrismaticData, upper_translation, rail.upper,
                   check_limit("upper_translation", value))
FETTLE_JOINT_FIELD(PrismaticJoint, PrismaticData, hertz, rail.hertz,
                   check_not_negative("hertz", value))
FETTLE_JOINT_FIELD(PrismaticJoint, PrismaticData, damping_ratio, rail.damping_ratio,
                   check_not_negative("damping_ratio", value))
float PrismaticJoint::translation() const {
    return along(*this, axis());
}
FETTLE_JOINT_FIELD(PrismaticJoint, PrismaticData, motor_speed, rail.motor_speed,
                   check_finite("motor_speed", value))
FETTLE_JOINT_FIELD(PrismaticJoint, PrismaticData, max_motor_force, rail.max_motor_force,
                   check_strength("max_motor_force", value))
FETTLE_JOINT_FIELD(PrismaticJoint, PrismaticData, target_translation, rail.target,
                   check_finite("target_translation", value))
float PrismaticJoint::motor_force() const {
    return per_substep(own<PrismaticData>().impulses.rail.motor);
}
FETTLE_JOINT_SETTING(PrismaticJoint, PrismaticData, reference_angle,
                     check_finite("reference_angle", value))
float PrismaticJoint::angle() const {
    return angle_between(*this) - reference_angle();
}

FETTLE_JOINT_VECTOR(PinSlotJoint, PinSlotData, axis, rail.axis, check_axis("axis", value))
FETTLE_JOINT_FIELD(PinSlotJoint, PinSlotData, lower_translation, rail.lower,
                   check_limit("lower_translation", value))
FETTLE_JOINT_FIELD(PinSlotJoint, PinSlotData, upper_translation, rail.upper,
                   check_limit("upper_translation", value))
FETTLE_JOINT_FIELD(PinSlotJoint, PinSlotData, hertz, rail.hertz, check_not_negative("hertz", value))
FETTLE_JOINT_FIELD(PinSlotJoint, PinSlotData, damping_ratio, rail.damping_ratio,
                   check_not_negative("damping_ratio", value))
float PinSlotJoint::translation() const {
    return along(*this, axis());
}
FETTLE_JOINT_FIELD(PinSlotJoint, PinSlotData, motor_speed, rail.motor_speed,
                   check_finite("motor_speed", value))
FETTLE_JOINT_FIELD(PinSlotJoint, PinSlotData, max_motor_force, rail.max_motor_force,
                   check_strength("max_motor_force", value))
FETTLE_JOINT_FIELD(PinSlotJoint, PinSlotData, target_translation, rail.target,
                   check_finite("target_translation", value))
float PinSlotJoint::motor_force() const {
    return per_substep(own<PinSlotData>().impulses.rail.motor);
}

FETTLE_JOINT_VECTOR(WheelJoint, WheelData, axis, rail.axis, check_axis("axis", value))
FETTLE_JOINT_FIELD(WheelJoint, WheelData, lower_translation, rail.lower,
                   check_limit("lower_translation", value))
FETTLE_JOINT_FIELD(WheelJoint, WheelData, upper_translation, rail.upper,
                   check_limit("upper_translation", value))
FETTLE_JOINT_FIELD(WheelJoint, WheelData, hertz, rail.hertz, check_not_negative("hertz", value))
FETTLE_JOINT_FIELD(WheelJoint, WheelData, damping_ratio, rail.damping_ratio,
                   check_not_negative("damping_ratio", value))
float WheelJoint::translation() const {
    return along(*this, axis());
}
FETTLE_JOINT_SETTING(WheelJoint, WheelData, motor_speed, check_finite("motor_speed", value))
FETTLE_JOINT_SETTING(WheelJoint, WheelData, max_motor_torque,
                     check_strength("max_motor_torque", value))
float WheelJoint::motor_torque() const {
    return per_substep(own<WheelData>().impulses.motor);
}

FETTLE_JOINT_VECTOR(GrooveJoint, GrooveData, end, end, check_coordinates("end", value))
float GrooveJoint::translation() const {
    return along(*this, end() - anchor_a());
}

}  // namespace fettle::physics
