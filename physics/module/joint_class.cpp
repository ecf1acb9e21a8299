// Joint and MouseJoint.

#include "bindings.h"
#include "classes.h"

namespace fettle::physics_module {
namespace {

using physics::MouseJoint;

/// A setting that is kept in the record and, while the joint acts, told to the library.
template <auto Field, auto Set>
Binding setting(Hosting& hosting) {
    using Argument = typename Setter<Set>::Argument;
    return accessor(
        hosting, [](Hosting& h, Row row) { return to_value(h.joints.at(row).*Field); },
        [](Hosting& h, Row row, const Value& value) {
            const auto wanted = from_value<Argument>(value);
            if (MouseJoint joint = h.joints.native(row)) (joint.*Set)(wanted);
            h.joints.at(row).*Field = wanted;
            h.joints.loosen();
        });
}

Binding body(Hosting& hosting) {
    return accessor(
        hosting, [](Hosting& h, Row row) { return h.joints.body(row); },
        [](Hosting& h, Row row, const Value& value) { h.joints.set_body(row, value.reference()); });
}

Binding anchor(Hosting& hosting) {
    Binding binding = accessor(
        hosting, [](Hosting& h, Row row) { return to_value(h.joints.anchor(row)); },
        [](Hosting& h, Row row, const Value& value) {
            h.joints.set_anchor(row, narrow(value.vec2()));
        });
    binding.reset = [](void* context, Row row) {
        static_cast<Hosting*>(context)->joints.set_anchor(row, std::nullopt);
    };
    binding.overridden = [](void* context, Row row) {
        return static_cast<Hosting*>(context)->joints.at(row).anchor.has_value();
    };
    return binding;
}

Binding force(Hosting& hosting) {
    return accessor(hosting, [](Hosting& h, Row row) {
        const MouseJoint joint = h.joints.native(row);
        return to_value(joint ? joint.force() : physics::Vec2(physics::Vec2::Zero()));
    });
}

property::Lifecycle lifecycle(Hosting& hosting) {
    property::Lifecycle lifecycle;
    lifecycle.context = &hosting;
    lifecycle.create = [](void* context, property::Tree&, Handle self) {
        auto& h = *static_cast<Hosting*>(context);
        return h.joints.create(h.world_above(self));
    };
    lifecycle.place = [](void* context, property::Tree&, Handle self, Row row) {
        auto& h = *static_cast<Hosting*>(context);
        h.joints.place(row, h.world_above(self));
        return row;
    };
    lifecycle.destroy = [](void* context, property::Tree&, Handle, Row row) {
        static_cast<Hosting*>(context)->joints.destroy(row);
    };
    return lifecycle;
}

}  // namespace

void define_joints(Hosting& hosting) {
    using Record = MouseJointRecord;
    property::ClassDescriptor joint;
    joint.name = "Joint";
    joint.doc =
        "Ties bodies together or to the world. It acts while it and its bodies are in the "
        "same world.";
    joint.creatable = false;
    joint.lifecycle = lifecycle(hosting);
    joint.properties = {{.name = "enabled",
                         .type = Type::boolean,
                         .default_value = true,
                         .doc = "Whether it acts.",
                         .binding = setting<&Record::enabled, &MouseJoint::set_enabled>(hosting)},
                        {.name = "force",
                         .type = Type::vec2,
                         .unit = "N",
                         .doc = "What it pulled with in the last step.",
                         .binding = force(hosting),
                         .read_only = true,
                         .transient = true,
                         .simulated = true,
                         .single_precision = true}};
    hosting.tree.define(std::move(joint));

    property::ClassDescriptor mouse;
    mouse.name = "MouseJoint";
    mouse.base = "Joint";
    mouse.stem = "mouse_joint";
    mouse.doc = "Pulls a point of a body softly towards a target: how a mouse drags.";
    mouse.lifecycle = lifecycle(hosting);
    mouse.properties = {
        {.name = "body",
         .type = Type::reference,
         .doc = "What is pulled; nil: nothing.",
         .binding = body(hosting),
         .reference_class = "Body"},
        {.name = "anchor",
         .type = Type::vec2,
         .unit = "m",
         .doc = "The point of the body that is pulled, in its coordinates. Unless one is given, "
                "the point that was at the target when the joint began to act.",
         .binding = anchor(hosting),
         .simulated = true,
         .derives_from = {"body", "target"},
         .single_precision = true},
        {.name = "target",
         .type = Type::vec2,
         .unit = "m",
         .doc = "Where it is pulled to, in the world.",
         .binding = setting<&Record::target, &MouseJoint::set_target>(hosting),
         .single_precision = true},
        {.name = "frequency",
         .default_value = Record{}.frequency,
         .unit = "Hz",
         .range = not_negative,
         .doc = "How stiff it is; 0 is slack.",
         .binding = setting<&Record::frequency, &MouseJoint::set_hertz>(hosting),
         .single_precision = true},
        {.name = "damping_ratio",
         .default_value = Record{}.damping_ratio,
         .range = not_negative,
         .doc = "1 comes to rest without swinging.",
         .binding = setting<&Record::damping_ratio, &MouseJoint::set_damping_ratio>(hosting),
         .single_precision = true},
        {.name = "max_force",
         .default_value = static_cast<double>(Record{}.max_force),
         .unit = "N",
         .range = not_negative,
         .doc = "It never pulls harder.",
         .binding = setting<&Record::max_force, &MouseJoint::set_max_force>(hosting),
         .infinity = true,
         .single_precision = true},
    };
    hosting.tree.define(std::move(mouse));
}

}  // namespace fettle::physics_module
