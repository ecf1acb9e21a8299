#pragma once
// Bindings of joints.

#include <algorithm>
#include <cmath>
#include <limits>

#include <bindings/bindings.h>

namespace fettle::physics_module {

/// Limits a measured value to the range of setters, because bodies far apart may exceed it.
inline float bounded(float x, float limit = std::numeric_limits<float>::max()) {
    return std::isnan(x) ? 0.0f : std::clamp(x, -limit, limit);
}
inline physics::Vec2 bounded(const physics::Vec2& point) {
    constexpr float limit = 1e8f;  // the largest coordinate
    return {bounded(point.x, limit), bounded(point.y, limit)};
}

/// A setting of a joint. If no user has set it, it is measured when the joint begins to act.
/// `Measured` returns the value that would be measured now.
template <physics::JointType type, auto Get, auto Set, auto Measured>
Binding measured_setting(Hosting& hosting) {
    using Native = typename Setter<Set>::Object;
    using Argument = typename Setter<Set>::Argument;
    hosting.joints.measures[static_cast<std::size_t>(type)] = [](Hosting& h, Row row,
                                                                 physics::World& in) {
        (Native(&in, h.joints.at(row).id()).*Set)(bounded(Measured(h, row)));
    };
    Binding binding = accessor(
        hosting,
        [](Hosting& h, Row row) {
            const bool known = h.joints.ties(row).source != Source::none;
            return widened(known ? (h.joints.at<Native>(row).*Get)() : Measured(h, row));
        },
        [](Hosting& h, Row row, const Value& value) {
            (h.joints.at<Native>(row).*Set)(from_value<Argument>(value));
            h.joints.set_source(row, Source::given);
        });
    binding.reset = [](void* context, Row row) {
        static_cast<Hosting*>(context)->joints.set_source(row, Source::none);
    };
    binding.overridden = [](void* context, Row row) {
        return static_cast<Hosting*>(context)->joints.ties(row).source != Source::none;
    };
    return binding;
}

/// As `setting`, for a limit: limits that cross are reported.
template <auto Get, auto Set>
Binding limit_setting(Hosting& hosting) {
    using Native = typename Setter<Set>::Object;
    return accessor(
        hosting, [](Hosting& h, Row row) { return widened((h.joints.at<Native>(row).*Get)()); },
        [](Hosting& h, Row row, const Value& value) {
            (h.joints.at<Native>(row).*Set)(from_value<float>(value));
            h.add_joint_with_limits(row);
        });
}

template <physics::JointType type>
property::Lifecycle joint_lifecycle(Hosting& hosting) {
    property::Lifecycle lifecycle;
    lifecycle.context = &hosting;
    lifecycle.create = [](void* context, property::Tree&, Handle self) {
        return static_cast<Hosting*>(context)->joints.create(self, type);
    };
    lifecycle.place = [](void* context, property::Tree&, Handle self, Row row) {
        return static_cast<Hosting*>(context)->joints.place(self, row);
    };
    lifecycle.destroy = [](void* context, property::Tree&, Handle, Row row) {
        static_cast<Hosting*>(context)->joints.destroy(row);
    };
    hosting.joint_kinds.emplace_back(lifecycle.create, static_cast<std::size_t>(type));
    return lifecycle;
}

/// A property with a number that the joint measures unless it is set.
Property measured_number(std::string name, std::string unit, std::string doc, Binding binding);
/// A read-only number of a joint; 0 while it does not act.
template <auto Get>
Binding reading(Hosting& hosting) {
    using Native = typename Getter<Get>::Object;
    return accessor(hosting, [](Hosting& h, Row row) {
        const auto joint = h.joints.at<Native>(row);
        return widened(joint.dormant() ? 0.0f : (joint.*Get)());
    });
}

/// Current angle of b relative to a.
float angle_between(Hosting& hosting, Row row);
/// The same less the reference angle of the joint; 0 while it has no bodies.
template <class Native>
Binding angle_from_reference(Hosting& hosting) {
    return accessor(hosting, [](Hosting& h, Row row) {
        const bool known = h.joints.ties(row).source != Source::none;
        const float reference = h.joints.at<Native>(row).reference_angle();
        return widened(known ? angle_between(h, row) - reference : 0.0f);
    });
}

template <physics::JointType type>
property::ClassDescriptor pair_joint(Hosting& hosting, std::string name, std::string doc,
                                     std::vector<Property> properties) {
    property::ClassDescriptor of;
    of.name = std::move(name);
    of.base = "PairJoint";
    of.doc = std::move(doc);
    of.lifecycle = joint_lifecycle<type>(hosting);
    of.makes_base_rows = true;
    of.properties = std::move(properties);
    return of;
}

void define_distance_joint(Hosting& hosting);
void define_revolute_joint(Hosting& hosting);
void define_sliding_joints(Hosting& hosting);
void define_wheel_joint(Hosting& hosting);
void define_coupling_joints(Hosting& hosting);
void define_limiting_joints(Hosting& hosting);

}  // namespace fettle::physics_module
