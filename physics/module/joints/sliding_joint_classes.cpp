// PrismaticJoint, PinSlotJoint and GrooveJoint: joints that slide along a line.

#include <joints/joint_bindings.h>

namespace fettle::physics_module {
namespace {

template <class S>
std::vector<Property> slide_properties(Hosting& hosting) {
    using J = typename S::Native;
    std::vector<Property> properties = {
        figure("translation", "m", "How far anchor_b is from anchor_a along the axis.",
               told<J, &J::translation>(hosting)),
        vector("axis", {1, 0}, "",
               "Along which it slides, in the coordinates of body_a; of any length but 0.",
               joint_setting<&S::axis, &J::set_axis>(hosting)),
        limit_number("lower_translation", -physics::infinity, "m", "It slides no further back.",
                     joint_setting<&S::lower_translation, &J::set_lower_translation>(hosting)),
        limit_number("upper_translation", physics::infinity, "m",
                     "It slides no further on. Where lower_translation is above it, this counts.",
                     joint_setting<&S::upper_translation, &J::set_upper_translation>(hosting)),
        number("motor_speed", 0, "m/s", "What the motor moves body_b with.",
               joint_setting<&S::motor_speed, &J::set_motor_speed>(hosting)),
        amount("max_motor_force", 0, "N", "The motor is no stronger; 0: there is none.",
               joint_setting<&S::max_motor_force, &J::set_max_motor_force>(hosting)),
        figure("motor_force", "N", "What the motor gave in the last step.",
               told<J, &J::motor_force>(hosting)),
        amount("hertz", 0, "Hz", "Stiffness of a spring to the target_translation; 0: none.",
               joint_setting<&S::hertz, &J::set_hertz>(hosting)),
        amount("damping_ratio", 0, "", "Of the spring; 1 comes to rest without swinging.",
               joint_setting<&S::damping_ratio, &J::set_damping_ratio>(hosting)),
        number("target_translation", 0, "m", "Where the spring brings it to.",
               joint_setting<&S::target_translation, &J::set_target_translation>(hosting)),
    };
    properties[5].infinity = true;
    return properties;
}

}  // namespace

void define_sliding_joints(Hosting& hosting) {
    using P = PrismaticSettings;
    using physics::GrooveJoint;
    using physics::PrismaticJoint;
    std::vector<Property> drawer = slide_properties<P>(hosting);
    drawer.push_back(found_number(
        "reference_angle", "rad",
        "The angle of body_b against body_a that it holds. Unless one is given, the angle when the "
        "joint began to act.",
        found_setting<&P::reference_angle, &PrismaticJoint::set_reference_angle, angle_between>(
            hosting)));
    hosting.tree.define(pair_joint<P>(hosting, "PrismaticJoint", "prismatic_joint",
                                      "Lets body_b slide along an axis of body_a without turning.",
                                      std::move(drawer)));
    hosting.tree.define(pair_joint<PinSlotSettings>(
        hosting, "PinSlotJoint", "pin_slot_joint",
        "A pin of body_b in a straight slot of body_a: it slides, and turns freely.",
        slide_properties<PinSlotSettings>(hosting)));
    hosting.tree.define(pair_joint<GrooveSettings>(
        hosting, "GrooveJoint", "groove_joint",
        "A pin of body_b in a groove of body_a from anchor_a to groove_end.",
        {within(coordinates,
                vector("groove_end", {1, 0}, "m", "In the coordinates of body_a.",
                       joint_setting<&GrooveSettings::groove_end, &GrooveJoint::set_end>(hosting))),
         figure("translation", "m", "How far the pin is from the begin of the groove.",
                told<GrooveJoint, &GrooveJoint::translation>(hosting))}));
}

}  // namespace fettle::physics_module
