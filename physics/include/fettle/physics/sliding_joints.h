#pragma once

#include <fettle/physics/export.h>
#include <fettle/physics/joint.h>

// Joints between a point of body b and a line on body a. `axis` is the direction of the line in the
// coordinates of a, with any length except 0; the line passes through anchor a.

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// Lets b slide along an axis of a without rotating: a drawer, a piston, a lift.
class PrismaticJoint : public Joint {
  public:
    using Joint::Joint;

    Vec2 axis() const;  ///< coordinates of a, of any length but 0
    void set_axis(const Vec2& axis);
    float translation() const;        ///< m, of anchor b from anchor a along the axis now
    float lower_translation() const;  ///< m; -infinity (the default): no limit
    void set_lower_translation(float translation);
    float upper_translation()
        const;  ///< m; infinity (the default): no limit. Used if the limits cross
    void set_upper_translation(float translation);
    float motor_speed() const;  ///< m/s, of b relative to a along the axis
    void set_motor_speed(float speed);
    float max_motor_force() const;  ///< N; 0 (the default): no motor
    void set_max_motor_force(float force);
    float motor_force() const;  ///< N, force of the motor in the last step
    float hertz() const;        ///< spring to `target_translation`; 0 (the default): none
    void set_hertz(float hertz);
    float damping_ratio() const;  ///< of the spring, at least 0
    void set_damping_ratio(float ratio);
    float target_translation() const;  ///< m
    void set_target_translation(float translation);
    /// rad, of b relative to a, minus the reference angle: held at 0. Whole turns do not count, so
    /// it is within half a turn.
    float angle() const;
    float reference_angle() const;  ///< rad, finite: angle of b relative to a that is held
    void set_reference_angle(float angle);
};

/// A pin of b in a straight slot of a: it slides like a prismatic joint, and rotates freely.
class PinSlotJoint : public Joint {
  public:
    using Joint::Joint;

    Vec2 axis() const;  ///< coordinates of a, of any length but 0
    void set_axis(const Vec2& axis);
    float translation() const;        ///< m, of anchor b from anchor a along the axis now
    float lower_translation() const;  ///< m; -infinity (the default): no limit
    void set_lower_translation(float translation);
    float upper_translation()
        const;  ///< m; infinity (the default): no limit. Used if the limits cross
    void set_upper_translation(float translation);
    float motor_speed() const;  ///< m/s, of b relative to a along the axis
    void set_motor_speed(float speed);
    float max_motor_force() const;  ///< N; 0 (the default): no motor
    void set_max_motor_force(float force);
    float motor_force() const;  ///< N, force of the motor in the last step
    float hertz() const;        ///< spring to `target_translation`; 0 (the default): none
    void set_hertz(float hertz);
    float damping_ratio() const;  ///< of the spring, at least 0
    void set_damping_ratio(float ratio);
    float target_translation() const;  ///< m, where the spring is at rest
    void set_target_translation(float translation);
};

/// A pin of b in a groove of a that begins at anchor a and ends at `end`.
class GrooveJoint : public Joint {
  public:
    using Joint::Joint;

    Position end() const;  ///< in the coordinates of a
    void set_end(const Position& end);
    float translation() const;  ///< m, of the pin from the beginning of the groove
};

/// A wheel (b) of a vehicle (a): sprung along the axis, which is (0, 1) by default, and driven
/// about its axle.
class WheelJoint : public Joint {
  public:
    using Joint::Joint;

    Vec2 axis() const;  ///< coordinates of a, of any length but 0
    void set_axis(const Vec2& axis);
    float translation() const;  ///< m, of the axle from the rest position of the spring
    float hertz() const;        ///< of the suspension; 4 by default; 0: no suspension
    void set_hertz(float hertz);
    float damping_ratio() const;  ///< 0.7 by default
    void set_damping_ratio(float ratio);
    float lower_translation() const;  ///< m; -infinity (the default): no limit
    void set_lower_translation(float translation);
    float upper_translation()
        const;  ///< m; infinity (the default): no limit. Used if the limits cross
    void set_upper_translation(float translation);
    float motor_speed() const;  ///< rad/s, of the wheel relative to the vehicle
    void set_motor_speed(float speed);
    float max_motor_torque() const;  ///< N m; 0 (the default): no motor
    void set_max_motor_torque(float torque);
    float motor_torque() const;  ///< N m, torque of the motor in the last step
};

}  // namespace fettle::physics

FETTLE_PHYSICS_END
