// Joint, MouseJoint, and PairJoint, which has the common members of all joints of two bodies.

#include <joints/joint_bindings.h>
#include <joints/joint_classes.h>

namespace fettle::physics_module {
namespace {

using physics::Joint;
using physics::JointType;

template <std::size_t Side>
Binding body(Hosting& hosting) {
    return accessor(
        hosting, [](Hosting& h, Row row) { return h.joints.body(row, Side); },
        [](Hosting& h, Row row, const Value& value) {
            h.joints.set_body(row, Side, value.reference());
        });
}

physics::Vec2 mouse_anchor_now(Hosting& hosting, Row row) {
    const Handle body = hosting.joints.body(row, 1);
    if (!body) return physics::Vec2{};
    const physics::Vec2 target = hosting.joints.at<physics::MouseJoint>(row).target();
    return hosting.body(hosting.tree.row(body)).local_point(target);
}

std::vector<Property> joint_properties(Hosting& hosting) {
    std::vector<Property> all = {
        flag("enabled", true, "True if it may act.",
             setting<&Joint::enabled, &Joint::set_enabled>(hosting)),
        amount("break_force", physics::infinity, "N",
               "It breaks if its force is larger, as the mean of a step; infinite: never.",
               setting<&Joint::break_force, &Joint::set_break_force>(hosting)),
        amount("break_torque", physics::infinity, "N m",
               "It breaks if its torque, not counting that of its force, is larger.",
               setting<&Joint::break_torque, &Joint::set_break_torque>(hosting)),
        amount("report_force", physics::infinity, "N",
               "The event loaded is emitted in each step in which its force, as the mean of the "
               "step, is larger; infinite: never.",
               setting<&Joint::report_force, &Joint::set_report_force>(hosting)),
        amount("report_torque", physics::infinity, "N m",
               "The event loaded is emitted in each step in which its torque, not counting that of "
               "its force, is larger.",
               setting<&Joint::report_torque, &Joint::set_report_torque>(hosting)),
        amount("constraint_hertz", 0, "Hz",
               "How fast it corrects an error of its position, at most a quarter of the rate of "
               "sub-steps; 0: 60 Hz, and more where it connects bodies of very different masses.",
               setting<&Joint::constraint_hertz, &Joint::set_constraint_hertz>(hosting)),
        within(
            {.min = 0, .max = 1000},
            number("constraint_damping_ratio", 2, "",
                   "Damping ratio of a constraint_hertz above 0.",
                   setting<&Joint::constraint_damping_ratio, &Joint::set_constraint_damping_ratio>(
                       hosting))),
        simulated(flag("broken", false, "True if it broke and does not act; false repairs it.",
                       setting<&Joint::broken, &Joint::set_broken>(hosting))),
        {.name = "force",
         .type = Type::vec2,
         .unit = "N",
         .doc = "Force on its body, or on body_b, in the last step.",
         .binding = read_only<&Joint::force>(hosting),
         .read_only = true,
         .transient = true,
         .simulated = true,
         .single_precision = true},
        figure("torque", "N m",
               "Torque on body_b in the last step, not counting that of its force.",
               read_only<&Joint::torque>(hosting)),
        figure("separation", "m",
               "Distance of its bodies from where it should hold them: what a rigid part or a "
               "limit has yielded.",
               reading<&Joint::separation>(hosting)),
        figure("angular_separation", "rad",
               "Difference between the angle of its bodies and the angle that it should hold.",
               reading<&Joint::angular_separation>(hosting))};
    for (const std::size_t strength : {1, 2, 3, 4}) all[strength].infinity = true;
    return all;
}

std::vector<property::Event> joint_events() {
    return {{.name = "broke",
             .fields = {{"force", Type::vec2, "N", "Force of the joint when it broke."},
                        {"torque", Type::number, "N m",
                         "Torque of the joint when it broke, not counting that of the force."}},
             .doc = "Its force or torque was larger than break_force or break_torque."},
            {.name = "loaded",
             .fields = {{"force", Type::vec2, "N", "Force of the joint in the step."},
                        {"torque", Type::number, "N m",
                         "Torque of the joint in the step, not counting that of the force."}},
             .doc = "Its force or torque was larger than report_force or report_torque."}};
}

void define_joint(Hosting& hosting) {
    property::ClassDescriptor joint;
    joint.snapshots = property::Snapshots::natively;
    joint.name = "Joint";
    joint.weight = 250;
    joint.doc =
        "Connects bodies with each other or with the world. It acts while it and its bodies are "
        "in the same world.";
    joint.creatable = false;
    joint.lifecycle = joint_lifecycle<JointType::mouse>(hosting);
    joint.properties = joint_properties(hosting);
    joint.events = joint_events();
    const property::Class& defined = hosting.tree.define(std::move(joint));
    hosting.classes.abstract.push_back(&defined);
    hosting.declared.broke = defined.event("broke");
    hosting.declared.loaded = defined.event("loaded");
}

template <std::size_t Side>
Property body_property(Hosting& hosting, std::string name) {
    return {.name = std::move(name),
            .type = Type::reference,
            .doc =
                "One of the two connected bodies; nil: the world. When the body is deleted, the "
                "joint does not act until this is set to another body or to nil.",
            .binding = body<Side>(hosting),
            .reference_class = "Body"};
}

Property anchor_property(std::string name, Binding binding) {
    return {.name = std::move(name),
            .type = Type::vec2,
            .unit = "m",
            .range = coordinates,
            .doc =
                "The point at which that body is held, in its coordinates, or in those of the "
                "world.",
            .binding = binding,
            .single_precision = true};
}

void define_pair_joint(Hosting& hosting) {
    property::ClassDescriptor pair;
    pair.name = "PairJoint";
    pair.base = "Joint";
    pair.doc =
        "Connects two bodies, or one with the world. While both are the same, it does not "
        "act.";
    pair.creatable = false;
    pair.lifecycle = joint_lifecycle<JointType::distance>(hosting);
    pair.makes_base_rows = true;
    pair.properties = {
        body_property<0>(hosting, "body_a"),
        body_property<1>(hosting, "body_b"),
        anchor_property("anchor_a", setting<&Joint::anchor_a, &Joint::set_anchor_a>(hosting)),
        anchor_property("anchor_b", setting<&Joint::anchor_b, &Joint::set_anchor_b>(hosting)),
        flag("collide", false, "True if the two bodies collide with each other.",
             setting<&Joint::collide, &Joint::set_collide>(hosting)),
    };
    hosting.classes.abstract.push_back(&hosting.tree.define(std::move(pair)));
}

void define_mouse_joint(Hosting& hosting) {
    using physics::MouseJoint;
    property::ClassDescriptor mouse;
    mouse.name = "MouseJoint";
    mouse.base = "Joint";
    mouse.doc = "Pulls a point of a body softly towards a target, as for dragging with the mouse.";
    mouse.lifecycle = joint_lifecycle<JointType::mouse>(hosting);
    mouse.makes_base_rows = true;
    mouse.properties = {
        {.name = "body",
         .type = Type::reference,
         .doc = "The body that is pulled; nil: none.",
         .binding = body<1>(hosting),
         .reference_class = "Body"},
        {.name = "anchor",
         .type = Type::vec2,
         .unit = "m",
         .range = coordinates,
         .doc = "The point of the body that is pulled, in its coordinates. Unless it is set, the "
                "point that was at the target when the joint began to act.",
         .binding = measured_setting<JointType::mouse, &MouseJoint::anchor, &MouseJoint::set_anchor,
                                     mouse_anchor_now>(hosting),
         .simulated = true,
         .derives_from = {"body", "target"},
         .single_precision = true},
        within(coordinates,
               vector("target", {0, 0}, "m", "Position in the world to which it is pulled.",
                      setting<&MouseJoint::target, &MouseJoint::set_target>(hosting))),
        amount("frequency", 5, "Hz", "Stiffness; 0 is free.",
               setting<&MouseJoint::hertz, &MouseJoint::set_hertz>(hosting)),
        amount("damping_ratio", 0.7f, "",
               "Damping ratio; with 1 it comes to rest without swinging.",
               setting<&MouseJoint::damping_ratio, &MouseJoint::set_damping_ratio>(hosting)),
        amount("max_force", physics::infinity, "N", "Largest force.",
               setting<&MouseJoint::max_force, &MouseJoint::set_max_force>(hosting)),
    };
    mouse.properties.back().infinity = true;
    hosting.tree.define(std::move(mouse));
}

}  // namespace

float angle_between(Hosting& hosting, Row row) {
    return hosting.joints.angle_of(row, 1) - hosting.joints.angle_of(row, 0);
}

Property measured_number(std::string name, std::string unit, std::string doc, Binding binding) {
    Property property =
        simulated(number(std::move(name), 0, std::move(unit), std::move(doc), binding));
    property.derives_from = {"body_a", "body_b", "anchor_a", "anchor_b"};
    return property;
}

void define_joints(Hosting& hosting) {
    define_joint(hosting);
    define_mouse_joint(hosting);
    define_pair_joint(hosting);
    define_distance_joint(hosting);
    define_revolute_joint(hosting);
    define_sliding_joints(hosting);
    define_wheel_joint(hosting);
    define_coupling_joints(hosting);
    define_limiting_joints(hosting);
}

}  // namespace fettle::physics_module
