#include <calls/properties.h>

#include <fettle/physics_c/sliding_joints.h>

using namespace fettle::physics;
using namespace fettle::physics_c;

FETTLE_VECTOR(prismatic_joint, PrismaticJoint, axis)
FETTLE_READING(prismatic_joint, PrismaticJoint, translation, float)
FETTLE_PROPERTY(prismatic_joint, PrismaticJoint, lower_translation, float)
FETTLE_PROPERTY(prismatic_joint, PrismaticJoint, upper_translation, float)
FETTLE_PROPERTY(prismatic_joint, PrismaticJoint, motor_speed, float)
FETTLE_PROPERTY(prismatic_joint, PrismaticJoint, max_motor_force, float)
FETTLE_READING(prismatic_joint, PrismaticJoint, motor_force, float)
FETTLE_PROPERTY(prismatic_joint, PrismaticJoint, hertz, float)
FETTLE_PROPERTY(prismatic_joint, PrismaticJoint, damping_ratio, float)
FETTLE_PROPERTY(prismatic_joint, PrismaticJoint, target_translation, float)
FETTLE_READING(prismatic_joint, PrismaticJoint, angle, float)
FETTLE_PROPERTY(prismatic_joint, PrismaticJoint, reference_angle, float)

FETTLE_VECTOR(pin_slot_joint, PinSlotJoint, axis)
FETTLE_READING(pin_slot_joint, PinSlotJoint, translation, float)
FETTLE_PROPERTY(pin_slot_joint, PinSlotJoint, lower_translation, float)
FETTLE_PROPERTY(pin_slot_joint, PinSlotJoint, upper_translation, float)
FETTLE_PROPERTY(pin_slot_joint, PinSlotJoint, motor_speed, float)
FETTLE_PROPERTY(pin_slot_joint, PinSlotJoint, max_motor_force, float)
FETTLE_READING(pin_slot_joint, PinSlotJoint, motor_force, float)
FETTLE_PROPERTY(pin_slot_joint, PinSlotJoint, hertz, float)
FETTLE_PROPERTY(pin_slot_joint, PinSlotJoint, damping_ratio, float)
FETTLE_PROPERTY(pin_slot_joint, PinSlotJoint, target_translation, float)

FETTLE_POSITION(groove_joint, GrooveJoint, end)
FETTLE_READING(groove_joint, GrooveJoint, translation, float)

FETTLE_VECTOR(wheel_joint, WheelJoint, axis)
FETTLE_READING(wheel_joint, WheelJoint, translation, float)
FETTLE_PROPERTY(wheel_joint, WheelJoint, hertz, float)
FETTLE_PROPERTY(wheel_joint, WheelJoint, damping_ratio, float)
FETTLE_PROPERTY(wheel_joint, WheelJoint, lower_translation, float)
FETTLE_PROPERTY(wheel_joint, WheelJoint, upper_translation, float)
FETTLE_PROPERTY(wheel_joint, WheelJoint, motor_speed, float)
FETTLE_PROPERTY(wheel_joint, WheelJoint, max_motor_torque, float)
FETTLE_READING(wheel_joint, WheelJoint, motor_torque, float)
