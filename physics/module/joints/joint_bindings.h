#pragma once
// Bindings of joints: a setting is passed to the library, which may refuse it, and kept in the
// record.

#include <bindings/bindings.h>

namespace fettle::physics_module {

template <auto Field>
struct Settings;
template <class Of, class Held, Held Of::*Field>
struct Settings<Field> {
    using Class = Of;
    using Value = Held;
};

/// A setting of one type of joint.
template <auto Field, auto Set>
Binding joint_setting(Hosting& hosting) {
    using Of = typename Settings<Field>::Class;
    using Native = typename Of::Native;
    using Argument = typename Setter<Set>::Argument;
    return accessor(
        hosting, [](Hosting& h, Row row) { return to_value(h.joints.settings<Of>(row).*Field); },
        [](Hosting& h, Row row, const Value& value) {
            const auto wanted = from_value<Argument>(value);
            (h.joints.acting_or_model<Native>(row).*Set)(wanted);
            h.joints.settings<Of>(row).*Field = wanted;
        });
}

/// A setting that the joint measures when it begins to act, unless it is set; `Look` returns the
/// value that it would measure now.
template <auto Field, auto Set, auto Look>
Binding found_setting(Hosting& hosting) {
    using Of = typename Settings<Field>::Class;
    using Native = typename Of::Native;
    using Argument = typename Setter<Set>::Argument;
    Binding binding = accessor(
        hosting,
        [](Hosting& h, Row row) {
            const auto& found = h.joints.settings<Of>(row).*Field;
            return to_value(found.value ? *found.value : Look(h.joints, h.joints.at(row)));
        },
        [](Hosting& h, Row row, const Value& value) {
            const auto wanted = from_value<Argument>(value);
            (h.joints.acting_or_model<Native>(row).*Set)(wanted);
            (h.joints.settings<Of>(row).*Field).give(wanted);
        });
    binding.reset = [](void* context, Row row) {
        auto& joints = static_cast<Hosting*>(context)->joints;
        (joints.settings<Of>(row).*Field).give(std::nullopt);
        joints.remake(row);
    };
    binding.overridden = [](void* context, Row row) {
        return (static_cast<Hosting*>(context)->joints.settings<Of>(row).*Field).value.has_value();
    };
    return binding;
}

template <class Of>
property::Lifecycle joint_lifecycle(Hosting& hosting) {
    property::Lifecycle lifecycle;
    lifecycle.context = &hosting;
    lifecycle.create = [](void* context, property::Tree&, Handle self) {
        auto& h = *static_cast<Hosting*>(context);
        return h.joints.create<Of>(h.world_above(self), self);
    };
    lifecycle.place = [](void* context, property::Tree&, Handle self, Row row) {
        auto& h = *static_cast<Hosting*>(context);
        h.joints.place(row, h.world_above(self));
        return row;
    };
    lifecycle.destroy = [](void* context, property::Tree&, Handle, Row row) {
        static_cast<Hosting*>(context)->joints.destroy(row);
    };
    hosting.joint_kinds.emplace_back(lifecycle.create, AnySettings(Of{}).index());
    return lifecycle;
}

/// A number that the joint measures, unless it is set.
Property found_number(std::string name, std::string unit, std::string doc, Binding binding);
/// A read-only number of a native joint; 0 while there is none.
template <class Native, auto Ask>
Binding told(Hosting& hosting) {
    return accessor(hosting, [](Hosting& h, Row row) {
        const Native joint = h.joints.native<Native>(row);
        return to_value(joint ? (joint.*Ask)() : 0.0f);
    });
}

/// Current angle of b relative to a.
float angle_between(const Joints& joints, const JointRecord& record);

template <class Of>
property::ClassDescriptor pair_joint(Hosting& hosting, std::string name, std::string stem,
                                     std::string doc, std::vector<Property> properties) {
    property::ClassDescriptor of;
    of.name = std::move(name);
    of.base = "PairJoint";
    of.stem = std::move(stem);
    of.doc = std::move(doc);
    of.lifecycle = joint_lifecycle<Of>(hosting);
    of.properties = std::move(properties);
    return of;
}

void define_distance_joint(Hosting& hosting);
void define_revolute_joint(Hosting& hosting);
void define_sliding_joints(Hosting& hosting);
void define_wheel_joint(Hosting& hosting);
void define_coupling_joints(Hosting& hosting);

}  // namespace fettle::physics_module
