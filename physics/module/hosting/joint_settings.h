#pragma once
// Settings of joints, by type. `each` lists every setting with the setter of the library, and, for
// values that are measured when the joint begins to act, with the getter.

#include <optional>
#include <variant>

#include <fettle/physics/world.h>

namespace fettle::physics_module {

/// A value that is measured when the joint begins to act, unless it is set.
template <class T>
struct Found {
    std::optional<T> value;
    bool given = false;  // set by a user: does not change when the joint gets other bodies

    void give(std::optional<T> wanted) {
        value = wanted;
        given = wanted.has_value();
    }
    void look_again() {
        if (!given) value.reset();
    }
};

struct MouseSettings {
    using Native = physics::MouseJoint;
    Found<physics::Vec2> anchor;  // the point of the body that is at the target
    physics::Vec2 target = physics::Vec2::Zero();
    float frequency = 5.0f, damping_ratio = 0.7f, max_force = physics::infinity;

    static void each(auto&& visit) {
        visit(&MouseSettings::anchor, &Native::set_anchor, &Native::anchor);
        visit(&MouseSettings::target, &Native::set_target);
        visit(&MouseSettings::frequency, &Native::set_hertz);
        visit(&MouseSettings::damping_ratio, &Native::set_damping_ratio);
        visit(&MouseSettings::max_force, &Native::set_max_force);
    }
};

struct DistanceSettings {
    using Native = physics::DistanceJoint;
    Found<float> length;
    float min_length = 0.0f, max_length = physics::infinity;
    float hertz = physics::infinity, damping_ratio = 0.0f;

    static constexpr auto make = &physics::World::create_distance_joint;
    static void each(auto&& visit) {
        visit(&DistanceSettings::length, &Native::set_length, &Native::length);
        visit(&DistanceSettings::min_length, &Native::set_min_length);
        visit(&DistanceSettings::max_length, &Native::set_max_length);
        visit(&DistanceSettings::hertz, &Native::set_hertz);
        visit(&DistanceSettings::damping_ratio, &Native::set_damping_ratio);
    }
};

struct RevoluteSettings {
    using Native = physics::RevoluteJoint;
    Found<float> reference_angle;
    float lower_angle = -physics::infinity, upper_angle = physics::infinity;
    float motor_speed = 0.0f, max_motor_torque = 0.0f;
    float hertz = 0.0f, damping_ratio = 0.0f, target_angle = 0.0f;

    static constexpr auto make = &physics::World::create_revolute_joint;
    static void each(auto&& visit) {
        visit(&RevoluteSettings::reference_angle, &Native::set_reference_angle,
              &Native::reference_angle);
        visit(&RevoluteSettings::lower_angle, &Native::set_lower_angle);
        visit(&RevoluteSettings::upper_angle, &Native::set_upper_angle);
        visit(&RevoluteSettings::motor_speed, &Native::set_motor_speed);
        visit(&RevoluteSettings::max_motor_torque, &Native::set_max_motor_torque);
        visit(&RevoluteSettings::hertz, &Native::set_hertz);
        visit(&RevoluteSettings::damping_ratio, &Native::set_damping_ratio);
        visit(&RevoluteSettings::target_angle, &Native::set_target_angle);
    }
};

struct PrismaticSettings {
    using Native = physics::PrismaticJoint;
    Found<float> reference_angle;
    physics::Vec2 axis = {1.0f, 0.0f};
    float lower_translation = -physics::infinity, upper_translation = physics::infinity;
    float motor_speed = 0.0f, max_motor_force = 0.0f;
    float hertz = 0.0f, damping_ratio = 0.0f, target_translation = 0.0f;

    static constexpr auto make = &physics::World::create_prismatic_joint;
    static void each(auto&& visit) {
        visit(&PrismaticSettings::reference_angle, &Native::set_reference_angle,
              &Native::reference_angle);
        visit(&PrismaticSettings::axis, &Native::set_axis);
        visit(&PrismaticSettings::lower_translation, &Native::set_lower_translation);
        visit(&PrismaticSettings::upper_translation, &Native::set_upper_translation);
        visit(&PrismaticSettings::motor_speed, &Native::set_motor_speed);
        visit(&PrismaticSettings::max_motor_force, &Native::set_max_motor_force);
        visit(&PrismaticSettings::hertz, &Native::set_hertz);
        visit(&PrismaticSettings::damping_ratio, &Native::set_damping_ratio);
        visit(&PrismaticSettings::target_translation, &Native::set_target_translation);
    }
};

struct PinSlotSettings {
    using Native = physics::PinSlotJoint;
    physics::Vec2 axis = {1.0f, 0.0f};
    float lower_translation = -physics::infinity, upper_translation = physics::infinity;
    float motor_speed = 0.0f, max_motor_force = 0.0f;
    float hertz = 0.0f, damping_ratio = 0.0f, target_translation = 0.0f;

    static constexpr auto make = &physics::World::create_pin_slot_joint;
    static void each(auto&& visit) {
        visit(&PinSlotSettings::axis, &Native::set_axis);
        visit(&PinSlotSettings::lower_translation, &Native::set_lower_translation);
        visit(&PinSlotSettings::upper_translation, &Native::set_upper_translation);
        visit(&PinSlotSettings::motor_speed, &Native::set_motor_speed);
        visit(&PinSlotSettings::max_motor_force, &Native::set_max_motor_force);
        visit(&PinSlotSettings::hertz, &Native::set_hertz);
        visit(&PinSlotSettings::damping_ratio, &Native::set_damping_ratio);
        visit(&PinSlotSettings::target_translation, &Native::set_target_translation);
    }
};

struct GrooveSettings {
    using Native = physics::GrooveJoint;
    physics::Vec2 groove_end = {1.0f, 0.0f};

    static constexpr auto make = &physics::World::create_groove_joint;
    static void each(auto&& visit) { visit(&GrooveSettings::groove_end, &Native::set_end); }
};

struct WheelSettings {
    using Native = physics::WheelJoint;
    physics::Vec2 axis = {0.0f, 1.0f};
    float hertz = 4.0f, damping_ratio = 0.7f;
    float lower_translation = -physics::infinity, upper_translation = physics::infinity;
    float motor_speed = 0.0f, max_motor_torque = 0.0f;

    static constexpr auto make = &physics::World::create_wheel_joint;
    static void each(auto&& visit) {
        visit(&WheelSettings::axis, &Native::set_axis);
        visit(&WheelSettings::hertz, &Native::set_hertz);
        visit(&WheelSettings::damping_ratio, &Native::set_damping_ratio);
        visit(&WheelSettings::lower_translation, &Native::set_lower_translation);
        visit(&WheelSettings::upper_translation, &Native::set_upper_translation);
        visit(&WheelSettings::motor_speed, &Native::set_motor_speed);
        visit(&WheelSettings::max_motor_torque, &Native::set_max_motor_torque);
    }
};

struct WeldSettings {
    using Native = physics::WeldJoint;
    Found<float> reference_angle;
    float hertz = physics::infinity, damping_ratio = 0.0f;
    float angular_hertz = physics::infinity, angular_damping_ratio = 0.0f;

    static constexpr auto make = &physics::World::create_weld_joint;
    static void each(auto&& visit) {
        visit(&WeldSettings::reference_angle, &Native::set_reference_angle,
              &Native::reference_angle);
        visit(&WeldSettings::hertz, &Native::set_hertz);
        visit(&WeldSettings::damping_ratio, &Native::set_damping_ratio);
        visit(&WeldSettings::angular_hertz, &Native::set_angular_hertz);
        visit(&WeldSettings::angular_damping_ratio, &Native::set_angular_damping_ratio);
    }
};

struct MotorSettings {
    using Native = physics::MotorJoint;
    physics::Vec2 linear_velocity = physics::Vec2::Zero();
    float angular_velocity = 0.0f;
    float max_force = 0.0f, max_torque = 0.0f;
    physics::Vec2 linear_offset = physics::Vec2::Zero();
    Found<float> angular_offset;
    float hertz = 0.0f, damping_ratio = 1.0f;

    static constexpr auto make = &physics::World::create_motor_joint;
    static void each(auto&& visit) {
        visit(&MotorSettings::angular_offset, &Native::set_angular_offset, &Native::angular_offset);
        visit(&MotorSettings::linear_velocity, &Native::set_linear_velocity);
        visit(&MotorSettings::angular_velocity, &Native::set_angular_velocity);
        visit(&MotorSettings::max_force, &Native::set_max_force);
        visit(&MotorSettings::max_torque, &Native::set_max_torque);
        visit(&MotorSettings::linear_offset, &Native::set_linear_offset);
        visit(&MotorSettings::hertz, &Native::set_hertz);
        visit(&MotorSettings::damping_ratio, &Native::set_damping_ratio);
    }
};

struct PulleySettings {
    using Native = physics::PulleyJoint;
    physics::Vec2 ground_a = {-1.0f, 1.0f}, ground_b = {1.0f, 1.0f};
    float ratio = 1.0f;
    Found<float> length;

    static constexpr auto make = &physics::World::create_pulley_joint;
    static void each(auto&& visit) {
        visit(&PulleySettings::ground_a, &Native::set_ground_a);
        visit(&PulleySettings::ground_b, &Native::set_ground_b);
        visit(&PulleySettings::ratio, &Native::set_ratio);
        visit(&PulleySettings::length, &Native::set_length, &Native::length_now);
    }
};

struct GearSettings {
    using Native = physics::GearJoint;
    float ratio = 1.0f;
    Found<float> phase;

    static constexpr auto make = &physics::World::create_gear_joint;
    static void each(auto&& visit) {
        visit(&GearSettings::ratio, &Native::set_ratio);
        visit(&GearSettings::phase, &Native::set_phase, &Native::phase_now);
    }
};

struct RatchetSettings {
    using Native = physics::RatchetJoint;
    Found<float> reference_angle;
    float tooth = 0.0f;
    bool backwards = false;

    static constexpr auto make = &physics::World::create_ratchet_joint;
    static void each(auto&& visit) {
        visit(&RatchetSettings::reference_angle, &Native::set_reference_angle,
              &Native::reference_angle);
        visit(&RatchetSettings::tooth, &Native::set_tooth);
        visit(&RatchetSettings::backwards, &Native::set_backwards);
    }
};

using AnySettings =
    std::variant<MouseSettings, DistanceSettings, RevoluteSettings, PrismaticSettings,
                 WheelSettings, WeldSettings, MotorSettings, PulleySettings, GearSettings,
                 GrooveSettings, PinSlotSettings, RatchetSettings>;

}  // namespace fettle::physics_module
