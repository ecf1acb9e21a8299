// PrismaticJoint, PinSlotJoint and GrooveJoint: joints that slide along a line.

#include <joints/joint_bindings.h>

namespace fettle::physics_module {
namespace {

template <class J>
std::vector<Property> slide_properties(Hosting& hosting) {
    std::vector<Property> properties = {
        figure("translation", "m", "Distance of anchor_b from anchor_a along the axis.",
               reading<&J::translation>(hosting)),
        vector("axis", {1, 0}, "",
               "Direction of sliding, in the coordinates of body_a; of any length but 0.",
               setting<&J::axis, &J::set_axis>(hosting)),
        limit_number("lower_translation", -physics::infinity, "m", "Smallest translation.",
                     limit_setting<&J::lower_translation, &J::set_lower_translation>(hosting)),
        limit_number("upper_translation", physics::infinity, "m",
                     "Largest translation. If lower_translation is larger, both are this "
                     "translation.",
                     limit_setting<&J::upper_translation, &J::set_upper_translation>(hosting)),
        number("motor_speed", 0, "m/s", "Speed to which the motor drives body_b.",
               setting<&J::motor_speed, &J::set_motor_speed>(hosting)),
        amount("max_motor_force", 0, "N", "Largest force of the motor; 0: no motor.",
               setting<&J::max_motor_force, &J::set_max_motor_force>(hosting)),
        figure("motor_force", "N", "Force of the motor in the last step.",
               reading<&J::motor_force>(hosting)),
        amount("hertz", 0, "Hz", "Stiffness of a spring to the target_translation; 0: none.",
               setting<&J::hertz, &J::set_hertz>(hosting)),
        amount("damping_ratio", 0, "",
               "Damping ratio of the spring; with 1 it comes to rest without "
               "swinging.",
               setting<&J::damping_ratio, &J::set_damping_ratio>(hosting)),
        number("target_translation", 0, "m", "Translation at which the spring rests.",
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
        "The angle of body_b relative to body_a that it holds. Unless it is set, the angle when "
        "the joint began to act.",
        measured_setting<JointType::prismatic, &PrismaticJoint::reference_angle,
                         &PrismaticJoint::set_reference_angle, angle_between>(hosting)));
    hosting.tree.define(pair_joint<JointType::prismatic>(
        hosting, "PrismaticJoint", "Lets body_b slide along an axis of body_a without turning.",
        std::move(drawer)));
    hosting.tree.define(pair_joint<JointType::pin_slot>(
        hosting, "PinSlotJoint",
        "A pin of body_b in a straight slot of body_a: it slides, and turns freely.",
        slide_properties<physics::PinSlotJoint>(hosting)));
    hosting.tree.define(pair_joint<JointType::groove>(
        hosting, "GrooveJoint",
        "A pin of body_b in a groove of body_a from anchor_a to groove_end.",
        {within(coordinates,
                vector("groove_end", {1, 0}, "m", "End of the groove in the coordinates of body_a.",
                       setting<&GrooveJoint::end, &GrooveJoint::set_end>(hosting))),
         figure("translation", "m", "Distance of the pin from the beginning of the groove.",
                reading<&GrooveJoint::translation>(hosting))}));
}

}  // namespace fettle::physics_module
