// WeldJoint, MotorJoint, PulleyJoint, GearJoint and RatchetJoint: joints that hold, drive or couple
// two bodies as a whole.

#include <joints/joint_bindings.h>

namespace fettle::physics_module {
namespace {

using physics::GearJoint;
using physics::JointType;
using physics::MotorJoint;
using physics::PulleyJoint;
using physics::RatchetJoint;
using physics::WeldJoint;

void define_weld_joint(Hosting& hosting) {
    property::ClassDescriptor weld = pair_joint<JointType::weld>(
        hosting, "WeldJoint", "Holds two bodies together, rigidly or as a spring.",
        {
            measured_number(
                "reference_angle", "rad",
                "The angle of body_b relative to body_a that it holds. Unless it is set, the "
                "angle when the joint began to act.",
                measured_setting<JointType::weld, &WeldJoint::reference_angle,
                                 &WeldJoint::set_reference_angle, angle_between>(hosting)),
            amount("hertz", physics::infinity, "Hz",
                   "Stiffness of the point; infinite is rigid, 0 is free.",
                   setting<&WeldJoint::hertz, &WeldJoint::set_hertz>(hosting)),
            amount("damping_ratio", 0, "",
                   "Damping ratio; with 1 it comes to rest without swinging.",
                   setting<&WeldJoint::damping_ratio, &WeldJoint::set_damping_ratio>(hosting)),
            amount("angular_hertz", physics::infinity, "Hz",
                   "Stiffness of the angle; infinite is rigid, 0 is free.",
                   setting<&WeldJoint::angular_hertz, &WeldJoint::set_angular_hertz>(hosting)),
            amount(
                "angular_damping_ratio", 0, "",
                "Damping ratio of the angle; with 1 it comes to rest without "
                "swinging.",
                setting<&WeldJoint::angular_damping_ratio, &WeldJoint::set_angular_damping_ratio>(
                    hosting)),
        });
    weld.properties[1].infinity = weld.properties[3].infinity = true;
    hosting.tree.define(std::move(weld));
}

void define_motor_joint(Hosting& hosting) {
    property::ClassDescriptor motor = pair_joint<JointType::motor>(
        hosting, "MotorJoint",
        "Drives body_b relative to body_a with a limited force and torque: to a velocity or, "
        "with a hertz, to an offset. With velocity 0 it is the friction of a game seen from "
        "above.",
        {
            amount("max_force", 0, "N", "Largest force.",
                   setting<&MotorJoint::max_force, &MotorJoint::set_max_force>(hosting)),
            amount("max_torque", 0, "N m", "Largest torque.",
                   setting<&MotorJoint::max_torque, &MotorJoint::set_max_torque>(hosting)),
            vector(
                "linear_velocity", {0, 0}, "m/s",
                "Target velocity of anchor_b relative to anchor_a, in the coordinates of body_a.",
                setting<&MotorJoint::linear_velocity, &MotorJoint::set_linear_velocity>(hosting)),
            number(
                "angular_velocity", 0, "rad/s",
                "Target angular velocity of body_b relative to body_a.",
                setting<&MotorJoint::angular_velocity, &MotorJoint::set_angular_velocity>(hosting)),
            within(coordinates,
                   vector("linear_offset", {0, 0}, "m",
                          "Target position of anchor_b relative to anchor_a, in the coordinates of "
                          "body_a.",
                          setting<&MotorJoint::linear_offset, &MotorJoint::set_linear_offset>(
                              hosting))),
            measured_number(
                "angular_offset", "rad",
                "Target angle of body_b relative to body_a. Unless it is set, the angle when the "
                "joint began to act.",
                measured_setting<JointType::motor, &MotorJoint::angular_offset,
                                 &MotorJoint::set_angular_offset, angle_between>(hosting)),
            amount("hertz", 0, "Hz", "Stiffness of the drive to the offsets; 0: none.",
                   setting<&MotorJoint::hertz, &MotorJoint::set_hertz>(hosting)),
            amount("damping_ratio", 1, "",
                   "Damping ratio of the drive to the offsets; with 1 it comes to rest without "
                   "swinging.",
                   setting<&MotorJoint::damping_ratio, &MotorJoint::set_damping_ratio>(hosting)),
        });
    motor.properties[0].infinity = motor.properties[1].infinity = true;
    hosting.tree.define(std::move(motor));
}

float rope_now(Hosting& hosting, Row row) {
    const Joints& joints = hosting.joints;
    const auto pulley = joints.at<PulleyJoint>(row);
    return (joints.world_anchor(row, 0) - pulley.ground_a()).length() +
           pulley.ratio() * (joints.world_anchor(row, 1) - pulley.ground_b()).length();
}

float phase_now(Hosting& hosting, Row row) {
    const Joints& joints = hosting.joints;
    return joints.angle_of(row, 1) - joints.at<GearJoint>(row).ratio() * joints.angle_of(row, 0);
}

void define_pulley_joint(Hosting& hosting) {
    property::ClassDescriptor pulley = pair_joint<JointType::pulley>(
        hosting, "PulleyJoint",
        "A rope from body_a over two wheels of the world to body_b. It only pulls.",
        {
            within(
                coordinates,
                vector("ground_a", {-1, 1}, "m", "Position of the wheel over body_a in the world.",
                       setting<&PulleyJoint::ground_a, &PulleyJoint::set_ground_a>(hosting))),
            within(
                coordinates,
                vector("ground_b", {1, 1}, "m", "Position of the wheel over body_b in the world.",
                       setting<&PulleyJoint::ground_b, &PulleyJoint::set_ground_b>(hosting))),
            amount("ratio", 1, "", "Number of parts of the rope that pull body_b.",
                   setting<&PulleyJoint::ratio, &PulleyJoint::set_ratio>(hosting)),
            measured_number("length", "m",
                            "Length of the part at body_a plus ratio times that at body_b. "
                            "Unless it is set, the length when the joint began to act.",
                            measured_setting<JointType::pulley, &PulleyJoint::length,
                                             &PulleyJoint::set_length, rope_now>(hosting)),
            figure("tension", "N", "Force in the rope in the last step.",
                   reading<&PulleyJoint::tension>(hosting)),
        });
    // The rope runs over the wheels.
    for (const char* source : {"ground_a", "ground_b", "ratio"})
        pulley.properties[3].derives_from.emplace_back(source);
    pulley.properties[2].range = {.min = 1e-3, .max = 1e3};
    pulley.properties[3].range = not_negative;
    hosting.tree.define(std::move(pulley));
}

void define_gear_joint(Hosting& hosting) {
    hosting.tree.define(pair_joint<JointType::gear>(
        hosting, "GearJoint", "Turns body_b with body_a.",
        {
            number("ratio", 1, "",
                   "Turns of body_b for one turn of body_a: negative for wheels that mesh, "
                   "positive for wheels with a belt.",
                   setting<&GearJoint::ratio, &GearJoint::set_ratio>(hosting)),
            measured_number("phase", "rad",
                            "The angle of body_b minus ratio times that of body_a. Unless it is "
                            "set, its value when the joint began to act.",
                            measured_setting<JointType::gear, &GearJoint::phase,
                                             &GearJoint::set_phase, phase_now>(hosting)),
        }));
}

void define_ratchet_joint(Hosting& hosting) {
    hosting.tree.define(pair_joint<JointType::ratchet>(
        hosting, "RatchetJoint", "Lets body_b turn relative to body_a in one direction only.",
        {
            amount("tooth", 0, "rad", "Angle between two teeth; 0: it holds at any angle.",
                   setting<&RatchetJoint::tooth, &RatchetJoint::set_tooth>(hosting)),
            {.name = "backwards",
             .type = Type::boolean,
             .doc = "True if clockwise is the free direction, and not counter-clockwise.",
             .binding = setting<&RatchetJoint::backwards, &RatchetJoint::set_backwards>(hosting)},
            measured_number(
                "reference_angle", "rad",
                "The angle that counts as 0, at which a tooth is. Unless it is set, the angle "
                "when the joint began to act.",
                measured_setting<JointType::ratchet, &RatchetJoint::reference_angle,
                                 &RatchetJoint::set_reference_angle, angle_between>(hosting)),
            figure("caught_angle", "rad", "It does not turn back beyond this angle.",
                   reading<&RatchetJoint::caught_angle>(hosting)),
        }));
}

}  // namespace

void define_coupling_joints(Hosting& hosting) {
    define_weld_joint(hosting);
    define_motor_joint(hosting);
    define_pulley_joint(hosting);
    define_gear_joint(hosting);
    define_ratchet_joint(hosting);
}

}  // namespace fettle::physics_module
