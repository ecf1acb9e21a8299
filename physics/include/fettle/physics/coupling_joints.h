#pragma once

#include <fettle/physics/export.h>
#include <fettle/physics/joint.h>

// Joints that hold, drive or couple two bodies.

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// Holds two bodies together at a point and at an angle, rigidly or with springs.
class WeldJoint : public Joint {
  public:
    using Joint::Joint;

    /// rad, of b relative to a, minus the reference angle: held at 0. Whole turns do not count, so
    /// it is within half a turn.
    float angle() const;
    float reference_angle() const;  ///< rad, finite: angle of b relative to a that counts as 0
    void set_reference_angle(float angle);
    float hertz() const;  ///< stiffness at the point; infinity (the default): rigid; 0: not held
    void set_hertz(float hertz);
    float damping_ratio() const;  ///< of `hertz`, at least 0
    void set_damping_ratio(float ratio);
    float angular_hertz() const;  ///< of the angle; infinity (the default): rigid; 0: free
    void set_angular_hertz(float hertz);
    float angular_damping_ratio() const;  ///< of `angular_hertz`, at least 0
    void set_angular_damping_ratio(float ratio);
};

/// Drives b relative to a, with a limited force and torque: to a velocity, or with `hertz` to an
/// offset and an angle. With velocity 0 and without stiffness it acts as friction, as needed in a
/// top-down game.
class MotorJoint : public Joint {
  public:
    using Joint::Joint;

    Vec2 linear_velocity() const;  ///< m/s, of anchor b against anchor a, in the coordinates of a
    void set_linear_velocity(const Vec2& velocity);
    float angular_velocity() const;  ///< rad/s
    void set_angular_velocity(float velocity);
    float max_force() const;  ///< N; 0 (the default): none
    void set_max_force(float force);
    float max_torque() const;  ///< N m; 0 (the default): none
    void set_max_torque(float torque);
    Vec2 linear_offset() const;  ///< m, of anchor b from anchor a, in the coordinates of a
    void set_linear_offset(const Vec2& offset);
    float angular_offset() const;  ///< rad, of b relative to a
    void set_angular_offset(float angle);
    float hertz() const;  ///< stiffness to the offsets; 0 (the default): velocities only
    void set_hertz(float hertz);
    float damping_ratio() const;  ///< 1 by default
    void set_damping_ratio(float ratio);
};

/// A rope from a over two wheels of the world to b. It can only pull.
class PulleyJoint : public Joint {
  public:
    using Joint::Joint;

    Position ground_a() const;  ///< the wheel above a; world, m
    void set_ground_a(const Position& point);
    Position ground_b() const;  ///< the wheel above b; world, m
    void set_ground_b(const Position& point);
    float ratio() const;  ///< force on b divided by the force on a; b moves slower by this factor
    void set_ratio(float ratio);  ///< positive
    float length() const;         ///< m, of the part at a plus `ratio` times the part at b
    void set_length(float length);
    float length_now() const;  ///< m, length of the rope between both bodies; `length` when taut
    float length_a() const;    ///< m, from the wheel to anchor a now
    float length_b() const;    ///< m, from the wheel to anchor b now
    float tension() const;     ///< N, in the last step
};

/// Rotates b with a.
class GearJoint : public Joint {
  public:
    using Joint::Joint;

    /// Rotation of b divided by the rotation of a: -r_a/r_b for meshed wheels, r_a/r_b for a belt.
    float ratio() const;
    void set_ratio(float ratio);
    float phase() const;  ///< rad: angle of b minus `ratio` times the angle of a
    void set_phase(float phase);
    float phase_now() const;  ///< rad, the phase of the current angles
};

/// Lets b rotate relative to a in one direction only.
class RatchetJoint : public Joint {
  public:
    using Joint::Joint;

    float angle() const;            ///< rad, of b relative to a, minus the reference angle
    float reference_angle() const;  ///< rad, finite: angle of b relative to a that counts as 0
    void set_reference_angle(float angle);
    float tooth() const;  ///< rad between teeth; 0 (the default): the ratchet holds at any angle
    void set_tooth(float angle);
    bool backwards() const;  ///< true: b rotates freely clockwise, not counter-clockwise
    void set_backwards(bool backwards);
    float caught_angle() const;  ///< rad: b does not rotate back beyond this angle
};

/// The two bodies do not collide with each other. It does nothing else, so its anchors do not
/// matter, it does not keep bodies awake, and it never breaks.
class FilterJoint : public Joint {
  public:
    using Joint::Joint;
};

/// Keeps the angle of b relative to a between two angles, wherever the bodies are.
class RotaryLimitJoint : public Joint {
  public:
    using Joint::Joint;

    float angle() const;  ///< rad, of b relative to a, minus the reference angle; not wrapped
    float reference_angle() const;  ///< rad, finite: angle of b relative to a that counts as 0
    void set_reference_angle(float angle);
    float lower_angle() const;  ///< rad; -infinity (the default): no limit
    void set_lower_angle(float angle);
    float upper_angle() const;  ///< rad; infinity (the default): no limit. Used if the limits cross
    void set_upper_angle(float angle);
};

}  // namespace fettle::physics

FETTLE_PHYSICS_END
