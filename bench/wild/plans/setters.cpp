#include "wild/plans/setters.h"

#include <stdexcept>
#include <type_traits>

namespace fettle::bench::wild {
namespace {

template <auto setter, class Object>
void call_with(Object&& object, const Vec2& value) {
    if constexpr (std::is_invocable_v<decltype(setter), Object&>)
        (object.*setter)();
    else if constexpr (std::is_invocable_v<decltype(setter), Object&, BodyType>)
        (object.*setter)(BodyType(int(value.x)));
    else if constexpr (std::is_invocable_v<decltype(setter), Object&, Solver>)
        (object.*setter)(Solver(int(value.x)));
    else if constexpr (std::is_invocable_v<decltype(setter), Object&, const Vec2&>)
        (object.*setter)(value);
    else
        (object.*setter)(value.x);
}

template <auto setter>
constexpr Setter of_world(const char* name, ValueKind kind) {
    return {Target::world, {}, name, kind, [](const SetterTarget& target, const Vec2& value) {
                call_with<setter>(target.world, value);
            }};
}
template <auto setter>
constexpr Setter of_body(const char* name, ValueKind kind) {
    return {Target::body, {}, name, kind, [](const SetterTarget& target, const Vec2& value) {
                call_with<setter>(Body(target.body), value);
            }};
}
template <auto setter>
constexpr Setter of_shape(const char* name, ValueKind kind) {
    return {Target::shape, {}, name, kind, [](const SetterTarget& target, const Vec2& value) {
                call_with<setter>(Shape(target.shape), value);
            }};
}
template <class Any, auto setter>
constexpr Setter of_joint(JointType type, const char* name, ValueKind kind = ValueKind::number) {
    return {Target::joint, type, name, kind, [](const SetterTarget& target, const Vec2& value) {
                call_with<setter>(target.world.joint<Any>(target.joint), value);
            }};
}

constexpr auto vector = ValueKind::vector;
constexpr auto number = ValueKind::number;
constexpr auto flag = ValueKind::flag;

const Setter of_worlds[] = {
    of_world<&World::set_gravity>("set_gravity", vector),
    of_world<&World::set_substeps>("set_substeps", number),
    of_world<&World::set_sleeping>("set_sleeping", flag),
    of_world<&World::set_solver>("set_solver", ValueKind::solver),
};

const Setter of_bodies[] = {
    of_body<&Body::destroy>("destroy", ValueKind::nothing),
    of_body<&Body::set_type>("set_type", ValueKind::body_type),
    of_body<&Body::set_position>("set_position", vector),
    of_body<&Body::set_angle>("set_angle", number),
    of_body<&Body::set_velocity>("set_velocity", vector),
    of_body<&Body::set_angular_velocity>("set_angular_velocity", number),
    of_body<static_cast<void (Body::*)(const Vec2&)>(&Body::apply_impulse)>("apply_impulse",
                                                                            vector),
    of_body<&Body::set_gravity_scale>("set_gravity_scale", number),
    of_body<&Body::set_mass>("set_mass", number),
    of_body<&Body::set_awake>("set_awake", flag),
    of_body<&Body::set_bullet>("set_bullet", flag),
    of_body<&Body::set_locked_rotation>("set_locked_rotation", flag),
};

const Setter of_shapes[] = {
    of_shape<&Shape::destroy>("destroy", ValueKind::nothing),
    {Target::shape, {}, "set_geometry", ValueKind::geometry, nullptr},
    of_shape<&Shape::set_friction>("set_friction", number),
    of_shape<&Shape::set_restitution>("set_restitution", number),
    of_shape<&Shape::set_density>("set_density", number),
    of_shape<&Shape::set_surface_speed>("set_surface_speed", number),
    of_shape<&Shape::set_sensor>("set_sensor", flag),
    of_shape<&Shape::set_mask>("set_mask", number),
};

const Setter of_joints[] = {
    of_joint<MouseJoint, &MouseJoint::set_target>(JointType::mouse, "set_target", vector),
    of_joint<MouseJoint, &MouseJoint::set_hertz>(JointType::mouse, "set_hertz"),
    of_joint<MouseJoint, &MouseJoint::set_max_force>(JointType::mouse, "set_max_force"),
    of_joint<DistanceJoint, &DistanceJoint::set_length>(JointType::distance, "set_length"),
    of_joint<DistanceJoint, &DistanceJoint::set_min_length>(JointType::distance, "set_min_length"),
    of_joint<DistanceJoint, &DistanceJoint::set_max_length>(JointType::distance, "set_max_length"),
    of_joint<DistanceJoint, &DistanceJoint::set_hertz>(JointType::distance, "set_hertz"),
    of_joint<DistanceJoint, &DistanceJoint::set_damping_ratio>(JointType::distance,
                                                               "set_damping_ratio"),
    of_joint<RevoluteJoint, &RevoluteJoint::set_reference_angle>(JointType::revolute,
                                                                 "set_reference_angle"),
    of_joint<RevoluteJoint, &RevoluteJoint::set_lower_angle>(JointType::revolute,
                                                             "set_lower_angle"),
    of_joint<RevoluteJoint, &RevoluteJoint::set_upper_angle>(JointType::revolute,
                                                             "set_upper_angle"),
    of_joint<RevoluteJoint, &RevoluteJoint::set_motor_speed>(JointType::revolute,
                                                             "set_motor_speed"),
    of_joint<RevoluteJoint, &RevoluteJoint::set_max_motor_torque>(JointType::revolute,
                                                                  "set_max_motor_torque"),
    of_joint<RevoluteJoint, &RevoluteJoint::set_hertz>(JointType::revolute, "set_hertz"),
    of_joint<RevoluteJoint, &RevoluteJoint::set_damping_ratio>(JointType::revolute,
                                                               "set_damping_ratio"),
    of_joint<PrismaticJoint, &PrismaticJoint::set_axis>(JointType::prismatic, "set_axis", vector),
    of_joint<PrismaticJoint, &PrismaticJoint::set_lower_translation>(JointType::prismatic,
                                                                     "set_lower_translation"),
    of_joint<PrismaticJoint, &PrismaticJoint::set_upper_translation>(JointType::prismatic,
                                                                     "set_upper_translation"),
    of_joint<PrismaticJoint, &PrismaticJoint::set_motor_speed>(JointType::prismatic,
                                                               "set_motor_speed"),
    of_joint<PrismaticJoint, &PrismaticJoint::set_max_motor_force>(JointType::prismatic,
                                                                   "set_max_motor_force"),
    of_joint<PrismaticJoint, &PrismaticJoint::set_hertz>(JointType::prismatic, "set_hertz"),
    of_joint<PrismaticJoint, &PrismaticJoint::set_reference_angle>(JointType::prismatic,
                                                                   "set_reference_angle"),
    of_joint<PinSlotJoint, &PinSlotJoint::set_axis>(JointType::pin_slot, "set_axis", vector),
    of_joint<PinSlotJoint, &PinSlotJoint::set_lower_translation>(JointType::pin_slot,
                                                                 "set_lower_translation"),
    of_joint<PinSlotJoint, &PinSlotJoint::set_upper_translation>(JointType::pin_slot,
                                                                 "set_upper_translation"),
    of_joint<PinSlotJoint, &PinSlotJoint::set_motor_speed>(JointType::pin_slot, "set_motor_speed"),
    of_joint<PinSlotJoint, &PinSlotJoint::set_max_motor_force>(JointType::pin_slot,
                                                               "set_max_motor_force"),
    of_joint<GrooveJoint, &GrooveJoint::set_end>(JointType::groove, "set_end", vector),
    of_joint<WheelJoint, &WheelJoint::set_axis>(JointType::wheel, "set_axis", vector),
    of_joint<WheelJoint, &WheelJoint::set_hertz>(JointType::wheel, "set_hertz"),
    of_joint<WheelJoint, &WheelJoint::set_damping_ratio>(JointType::wheel, "set_damping_ratio"),
    of_joint<WheelJoint, &WheelJoint::set_lower_translation>(JointType::wheel,
                                                             "set_lower_translation"),
    of_joint<WheelJoint, &WheelJoint::set_upper_translation>(JointType::wheel,
                                                             "set_upper_translation"),
    of_joint<WheelJoint, &WheelJoint::set_motor_speed>(JointType::wheel, "set_motor_speed"),
    of_joint<WheelJoint, &WheelJoint::set_max_motor_torque>(JointType::wheel,
                                                            "set_max_motor_torque"),
    of_joint<WeldJoint, &WeldJoint::set_reference_angle>(JointType::weld, "set_reference_angle"),
    of_joint<WeldJoint, &WeldJoint::set_hertz>(JointType::weld, "set_hertz"),
    of_joint<WeldJoint, &WeldJoint::set_angular_hertz>(JointType::weld, "set_angular_hertz"),
    of_joint<MotorJoint, &MotorJoint::set_linear_velocity>(JointType::motor, "set_linear_velocity",
                                                           vector),
    of_joint<MotorJoint, &MotorJoint::set_angular_velocity>(JointType::motor,
                                                            "set_angular_velocity"),
    of_joint<MotorJoint, &MotorJoint::set_max_force>(JointType::motor, "set_max_force"),
    of_joint<MotorJoint, &MotorJoint::set_max_torque>(JointType::motor, "set_max_torque"),
    of_joint<MotorJoint, &MotorJoint::set_linear_offset>(JointType::motor, "set_linear_offset",
                                                         vector),
    of_joint<MotorJoint, &MotorJoint::set_hertz>(JointType::motor, "set_hertz"),
    of_joint<PulleyJoint, &PulleyJoint::set_ground_a>(JointType::pulley, "set_ground_a", vector),
    of_joint<PulleyJoint, &PulleyJoint::set_ground_b>(JointType::pulley, "set_ground_b", vector),
    of_joint<PulleyJoint, &PulleyJoint::set_ratio>(JointType::pulley, "set_ratio"),
    of_joint<PulleyJoint, &PulleyJoint::set_length>(JointType::pulley, "set_length"),
    of_joint<GearJoint, &GearJoint::set_ratio>(JointType::gear, "set_ratio"),
    of_joint<GearJoint, &GearJoint::set_phase>(JointType::gear, "set_phase"),
    of_joint<RatchetJoint, &RatchetJoint::set_tooth>(JointType::ratchet, "set_tooth"),
    of_joint<RatchetJoint, &RatchetJoint::set_backwards>(JointType::ratchet, "set_backwards", flag),
};

const Setter of_any_joint[] = {
    of_joint<Joint, &Joint::destroy>({}, "destroy", ValueKind::nothing),
    of_joint<Joint, &Joint::set_enabled>({}, "set_enabled", flag),
    of_joint<Joint, &Joint::set_collide>({}, "set_collide", flag),
    of_joint<Joint, &Joint::set_break_force>({}, "set_break_force"),
};

}  // namespace

const Setter& setter_named(const std::string& name, Target target, JointType joint) {
    const auto named = [&](const auto& table, bool any) -> const Setter* {
        for (const Setter& setter : table)
            if (name == setter.name && (any || setter.joint == joint)) return &setter;
        return nullptr;
    };
    const Setter* found = nullptr;
    switch (target) {
        case Target::world:
            found = named(of_worlds, true);
            break;
        case Target::body:
            found = named(of_bodies, true);
            break;
        case Target::shape:
            found = named(of_shapes, true);
            break;
        case Target::joint:
            found = named(of_any_joint, true);
            if (found == nullptr) found = named(of_joints, false);
            break;
    }
    if (found == nullptr) throw std::invalid_argument("no setter " + name);
    return *found;
}

const char* class_of(JointType type) {
    constexpr const char* names[] = {"MouseJoint",     "DistanceJoint", "RevoluteJoint",
                                     "PrismaticJoint", "WheelJoint",    "WeldJoint",
                                     "MotorJoint",     "PulleyJoint",   "GearJoint",
                                     "GrooveJoint",    "PinSlotJoint",  "RatchetJoint"};
    return names[std::size_t(type)];
}

}  // namespace fettle::bench::wild
