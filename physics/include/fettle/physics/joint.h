#pragma once

#include <fettle/physics/body.h>
#include <fettle/physics/export.h>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

namespace detail {
struct FETTLE_PHYSICS_PRIVATE WorldData;
}

/// A light handle to a joint between two bodies, or between one body and the world. Errors as for
/// `Body`. Every setter wakes both bodies and takes effect in the next step. Destroying a body
/// destroys its joints. As an argument or a result, `Body()` means the world.
class Joint {
  public:
    Joint() = default;  ///< empty: it refers to no joint
    inline Joint(World* world,
                 JointId id);  ///< the joint with this id; its type is not checked

    bool is_valid() const noexcept;  ///< whether its world and its joint exist
    explicit operator bool() const noexcept { return is_valid(); }  ///< as `is_valid`
    JointId id() const noexcept { return id_; }                     ///< empty for an empty handle
    World& world() const;                                           ///< the world that it is in
    friend bool operator==(const Joint&, const Joint&) = default;
    void destroy();  ///< its bodies stay and wake

    JointType type() const;             ///< decides which settings it has
    Body body_a() const;                ///< `Body()`: the world
    void set_body_a(const Body& body);  ///< keeps the anchor's body coordinates; must not be body b
    Body body_b() const;                ///< `Body()`: the world
    void set_body_b(const Body& body);
    /// Sets both bodies in one edit; one of them may be the world.
    void connect(const Body& a, const Body& b);
    /// Removes both bodies from the joint. It is dormant then: it does nothing, keeps its settings,
    /// and outlives the bodies that it had.
    void disconnect();
    bool dormant() const;       ///< has no bodies; then both are the world
    Position anchor_a() const;  ///< body coordinates, m
    void set_anchor_a(const Position& anchor);
    Position anchor_b() const;  ///< body coordinates, m
    void set_anchor_b(const Position& anchor);
    Position world_anchor_a() const;  ///< world, m
    Position world_anchor_b() const;  ///< world, m
    bool enabled() const;             ///< whether it acts, unless it is broken or dormant
    void set_enabled(bool enabled);   ///< a disabled joint does nothing at all
    bool collide() const;             ///< whether the two bodies collide with each other
    void set_collide(bool collide);   ///< whether the two bodies collide with each other
    /// Force limit, N: if the mean force over a step is higher, the joint breaks. Then it has no
    /// effect, as if disabled, and `Events::joint_broke` reports it. Infinity (the default): it
    /// never breaks.
    float break_force() const;
    void set_break_force(float force);
    float break_torque() const;  ///< N m
    void set_break_torque(float torque);
    /// N: in each step in which the mean force is higher, `Events::joint_loaded` reports it; the
    /// joint keeps acting. Infinity (the default): never.
    float report_force() const;
    void set_report_force(float force);
    float report_torque() const;  ///< N m
    void set_report_torque(float torque);
    /// Stiffness of the joint itself, Hz: how fast it corrects an error of its position; limited to
    /// a quarter of the rate of sub-steps. 0 (the default): 60 Hz, and more where the joint
    /// connects bodies of very different masses. The solver `direct` ignores it and holds joints
    /// exactly.
    float constraint_hertz() const;
    void set_constraint_hertz(float hertz);
    /// 0 … 1000; 2 by default. Only with a `constraint_hertz`.
    float constraint_damping_ratio() const;
    void set_constraint_damping_ratio(float ratio);
    bool broken() const;           ///< whether its load was above its limits; then it does nothing
    void set_broken(bool broken);  ///< false repairs the joint
    Vec2 force() const;            ///< N, on body b in the last step
    float torque() const;          ///< N m, on body b; excludes the torque of the force
    /// How far the anchors are from where the joint should hold them now, m: the error of its rigid
    /// parts and its limits; springs and motors have none. 0 for a dormant joint.
    float separation() const;
    float angular_separation() const;  ///< rad

    uint64_t user_data() const;  ///< a number of the host, without effect
    void set_user_data(uint64_t value);

  protected:
    detail::WorldData& live() const;
    template <class Data>
    Data& settings_as() const;
    /// Settings for an edit; wakes the bodies. `of` and `function`: type and method that the user
    /// called, for messages.
    template <class Data>
    Data& edit(const char* of, const char* function) const;
    float per_substep(float impulse) const;  ///< impulse of a sub-step to force or torque

  private:
    friend class World;
    detail::WorldData& edited(const char* function) const;
    uint32_t end_at(uint32_t side, const Body& body) const;
    void set_body(uint32_t side, const Body& body, const char* function);

    detail::WorldLink* link_ = nullptr;
    JointId id_;
};

/// Drags a point of a body softly towards a target.
class MouseJoint : public Joint {
  public:
    using Joint::Joint;

    Body body() const { return body_b(); }          ///< the body that is dragged
    void set_body(const Body& body);                ///< keeps the anchor; must not be the world
    Position anchor() const { return anchor_b(); }  ///< body coordinates, m
    void set_anchor(const Position& anchor);
    Position target() const { return anchor_a(); }  ///< world, m
    void set_target(const Position& target);
    float hertz() const;          ///< stiffness; 5 by default
    void set_hertz(float hertz);  ///< 0: no pull
    float damping_ratio() const;  ///< of the stiffness or spring, at least 0
    void set_damping_ratio(float ratio);
    float max_force() const;  ///< N
    void set_max_force(float force);
};

/// A rod, a rope or a spring between two points.
class DistanceJoint : public Joint {
  public:
    using Joint::Joint;

    float length() const;  ///< m, of the rod, or of the spring at rest
    void set_length(float length);
    float min_length() const;  ///< m; above `max_length`, `max_length` is used instead
    void set_min_length(float length);
    float max_length() const;  ///< m; infinity: no limit
    void set_max_length(float length);
    float hertz() const;  ///< infinity (the default): a rod; 0: free between the limits
    void set_hertz(float hertz);
    float damping_ratio() const;  ///< of the spring; 1 comes to rest without swinging
    void set_damping_ratio(float ratio);
    /// N: the spring does not pull with more than this; 0 or negative, -infinity by default. A rod
    /// ignores it.
    float lower_spring_force() const;
    void set_lower_spring_force(float force);
    float upper_spring_force() const;  ///< N, of pushing; 0 or positive, infinity by default
    void set_upper_spring_force(float force);
    float motor_speed() const;  ///< m/s, of the distance; a rod has no motor
    void set_motor_speed(float speed);
    float max_motor_force() const;  ///< N; 0 (the default): no motor
    void set_max_motor_force(float force);
    float motor_force() const;  ///< N, force of the motor in the last step; positive pushes apart
    float distance() const;     ///< m, between the anchors now
};

/// Holds two points together; the bodies rotate about this point.
class RevoluteJoint : public Joint {
  public:
    using Joint::Joint;

    /// Angle of b relative to a, rad, minus the reference angle; not wrapped. Limits and spring
    /// refer to this angle.
    float angle() const;
    float reference_angle() const;  ///< rad, finite: angle of b relative to a that counts as 0
    void set_reference_angle(float angle);
    float lower_angle() const;  ///< rad; -infinity (the default): no limit
    void set_lower_angle(float angle);
    float upper_angle() const;  ///< rad; infinity (the default): no limit. Used if the limits cross
    void set_upper_angle(float angle);
    float motor_speed() const;  ///< rad/s, of b relative to a
    void set_motor_speed(float speed);
    float max_motor_torque() const;  ///< N m; 0 (the default): no motor
    void set_max_motor_torque(float torque);
    float hertz() const;  ///< of a spring towards `target_angle`; 0 (the default): no spring
    void set_hertz(float hertz);
    float damping_ratio() const;  ///< of the stiffness or spring, at least 0
    void set_damping_ratio(float ratio);
    float target_angle() const;  ///< rad
    void set_target_angle(float angle);
    float motor_torque() const;  ///< N m, torque of the motor in the last step
};

}  // namespace fettle::physics

FETTLE_PHYSICS_END
