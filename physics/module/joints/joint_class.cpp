// Joint, MouseJoint, and PairJoint: what all joints of two bodies have in common.

#include <joints/joint_bindings.h>
#include <joints/joint_classes.h>

namespace fettle::physics_module {
namespace {

/// A setting of all joints.
template <auto Field, auto Set>
Binding common_setting(Hosting& hosting) {
    return accessor(
        hosting, [](Hosting& h, Row row) { return to_value(h.joints.at(row).*Field); },
        [](Hosting& h, Row row, const Value& value) {
            const auto wanted = from_value<typename Setter<Set>::Argument>(value);
            (h.joints.acting_or_model(row).*Set)(wanted);
            h.joints.at(row).*Field = wanted;
        });
}

template <std::size_t Side>
Binding body(Hosting& hosting) {
    return accessor(
        hosting, [](Hosting& h, Row row) { return h.joints.body(row, Side); },
        [](Hosting& h, Row row, const Value& value) {
            h.joints.set_body(row, Side, value.reference());
        });
}

template <std::size_t Side>
Binding anchor(Hosting& hosting) {
    return accessor(
        hosting, [](Hosting& h, Row row) { return to_value(h.joints.at(row).anchors[Side]); },
        [](Hosting& h, Row row, const Value& value) {
            const physics::Vec2 wanted = narrow(value.vec2());
            physics::Joint joint = h.joints.acting_or_model(row);
            Side == 0 ? joint.set_anchor_a(wanted) : joint.set_anchor_b(wanted);
            h.joints.at(row).anchors[Side] = wanted;
        });
}

Binding mouse_anchor(Hosting& hosting) {
    Binding binding = accessor(
        hosting, [](Hosting& h, Row row) { return to_value(h.joints.mouse_anchor(row)); },
        [](Hosting& h, Row row, const Value& value) {
            const physics::Vec2 wanted = narrow(value.vec2());
            h.joints.acting_or_model<physics::MouseJoint>(row).set_anchor(wanted);
            h.joints.settings<MouseSettings>(row).anchor.give(wanted);
        });
    binding.reset = [](void* context, Row row) {
        auto& joints = static_cast<Hosting*>(context)->joints;
        joints.settings<MouseSettings>(row).anchor.give(std::nullopt);
        joints.remake(row);
    };
    binding.overridden = [](void* context, Row row) {
        auto& joints = static_cast<Hosting*>(context)->joints;
        return joints.settings<MouseSettings>(row).anchor.value.has_value();
    };
    return binding;
}

Binding force(Hosting& hosting) {
    return accessor(hosting, [](Hosting& h, Row row) {
        const physics::Joint joint = h.joints.native(row);
        return to_value(joint ? joint.force() : physics::Vec2(physics::Vec2::Zero()));
    });
}

Binding torque(Hosting& hosting) {
    return accessor(hosting, [](Hosting& h, Row row) {
        const physics::Joint joint = h.joints.native(row);
        return to_value(joint ? joint.torque() : 0.0f);
    });
}

void define_joint(Hosting& hosting) {
    property::ClassDescriptor joint;
    joint.snapshots = property::Snapshots::natively;
    joint.name = "Joint";
    joint.doc =
        "Ties bodies together or to the world. It acts while it and its bodies are in the "
        "same world.";
    joint.creatable = false;
    joint.lifecycle = joint_lifecycle<MouseSettings>(hosting);
    joint.properties = {
        flag("enabled", true, "Whether it acts.",
             common_setting<&JointRecord::enabled, &physics::Joint::set_enabled>(hosting)),
        amount(
            "break_force", physics::infinity, "N",
            "It breaks when it has to bear more, in the mean over a step; infinite: never.",
            common_setting<&JointRecord::break_force, &physics::Joint::set_break_force>(hosting)),
        amount(
            "break_torque", physics::infinity, "N m",
            "It breaks when it has to bear more, besides the torque of its force.",
            common_setting<&JointRecord::break_torque, &physics::Joint::set_break_torque>(hosting)),
        simulated(flag("broken", false, "It bore too much and does not act; false mends it.",
                       common_setting<&JointRecord::broken, &physics::Joint::set_broken>(hosting))),
        {.name = "force",
         .type = Type::vec2,
         .unit = "N",
         .doc = "What it pulled its body, or body_b, with in the last step.",
         .binding = force(hosting),
         .read_only = true,
         .transient = true,
         .simulated = true,
         .single_precision = true},
        figure("torque", "N m",
               "What it turned body_b with in the last step, besides what its force does.",
               torque(hosting))};
    joint.properties[1].infinity = joint.properties[2].infinity = true;
    joint.events = {{.name = "broke",
                     .fields = {{"force", Type::vec2, "N", "That it had to bear."},
                                {"torque", Type::number, "N m", "Besides that of the force."}},
                     .doc = "It bore more than its break_force or break_torque."}};
    hosting.broke = hosting.tree.define(std::move(joint)).event("broke");
}

template <std::size_t Side>
Property body_property(Hosting& hosting, std::string name) {
    return {.name = std::move(name),
            .type = Type::reference,
            .doc =
                "One of the two that are tied; nil: the world. When it is deleted, the joint "
                "does not act until it is given another, or nil.",
            .binding = body<Side>(hosting),
            .reference_class = "Body"};
}

template <std::size_t Side>
Property anchor_property(Hosting& hosting, std::string name) {
    return {
        .name = std::move(name),
        .type = Type::vec2,
        .unit = "m",
        .range = coordinates,
        .doc = "The point where that body is held, in its coordinates, or in those of the world.",
        .binding = anchor<Side>(hosting),
        .single_precision = true};
}

void define_pair_joint(Hosting& hosting) {
    property::ClassDescriptor pair;
    pair.name = "PairJoint";
    pair.base = "Joint";
    pair.doc = "Ties two bodies, or one to the world. While both are the same, it does not act.";
    pair.creatable = false;
    pair.lifecycle = joint_lifecycle<DistanceSettings>(hosting);
    pair.properties = {
        body_property<0>(hosting, "body_a"),
        body_property<1>(hosting, "body_b"),
        anchor_property<0>(hosting, "anchor_a"),
        anchor_property<1>(hosting, "anchor_b"),
        flag("collide", false, "Whether the two bodies collide with each other.",
             common_setting<&JointRecord::collide, &physics::Joint::set_collide>(hosting)),
    };
    hosting.tree.define(std::move(pair));
}

void define_mouse_joint(Hosting& hosting) {
    using S = MouseSettings;
    using physics::MouseJoint;
    property::ClassDescriptor mouse;
    mouse.name = "MouseJoint";
    mouse.base = "Joint";
    mouse.stem = "mouse_joint";
    mouse.doc = "Pulls a point of a body softly towards a target: how a mouse drags.";
    mouse.lifecycle = joint_lifecycle<S>(hosting);
    mouse.properties = {
        {.name = "body",
         .type = Type::reference,
         .doc = "What is pulled; nil: nothing.",
         .binding = body<1>(hosting),
         .reference_class = "Body"},
        {.name = "anchor",
         .type = Type::vec2,
         .unit = "m",
         .range = coordinates,
         .doc = "The point of the body that is pulled, in its coordinates. Unless one is given, "
                "the point that was at the target when the joint began to act.",
         .binding = mouse_anchor(hosting),
         .simulated = true,
         .derives_from = {"body", "target"},
         .single_precision = true},
        within(coordinates, vector("target", {0, 0}, "m", "Where it is pulled to, in the world.",
                                   joint_setting<&S::target, &MouseJoint::set_target>(hosting))),
        amount("frequency", S{}.frequency, "Hz", "How stiff it is; 0 is slack.",
               joint_setting<&S::frequency, &MouseJoint::set_hertz>(hosting)),
        amount("damping_ratio", S{}.damping_ratio, "", "1 comes to rest without swinging.",
               joint_setting<&S::damping_ratio, &MouseJoint::set_damping_ratio>(hosting)),
        amount("max_force", S{}.max_force, "N", "It never pulls harder.",
               joint_setting<&S::max_force, &MouseJoint::set_max_force>(hosting)),
    };
    mouse.properties.back().infinity = true;
    hosting.tree.define(std::move(mouse));
}

}  // namespace

float angle_between(const Joints& joints, const JointRecord& record) {
    return joints.angle_of(record, 1) - joints.angle_of(record, 0);
}

Property found_number(std::string name, std::string unit, std::string doc, Binding binding) {
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
}

}  // namespace fettle::physics_module
