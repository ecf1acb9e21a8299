// PrismaticJoint, PinSlotJoint and GrooveJoint: joints that slide along a line.

#include <joints/joint_bindings.h>

namespace fettle::physics_module {
namespace {

template <class J>
std::vector<Property> slide_properties(Hosting& hosting) {
    std::vector<Property> properties = {
        figure("translation", "m", "How far anchor_b is from anchor_a along the axis.",
               told<&J::translation>(hosting)),
        vector("axis", {1, 0}, "",
               "Along which it slides, in the coordinates of body_a; of any length but 0.",
               setting<&J::axis, &J::set_axis>(hosting)),
        limit_number("lower_translation", -physics::infinity, "m", "It slides no further back.",
                     setting<&J::lower_translation, &J::set_lower_translation>(hosting)),
        limit_number("upper_translation", physics::infinity, "m",
                     "It slides no further on. Where lower_translation is above it, this counts.",
                     setting<&J::upper_translation, &J::set_upper_translation>(hosting)),
        number("motor_speed", 0, "m/s", "What the motor moves body_b with.",
               setting<&J::motor_speed, &J::set_motor_speed>(hosting)),
        amount("max_motor_force", 0, "N", "The motor is no stronger; 0: there is none.",
               setting<&J::max_motor_force, &J::set_max_motor_force>(hosting)),
        figure("motor_force", "N", "What the motor gave in the last step.",
               told<&J::motor_force>(hosting)),
        amount("hertz", 0, "Hz", "Stiffness of a spring to the target_translation; 0: none.",
               setting<&J::hertz, &J::set_hertz>(hosting)),
        amount("damping_ratio", 0, "", "Of the spring; 1 comes to rest without swinging.",
               setting<&J::damping_ratio, &J::set_damping_ratio>(hosting)),
        number("target_translation", 0, "m", "Where the spring brings it to.",
               setting<&J::target_translation, &J::set_target_translation>(hosting)),
    };
    properties[5].infinity = true;
    return properties;
}

}  // namespace

void define_sliding_joints(Hosting& hosting) {
    using physics::GrooveJoint;
    using physics::JointType;
    using physics::PrismaticJoint;
    std::vector<Property> drawer = slide_properties<PrismaticJoint>(hosting);
    drawer.push_back(measured_number(
        "reference_angle", "rad",
        "The angle of body_b against body_a that it holds. Unless one is given, the angle when the "
        "joint began to act.",
        measured_setting<JointType::prismatic, &PrismaticJoint::reference_angle,
                         &PrismaticJoint::set_reference_angle, angle_between>(hosting)));
    hosting.tree.define(pair_joint<JointType::prismatic>(
        hosting, "PrismaticJoint", "prismatic_joint",
        "Lets body_b slide along an axis of body_a without turning.", std::move(drawer)));
    hosting.tree.define(pair_joint<JointType::pin_slot>(
        hosting, "PinSlotJoint", "pin_slot_joint",
        "A pin of body_b in a straight slot of body_a: it slides, and turns freely.",
        slide_properties<physics::PinSlotJoint>(hosting)));
    hosting.tree.define(pair_joint<JointType::groove>(
        hosting, "GrooveJoint", "groove_joint",
        "A pin of body_b in a groove of body_a from anchor_a to groove_end.",
        {within(coordinates, vector("groove_end", {1, 0}, "m", "In the coordinates of body_a.",
                                    setting<&GrooveJoint::end, &GrooveJoint::set_end>(hosting))),
         figure("translation", "m", "How far the pin is from the begin of the groove.",
                told<&GrooveJoint::translation>(hosting))}));
}

}  // namespace fettle::physics_module
