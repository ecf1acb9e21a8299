#pragma once

#include <fettle/physics/definitions.h>
#include <fettle/physics/export.h>

#include <optional>

// A definition for each type of joint but the mouse joint (definitions.h): plain aggregates for
// designated initializers. They begin with the members of `JointDef`, which converts to each of
// them. A lower limit above the upper one throws std::invalid_argument with both numbers; the
// functions of a handle set one at a time, and accept it. The handles (joint.h, sliding_joints.h,
// coupling_joints.h) describe the values. `hertz` and `damping_ratio` of a spring are those of the
// two bodies, drawn at their centers: its stiffness is (2π·hertz)² times their reduced mass, or
// their reduced inertia for an angle, in every pose. A spring with a higher `hertz` than a fifth of
// the rate of sub-steps acts with that: 48 Hz, if a step of 1/60 s has four.

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// A rod, a rope or a spring between two points.
struct DistanceJointDef {
    static constexpr JointType type = JointType::distance;  ///< the type of joint that it defines
    BodyId body_a = {};              ///< the default is the world: anchor in world coordinates
    BodyId body_b = {};              ///< the same for body b; not both may be the world
    Position anchor_a = {};          ///< body coordinates, m
    Position anchor_b = {};          ///< body coordinates, m
    bool collide = false;            ///< whether the two bodies collide with each other
    bool enabled = true;             ///< false: it does nothing
    uint64_t user_data = 0;          ///< a number of the host, without effect
    float break_force = infinity;    ///< N: `Joint::set_break_force`
    float break_torque = infinity;   ///< N m
    float report_force = infinity;   ///< N: `Joint::set_report_force`
    float report_torque = infinity;  ///< N m
    float constraint_hertz = 0.0f;   ///< `Joint::set_constraint_hertz`
    float constraint_damping_ratio = 2.0f;  ///< `Joint::set_constraint_damping_ratio`
    std::optional<float> length = {};       ///< m, of the rod, or of the spring at rest; none: the
                                            ///< current distance
    float min_length = 0.0f;                ///< m
    float max_length = infinity;            ///< m
    float hertz = infinity;                 ///< infinity: a rod; 0: free between the limits
    float damping_ratio = 0.0f;             ///< of the spring, at least 0; 1: no swinging
    float lower_spring_force = -infinity;   ///< N; a negative force pulls
    float upper_spring_force = infinity;    ///< N; a positive force pushes
    float motor_speed = 0.0f;               ///< m/s, of the distance
    float max_motor_force = 0.0f;           ///< N; 0: no motor
};

/// Holds two points together; the bodies rotate about this point.
struct RevoluteJointDef {
    static constexpr JointType type = JointType::revolute;  ///< the type of joint that it defines
    BodyId body_a = {};              ///< the default is the world: anchor in world coordinates
    BodyId body_b = {};              ///< the same for body b; not both may be the world
    Position anchor_a = {};          ///< body coordinates, m
    Position anchor_b = {};          ///< body coordinates, m
    bool collide = false;            ///< whether the two bodies collide with each other
    bool enabled = true;             ///< false: it does nothing
    uint64_t user_data = 0;          ///< a number of the host, without effect
    float break_force = infinity;    ///< N: `Joint::set_break_force`
    float break_torque = infinity;   ///< N m
    float report_force = infinity;   ///< N: `Joint::set_report_force`
    float report_torque = infinity;  ///< N m
    float constraint_hertz = 0.0f;   ///< `Joint::set_constraint_hertz`
    float constraint_damping_ratio = 2.0f;      ///< `Joint::set_constraint_damping_ratio`
    std::optional<float> reference_angle = {};  ///< rad; none: the current angle counts as 0
    float lower_angle = -infinity;              ///< rad
    float upper_angle = infinity;               ///< rad
    float motor_speed = 0.0f;                   ///< rad/s, of b relative to a
    float max_motor_torque = 0.0f;              ///< N m; 0: no motor
    float hertz = 0.0f;                         ///< of a spring to `target_angle`; 0: no spring
    float damping_ratio = 0.0f;                 ///< of the spring, at least 0; 1: no swinging
    float target_angle = 0.0f;                  ///< rad
};

/// Lets b slide along an axis of a without rotating.
struct PrismaticJointDef {
    static constexpr JointType type = JointType::prismatic;  ///< the type of joint that it defines
    BodyId body_a = {};              ///< the default is the world: anchor in world coordinates
    BodyId body_b = {};              ///< the same for body b; not both may be the world
    Position anchor_a = {};          ///< body coordinates, m
    Position anchor_b = {};          ///< body coordinates, m
    bool collide = false;            ///< whether the two bodies collide with each other
    bool enabled = true;             ///< false: it does nothing
    uint64_t user_data = 0;          ///< a number of the host, without effect
    float break_force = infinity;    ///< N: `Joint::set_break_force`
    float break_torque = infinity;   ///< N m
    float report_force = infinity;   ///< N: `Joint::set_report_force`
    float report_torque = infinity;  ///< N m
    float constraint_hertz = 0.0f;   ///< `Joint::set_constraint_hertz`
    float constraint_damping_ratio = 2.0f;  ///< `Joint::set_constraint_damping_ratio`
    Vec2 axis = {1.0f, 0.0f};               ///< coordinates of a, of any length but 0
    float lower_translation = -infinity;    ///< m
    float upper_translation = infinity;     ///< m
    float motor_speed = 0.0f;               ///< m/s, of b relative to a along the axis
    float max_motor_force = 0.0f;           ///< N; 0: no motor
    float hertz = 0.0f;                     ///< of a spring to `target_translation`; 0: no spring
    float damping_ratio = 0.0f;             ///< of the spring, at least 0; 1: no swinging
    float target_translation = 0.0f;        ///< m
    std::optional<float> reference_angle = {};  ///< rad; none: the current angle is held
};

/// A wheel (b) of a vehicle (a).
struct WheelJointDef {
    static constexpr JointType type = JointType::wheel;  ///< the type of joint that it defines
    BodyId body_a = {};              ///< the default is the world: anchor in world coordinates
    BodyId body_b = {};              ///< the same for body b; not both may be the world
    Position anchor_a = {};          ///< body coordinates, m
    Position anchor_b = {};          ///< body coordinates, m
    bool collide = false;            ///< whether the two bodies collide with each other
    bool enabled = true;             ///< false: it does nothing
    uint64_t user_data = 0;          ///< a number of the host, without effect
    float break_force = infinity;    ///< N: `Joint::set_break_force`
    float break_torque = infinity;   ///< N m
    float report_force = infinity;   ///< N: `Joint::set_report_force`
    float report_torque = infinity;  ///< N m
    float constraint_hertz = 0.0f;   ///< `Joint::set_constraint_hertz`
    float constraint_damping_ratio = 2.0f;  ///< `Joint::set_constraint_damping_ratio`
    Vec2 axis = {0.0f, 1.0f};  ///< of the suspension, coordinates of a, of any length but 0
    float lower_translation = -infinity;  ///< m
    float upper_translation = infinity;   ///< m
    float hertz = 4.0f;                   ///< of the suspension; 0: none
    float damping_ratio = 0.7f;           ///< of the suspension, at least 0
    float motor_speed = 0.0f;             ///< rad/s, of the wheel relative to the vehicle
    float max_motor_torque = 0.0f;        ///< N m; 0: no motor
};

/// Holds two bodies together at a point and at an angle.
struct WeldJointDef {
    static constexpr JointType type = JointType::weld;  ///< the type of joint that it defines
    BodyId body_a = {};              ///< the default is the world: anchor in world coordinates
    BodyId body_b = {};              ///< the same for body b; not both may be the world
    Position anchor_a = {};          ///< body coordinates, m
    Position anchor_b = {};          ///< body coordinates, m
    bool collide = false;            ///< whether the two bodies collide with each other
    bool enabled = true;             ///< false: it does nothing
    uint64_t user_data = 0;          ///< a number of the host, without effect
    float break_force = infinity;    ///< N: `Joint::set_break_force`
    float break_torque = infinity;   ///< N m
    float report_force = infinity;   ///< N: `Joint::set_report_force`
    float report_torque = infinity;  ///< N m
    float constraint_hertz = 0.0f;   ///< `Joint::set_constraint_hertz`
    float constraint_damping_ratio = 2.0f;      ///< `Joint::set_constraint_damping_ratio`
    std::optional<float> reference_angle = {};  ///< rad; none: the current angle is held
    float hertz = infinity;                     ///< stiffness at the point; infinity: rigid
    float damping_ratio = 0.0f;                 ///< of the spring, at least 0; 1: no swinging
    float angular_hertz = infinity;             ///< of the angle; infinity: rigid
    float angular_damping_ratio = 0.0f;         ///< of the angle, at least 0
};

/// Drives b relative to a, with a limited force and torque.
struct MotorJointDef {
    static constexpr JointType type = JointType::motor;  ///< the type of joint that it defines
    BodyId body_a = {};              ///< the default is the world: anchor in world coordinates
    BodyId body_b = {};              ///< the same for body b; not both may be the world
    Position anchor_a = {};          ///< body coordinates, m
    Position anchor_b = {};          ///< body coordinates, m
    bool collide = false;            ///< whether the two bodies collide with each other
    bool enabled = true;             ///< false: it does nothing
    uint64_t user_data = 0;          ///< a number of the host, without effect
    float break_force = infinity;    ///< N: `Joint::set_break_force`
    float break_torque = infinity;   ///< N m
    float report_force = infinity;   ///< N: `Joint::set_report_force`
    float report_torque = infinity;  ///< N m
    float constraint_hertz = 0.0f;   ///< `Joint::set_constraint_hertz`
    float constraint_damping_ratio = 2.0f;     ///< `Joint::set_constraint_damping_ratio`
    Vec2 linear_velocity = {};                 ///< m/s, of anchor b, coordinates of a
    float angular_velocity = 0.0f;             ///< rad/s
    float max_force = 0.0f;                    ///< N
    float max_torque = 0.0f;                   ///< N m
    Vec2 linear_offset = {};                   ///< m, of anchor b from anchor a, coordinates of a
    std::optional<float> angular_offset = {};  ///< rad; none: the current angle
    float hertz = 0.0f;                        ///< stiffness to the offsets; 0: velocities only
    float damping_ratio = 1.0f;                ///< of that stiffness, at least 0
};

/// A rope from a over two wheels of the world to b.
struct PulleyJointDef {
    static constexpr JointType type = JointType::pulley;  ///< the type of joint that it defines
    BodyId body_a = {};              ///< the default is the world: anchor in world coordinates
    BodyId body_b = {};              ///< the same for body b; not both may be the world
    Position anchor_a = {};          ///< body coordinates, m
    Position anchor_b = {};          ///< body coordinates, m
    bool collide = false;            ///< whether the two bodies collide with each other
    bool enabled = true;             ///< false: it does nothing
    uint64_t user_data = 0;          ///< a number of the host, without effect
    float break_force = infinity;    ///< N: `Joint::set_break_force`
    float break_torque = infinity;   ///< N m
    float report_force = infinity;   ///< N: `Joint::set_report_force`
    float report_torque = infinity;  ///< N m
    float constraint_hertz = 0.0f;   ///< `Joint::set_constraint_hertz`
    float constraint_damping_ratio = 2.0f;  ///< `Joint::set_constraint_damping_ratio`
    Position ground_a = {-1.0f, 1.0f};      ///< the wheel above a; world, m
    Position ground_b = {1.0f, 1.0f};       ///< the wheel above b
    float ratio = 1.0f;                     ///< force on b divided by the force on a
    std::optional<float> length = {};       ///< m, with `ratio` times the part at b; none: taut now
};

/// Rotates b with a.
struct GearJointDef {
    static constexpr JointType type = JointType::gear;  ///< the type of joint that it defines
    BodyId body_a = {};              ///< the default is the world: anchor in world coordinates
    BodyId body_b = {};              ///< the same for body b; not both may be the world
    Position anchor_a = {};          ///< body coordinates, m
    Position anchor_b = {};          ///< body coordinates, m
    bool collide = false;            ///< whether the two bodies collide with each other
    bool enabled = true;             ///< false: it does nothing
    uint64_t user_data = 0;          ///< a number of the host, without effect
    float break_force = infinity;    ///< N: `Joint::set_break_force`
    float break_torque = infinity;   ///< N m
    float report_force = infinity;   ///< N: `Joint::set_report_force`
    float report_torque = infinity;  ///< N m
    float constraint_hertz = 0.0f;   ///< `Joint::set_constraint_hertz`
    float constraint_damping_ratio = 2.0f;  ///< `Joint::set_constraint_damping_ratio`
    float ratio = 1.0f;                     ///< rotation of b divided by the rotation of a
    std::optional<float> phase = {};        ///< rad; none: that of the current angles
};

/// A pin of b in a groove of a that begins at anchor a.
struct GrooveJointDef {
    static constexpr JointType type = JointType::groove;  ///< the type of joint that it defines
    BodyId body_a = {};              ///< the default is the world: anchor in world coordinates
    BodyId body_b = {};              ///< the same for body b; not both may be the world
    Position anchor_a = {};          ///< body coordinates, m
    Position anchor_b = {};          ///< body coordinates, m
    bool collide = false;            ///< whether the two bodies collide with each other
    bool enabled = true;             ///< false: it does nothing
    uint64_t user_data = 0;          ///< a number of the host, without effect
    float break_force = infinity;    ///< N: `Joint::set_break_force`
    float break_torque = infinity;   ///< N m
    float report_force = infinity;   ///< N: `Joint::set_report_force`
    float report_torque = infinity;  ///< N m
    float constraint_hertz = 0.0f;   ///< `Joint::set_constraint_hertz`
    float constraint_damping_ratio = 2.0f;  ///< `Joint::set_constraint_damping_ratio`
    Position end = {1.0f, 0.0f};            ///< of the groove, coordinates of a, m
};

/// A pin of b in a straight slot of a.
struct PinSlotJointDef {
    static constexpr JointType type = JointType::pin_slot;  ///< the type of joint that it defines
    BodyId body_a = {};              ///< the default is the world: anchor in world coordinates
    BodyId body_b = {};              ///< the same for body b; not both may be the world
    Position anchor_a = {};          ///< body coordinates, m
    Position anchor_b = {};          ///< body coordinates, m
    bool collide = false;            ///< whether the two bodies collide with each other
    bool enabled = true;             ///< false: it does nothing
    uint64_t user_data = 0;          ///< a number of the host, without effect
    float break_force = infinity;    ///< N: `Joint::set_break_force`
    float break_torque = infinity;   ///< N m
    float report_force = infinity;   ///< N: `Joint::set_report_force`
    float report_torque = infinity;  ///< N m
    float constraint_hertz = 0.0f;   ///< `Joint::set_constraint_hertz`
    float constraint_damping_ratio = 2.0f;  ///< `Joint::set_constraint_damping_ratio`
    Vec2 axis = {1.0f, 0.0f};               ///< coordinates of a, of any length but 0
    float lower_translation = -infinity;    ///< m
    float upper_translation = infinity;     ///< m
    float motor_speed = 0.0f;               ///< m/s, of b relative to a along the axis
    float max_motor_force = 0.0f;           ///< N; 0: no motor
    float hertz = 0.0f;                     ///< of a spring to `target_translation`; 0: no spring
    float damping_ratio = 0.0f;             ///< of the spring, at least 0; 1: no swinging
    float target_translation = 0.0f;        ///< m
};

/// Lets b rotate relative to a in one direction only.
struct RatchetJointDef {
    static constexpr JointType type = JointType::ratchet;  ///< the type of joint that it defines
    BodyId body_a = {};              ///< the default is the world: anchor in world coordinates
    BodyId body_b = {};              ///< the same for body b; not both may be the world
    Position anchor_a = {};          ///< body coordinates, m
    Position anchor_b = {};          ///< body coordinates, m
    bool collide = false;            ///< whether the two bodies collide with each other
    bool enabled = true;             ///< false: it does nothing
    uint64_t user_data = 0;          ///< a number of the host, without effect
    float break_force = infinity;    ///< N: `Joint::set_break_force`
    float break_torque = infinity;   ///< N m
    float report_force = infinity;   ///< N: `Joint::set_report_force`
    float report_torque = infinity;  ///< N m
    float constraint_hertz = 0.0f;   ///< `Joint::set_constraint_hertz`
    float constraint_damping_ratio = 2.0f;      ///< `Joint::set_constraint_damping_ratio`
    std::optional<float> reference_angle = {};  ///< rad; none: the current angle counts as 0
    float tooth = 0.0f;                         ///< rad between teeth; 0: it holds at any angle
    bool backwards = false;                     ///< true: b rotates freely clockwise
};

/// The two bodies do not collide with each other; nothing else.
struct FilterJointDef {
    static constexpr JointType type = JointType::filter;  ///< the type of joint that it defines
    BodyId body_a = {};              ///< the default is the world: anchor in world coordinates
    BodyId body_b = {};              ///< the same for body b; not both may be the world
    Position anchor_a = {};          ///< body coordinates, m
    Position anchor_b = {};          ///< body coordinates, m
    bool collide = false;            ///< whether the two bodies collide with each other
    bool enabled = true;             ///< false: it does nothing
    uint64_t user_data = 0;          ///< a number of the host, without effect
    float break_force = infinity;    ///< N: `Joint::set_break_force`
    float break_torque = infinity;   ///< N m
    float report_force = infinity;   ///< N: `Joint::set_report_force`
    float report_torque = infinity;  ///< N m
    float constraint_hertz = 0.0f;   ///< `Joint::set_constraint_hertz`
    float constraint_damping_ratio = 2.0f;  ///< `Joint::set_constraint_damping_ratio`
};

/// Keeps the angle of b relative to a between two angles, wherever the bodies are.
struct RotaryLimitJointDef {
    static constexpr JointType type =
        JointType::rotary_limit;     ///< the type of joint that it defines
    BodyId body_a = {};              ///< the default is the world: anchor in world coordinates
    BodyId body_b = {};              ///< the same for body b; not both may be the world
    Position anchor_a = {};          ///< body coordinates, m
    Position anchor_b = {};          ///< body coordinates, m
    bool collide = false;            ///< whether the two bodies collide with each other
    bool enabled = true;             ///< false: it does nothing
    uint64_t user_data = 0;          ///< a number of the host, without effect
    float break_force = infinity;    ///< N: `Joint::set_break_force`
    float break_torque = infinity;   ///< N m
    float report_force = infinity;   ///< N: `Joint::set_report_force`
    float report_torque = infinity;  ///< N m
    float constraint_hertz = 0.0f;   ///< `Joint::set_constraint_hertz`
    float constraint_damping_ratio = 2.0f;      ///< `Joint::set_constraint_damping_ratio`
    std::optional<float> reference_angle = {};  ///< rad; none: the current angle counts as 0
    float lower_angle = -infinity;              ///< rad
    float upper_angle = infinity;               ///< rad
};

}  // namespace fettle::physics

FETTLE_PHYSICS_END
