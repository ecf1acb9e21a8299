// FilterJoint and RotaryLimitJoint.

#include <joints/joint_bindings.h>

namespace fettle::physics_module {
namespace {

using physics::JointType;
using physics::RotaryLimitJoint;

}  // namespace

void define_limiting_joints(Hosting& hosting) {
    hosting.tree.define(pair_joint<JointType::filter>(
        hosting, "FilterJoint",
        "Its two bodies do not collide with each other; it does nothing else.", {}));
    hosting.tree.define(pair_joint<JointType::rotary_limit>(
        hosting, "RotaryLimitJoint",
        "Keeps the angle of body_b relative to body_a between two angles, wherever the bodies are.",
        {
            figure("angle", "rad", "Angle of body_b relative to body_a, minus the reference_angle.",
                   angle_from_reference<RotaryLimitJoint>(hosting)),
            measured_number(
                "reference_angle", "rad",
                "The angle that counts as 0. Unless it is set, the angle when the "
                "joint began to act.",
                measured_setting<JointType::rotary_limit, &RotaryLimitJoint::reference_angle,
                                 &RotaryLimitJoint::set_reference_angle, angle_between>(hosting)),
            limit_number(
                "lower_angle", -physics::infinity, "rad", "Smallest angle.",
                limit_setting<&RotaryLimitJoint::lower_angle, &RotaryLimitJoint::set_lower_angle>(
                    hosting)),
            limit_number(
                "upper_angle", physics::infinity, "rad",
                "Largest angle. If lower_angle is larger, both are this angle.",
                limit_setting<&RotaryLimitJoint::upper_angle, &RotaryLimitJoint::set_upper_angle>(
                    hosting)),
        }));
}

}  // namespace fettle::physics_module
