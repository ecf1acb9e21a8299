#include <world/live_joint.h>

// The handles of the joints that hold, drive or couple two bodies as a whole.

namespace fettle::physics {

using namespace detail;

FETTLE_JOINT_SETTING(WeldJoint, WeldData, reference_angle, check_finite("reference_angle", value))
FETTLE_JOINT_SETTING(WeldJoint, WeldData, hertz, check_stiffness("hertz", value))
FETTLE_JOINT_SETTING(WeldJoint, WeldData, damping_ratio, check_not_negative("damping_ratio", value))
FETTLE_JOINT_SETTING(WeldJoint, WeldData, angular_hertz, check_stiffness("angular_hertz", value))
FETTLE_JOINT_SETTING(WeldJoint, WeldData, angular_damping_ratio,
                     check_not_negative("angular_damping_ratio", value))

float WeldJoint::angle() const {
    return angle_between(*this) - reference_angle();
}

FETTLE_JOINT_VECTOR(MotorJoint, MotorData, linear_velocity, linear_velocity,
                    check_finite("linear_velocity", value))
FETTLE_JOINT_SETTING(MotorJoint, MotorData, angular_velocity,
                     check_finite("angular_velocity", value))
FETTLE_JOINT_SETTING(MotorJoint, MotorData, max_force, check_strength("max_force", value))
FETTLE_JOINT_SETTING(MotorJoint, MotorData, max_torque, check_strength("max_torque", value))
FETTLE_JOINT_VECTOR(MotorJoint, MotorData, linear_offset, linear_offset,
                    check_coordinates("linear_offset", value))
FETTLE_JOINT_SETTING(MotorJoint, MotorData, angular_offset, check_finite("angular_offset", value))
FETTLE_JOINT_SETTING(MotorJoint, MotorData, hertz, check_not_negative("hertz", value))
FETTLE_JOINT_SETTING(MotorJoint, MotorData, damping_ratio,
                     check_not_negative("damping_ratio", value))

FETTLE_JOINT_VECTOR(PulleyJoint, PulleyData, ground_a, ground_a,
                    check_coordinates("ground_a", value))
FETTLE_JOINT_VECTOR(PulleyJoint, PulleyData, ground_b, ground_b,
                    check_coordinates("ground_b", value))
FETTLE_JOINT_SETTING(PulleyJoint, PulleyData, ratio, check_range("ratio", value, 1e-3f, 1e3f))
FETTLE_JOINT_SETTING(PulleyJoint, PulleyData, length, check_not_negative("length", value))

float PulleyJoint::length_a() const {
    return (world_anchor_a() - ground_a()).norm();
}
float PulleyJoint::length_b() const {
    return (world_anchor_b() - ground_b()).norm();
}
float PulleyJoint::length_now() const {
    return length_a() + ratio() * length_b();
}
float PulleyJoint::tension() const {
    return per_substep(own<PulleyData>().impulses.tension);
}

FETTLE_JOINT_SETTING(GearJoint, GearData, ratio, check_finite("ratio", value))
FETTLE_JOINT_SETTING(GearJoint, GearData, phase, check_finite("phase", value))

float GearJoint::phase_now() const {
    const Body a = body_a(), b = body_b();
    return (b ? b.angle() : 0.0f) - ratio() * (a ? a.angle() : 0.0f);
}

FETTLE_JOINT_SETTING(RatchetJoint, RatchetData, tooth, check_not_negative("tooth", value))

float RatchetJoint::reference_angle() const {
    return own<RatchetData>().reference_angle;
}
void RatchetJoint::set_reference_angle(float angle) {
    (void)own<RatchetData>();
    const float checked = check_finite("reference_angle", angle);
    edit<RatchetData>("RatchetJoint", __func__).reference_angle = checked;
    own<RatchetData>().impulses = {};  // the teeth are elsewhere: the pawl falls anew
}
bool RatchetJoint::backwards() const {
    return own<RatchetData>().backwards;
}
void RatchetJoint::set_backwards(bool backwards) {
    edit<RatchetData>("RatchetJoint", __func__).backwards = backwards;
    own<RatchetData>().impulses = {};
}
float RatchetJoint::angle() const {
    return angle_between(*this) - reference_angle();
}
float RatchetJoint::caught_angle() const {
    const RatchetData& data = own<RatchetData>();
    if (!data.impulses.engaged) return angle();
    return data.backwards ? -data.impulses.caught : data.impulses.caught;
}

}  // namespace fettle::physics
