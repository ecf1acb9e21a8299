#pragma once

#include <checks/arguments.h>
#include <state/joint_kind.h>
#include <world/world_data.h>

#include <stdexcept>

// Functions for the handles of joints: creating a joint, reading and writing its settings.

namespace fettle::physics {

namespace detail {

[[noreturn]] void refuse_wrong_joint(JointType expected, JointType is);

/// Slot of a body; `name`: its name in the definition, for messages.
uint32_t slot_of(const World& world, const char* name, BodyId id);
/// The record of a dormant joint with the settings that it has when none is set.
JointRecord record_of(JointType type);
/// Checks a definition, and returns the record of a joint with it.
JointRecord checked(const World& world, JointType type, const JointDef& def);

/// The settings that the definition of any type of joint has.
template <class Def>
JointDef common_of(const Def& def) {
    return {def.body_a,
            def.body_b,
            def.anchor_a,
            def.anchor_b,
            def.collide,
            def.enabled,
            def.user_data,
            def.break_force,
            def.break_torque,
            def.report_force,
            def.report_torque,
            def.constraint_hertz,
            def.constraint_damping_ratio};
}

/// A definition gives both limits at once, so a lower limit above the upper one is an error. The
/// functions that set one of them accept it, since the other one may follow.
template <class Def>
void check_limits(const Def& def) {
    if constexpr (requires { def.lower_angle; })
        check_order("lower_angle", def.lower_angle, "upper_angle", def.upper_angle);
    if constexpr (requires { def.lower_translation; })
        check_order("lower_translation", def.lower_translation, "upper_translation",
                    def.upper_translation);
    if constexpr (requires { def.min_length; })
        check_order("min_length", def.min_length, "max_length", def.max_length);
}

template <class Handle>
Handle make_joint(World& world, WorldData& data, const JointRecord& record) {
    const uint32_t slot = data.change<create_joint>(record);
    return {&world, {slot, data.joint_generations[slot]}};
}

/// Angle of b relative to a, rad.
float angle_between(const Joint& joint);
/// From anchor a to anchor b, world axes, m.
Vec2 gap_between(const Joint& joint);
/// Position of anchor b relative to anchor a along a direction in the coordinates of a.
float translation_along(const Joint& joint, const Vec2& direction);

}  // namespace detail

template <class Settings>
Settings& Joint::settings_as() const {
    detail::JointRecord& record = live().joints[id_.index];
    if (record.type != Settings::type) detail::refuse_wrong_joint(Settings::type, record.type);
    return record.settings.as<Settings>();
}

template <class Settings>
Settings& Joint::edit(const char* of, const char* function) const {
    Settings& settings = settings_as<Settings>();
    detail::WorldData& data = live();
    data.self.may_edit(of, function);
    data.change<detail::edit_joint>(id_.index);
    return settings;
}

}  // namespace fettle::physics

// Defines a property that is a member of the settings. `Of`: beginning of the name of the joint's
// type.
#define FETTLE_JOINT_PROPERTY(Of, Value, Argument, name, member)    \
    Value Of##Joint::name() const {                                 \
        return settings_as<detail::Of##Settings>().member;          \
    }                                                               \
    void Of##Joint::set_##name(Argument value) {                    \
        auto wanted = settings_as<detail::Of##Settings>();          \
        wanted.member = value;                                      \
        wanted.check();                                             \
        edit<detail::Of##Settings>(#Of "Joint", __func__) = wanted; \
    }
#define FETTLE_JOINT_NUMBER(Of, name, member) FETTLE_JOINT_PROPERTY(Of, float, float, name, member)
#define FETTLE_JOINT_VECTOR(Of, name, member) \
    FETTLE_JOINT_PROPERTY(Of, Vec2, const Vec2&, name, member)
#define FETTLE_JOINT_POSITION(Of, name, member) \
    FETTLE_JOINT_PROPERTY(Of, Position, const Position&, name, member)
// Defines a force or a torque of the last step, from a member of the impulses.
#define FETTLE_JOINT_FORCE(Of, name, member)                                                  \
    float Of##Joint::name() const {                                                           \
        settings_as<detail::Of##Settings>();                                                  \
        const auto& impulses = live().joints[id().index].impulses.as<detail::Of##Impulses>(); \
        return per_substep(impulses.member);                                                  \
    }
// Defines the angle of b relative to a, minus the reference angle.
#define FETTLE_JOINT_ANGLE(Of)                                \
    FETTLE_JOINT_NUMBER(Of, reference_angle, reference_angle) \
    float Of##Joint::angle() const {                          \
        return angle_between(*this) - reference_angle();      \
    }
// The same for a joint that holds the angle: whole turns do not count.
#define FETTLE_JOINT_HELD_ANGLE(Of)                                                     \
    FETTLE_JOINT_NUMBER(Of, reference_angle, reference_angle)                           \
    float Of##Joint::angle() const {                                                    \
        return std::remainder(angle_between(*this) - reference_angle(), two_pi<float>); \
    }
// Defines World::create_..._joint. A function `define(settings, def)` in the file of the type
// writes the settings of a definition; `begin` measures what it leaves open, on the new `joint`.
#define FETTLE_CREATE_JOINT(Of, function, begin)                                 \
    Of##Joint World::function(const Of##JointDef& def) {                         \
        WorldData& data = populate(__func__);                                    \
        JointRecord record = checked(*this, Of##Settings::type, common_of(def)); \
        define(record.settings.as<Of##Settings>(), def);                         \
        record.settings.as<Of##Settings>().check();                              \
        check_limits(def);                                                       \
        auto joint = make_joint<Of##Joint>(*this, data, record);                 \
        begin;                                                                   \
        return joint;                                                            \
    }
