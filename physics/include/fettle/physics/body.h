#pragma once

#include <fettle/physics/contact.h>
#include <fettle/physics/definitions.h>
#include <fettle/physics/export.h>
#include <fettle/physics/function.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

class Joint;
class Shape;
class World;
struct VelocityEdit;
struct PositionEdit;

/// Functions of the user that move a body: callbacks.h.
using VelocityFunction = Function<void(VelocityEdit&)>;
using PositionFunction = Function<void(PositionEdit&)>;

namespace detail {
struct FETTLE_PHYSICS_PRIVATE WorldLink;
}

/// A light handle (pointer and id) that can be copied freely. It may outlive its body and its
/// world. All methods except `is_valid`, `id`, `index` and comparison throw `std::invalid_argument`
/// if the handle is empty, or if the body or its world was destroyed. Setters throw
/// `std::invalid_argument`, with a message that contains the expectation, for invalid values (NaN,
/// a negative damping...), and `Locked` inside a function that the world is calling (callbacks.h);
/// they change nothing then. Every setter takes effect in the next step and wakes the bodies that
/// it affects. The body that carries the bounds of a world can be read like any other; its only
/// working setter is `set_user_data`.
class Body {
  public:
    Body() = default;                      ///< empty: it refers to no body
    inline Body(World* world, BodyId id);  ///< the body with this id

    bool is_valid() const noexcept;  ///< whether its world and its body exist
    explicit operator bool() const noexcept { return is_valid(); }  ///< as `is_valid`
    BodyId id() const noexcept { return id_; }                      ///< empty for an empty handle
    uint32_t index() const noexcept { return id_.index; }           ///< its slot: `BodyId::index`
    World& world() const;                                           ///< the world that it is in
    friend bool operator==(const Body&, const Body&) = default;
    void destroy();  ///< with its shapes and the joints on it

    BodyType type() const;  ///< what moves it
    void set_type(BodyType type);

    Position position() const;  ///< of the origin, m
    void set_position(const Position& position);
    float angle() const;  ///< rad, not wrapped
    void set_angle(float angle);
    void set_pose(const Pose& pose);  ///< sets both in one teleport
    /// Velocity of the center of mass, m/s. A step limits it to 10 000 m/s. A body that does not
    /// move by itself, because it is static or infinitely heavy, has no velocity, and setting one
    /// has no effect.
    Vec2 velocity() const;
    void set_velocity(const Vec2& velocity);
    /// Angular velocity, rad/s. A step limits it to 3 rad in each sub-step. Setting it has no
    /// effect on bodies on which `set_velocity` has none.
    float angular_velocity() const;
    void set_angular_velocity(float angular_velocity);
    /// Sets both velocities so that the next steps, which last `dt` (s) in all, bring it to
    /// `target`, if nothing disturbs it. Call it before each step for a platform that follows a
    /// path; the platform then carries and pushes other bodies. The angle is not wrapped: a target
    /// of a whole turn more turns it. Wakes it only if it is to move. No effect on bodies on which
    /// `set_velocity` has none.
    void set_target(const Pose& target, float dt);

    Vec2 force() const;  ///< N, applied at the center of mass in every step until changed
    void set_force(const Vec2& force);
    float torque() const;  ///< N m, applied in every step until changed
    void set_torque(float torque);
    void apply_force(const Vec2& force);  ///< for the next step only
    void apply_force(const Vec2& force,
                     const Position& world_point);  ///< N, at a point of the world, m
    void apply_torque(float torque);                ///< N m, for the next step only
    Vec2 applied_force() const;                     ///< N, sum of forces applied for the next step
    float applied_torque() const;                   ///< N m, about the center of mass
    void apply_impulse(const Vec2& impulse);        ///< N s: changes the velocity at once
    void apply_impulse(const Vec2& impulse,
                       const Position& world_point);  ///< N s, at a point of the world, m
    void apply_angular_impulse(float impulse);  ///< N m s: changes the angular velocity at once

    float gravity_scale() const;  ///< factor of the gravity of the world; may be negative
    void set_gravity_scale(float scale);
    float linear_damping() const;  ///< 1/s
    void set_linear_damping(float damping);
    float angular_damping() const;  ///< 1/s, at least 0
    void set_angular_damping(float damping);

    /// False: it takes no part in steps, touches nothing, is found by no query, and its joints do
    /// not act. It keeps its shapes, joints and velocity; forces and impulses have no effect on it.
    bool enabled() const;
    void set_enabled(bool enabled);  ///< wakes the bodies that it touched
    std::string name() const;        ///< for messages and tools; need not be unique
    /// At most 63 bytes without a zero; throws std::invalid_argument for others.
    void set_name(std::string_view name);
    /// Limit of the speed, m/s, above 0; infinity: only the limit of all bodies. Like locked axes,
    /// it also limits the velocity that a kinematic body was given. It holds in every sub-step. A
    /// world in which an awake body has one solves all contacts in one part.
    float max_speed() const;
    void set_max_speed(float speed);
    /// Called once in every step in which it is awake, after gravity, forces, fields and damping
    /// and before contacts and joints: it may set the velocity that they act on. An empty function:
    /// none. Like callbacks, the function belongs to the world and not to its state: a copy has
    /// none. It stays when the body is destroyed, since restoring a state may bring the body back,
    /// until a later body in the same slot gets one; an empty function releases it.
    void set_velocity_function(VelocityFunction function);
    /// Called at the end of every step at whose beginning it was awake: it may set the pose that it
    /// has after the step. Otherwise as `set_velocity_function`.
    void set_position_function(PositionFunction function);

    bool awake() const;          ///< whether steps move it
    void set_awake(bool awake);  ///< with its whole island
    bool can_sleep() const;      ///< whether it may fall asleep; false wakes it
    void set_can_sleep(bool can_sleep);
    /// It rests below this speed, m/s: its own value, or that of the world.
    float sleep_speed() const;
    void set_sleep_speed(std::optional<float> speed);   ///< none: that of the world
    std::optional<float> sleep_speed_override() const;  ///< its own value, m/s, at least 0
    bool bullet() const;  ///< whether it does not pass through moving bodies, either
    void set_bullet(bool bullet);
    bool locked_x() const;  ///< true: it does not move along x
    void set_locked_x(bool locked);
    bool locked_y() const;  ///< true: it does not move along y
    void set_locked_y(bool locked);
    bool locked_rotation() const;  ///< true: it does not rotate
    void set_locked_rotation(bool locked);

    /// Mass, kg: the override if there is one, otherwise the sum over the shapes. A dynamic body
    /// whose shapes have no mass has mass 1; it does not rotate, unless it has lines without
    /// thickness: then it is a wire. Static and kinematic bodies return the mass that they would
    /// have as dynamic bodies.
    float mass() const;
    void set_mass(
        std::optional<float> mass);  ///< none: from the shapes; infinity: does not move; else > 0
    std::optional<float> mass_override() const;  ///< kg; none: from the shapes
    float inertia() const;                       ///< kg m² about the center of mass
    void set_inertia(std::optional<float>
                         inertia);  ///< none: from the shapes; infinity: does not rotate; else > 0
    std::optional<float> inertia_override() const;  ///< kg m²; none: from the shapes
    /// Center of mass, body coordinates. A kinematic body turns about its position: its center is
    /// the origin, unless it was set.
    Vec2 center() const;
    void set_center(std::optional<Vec2> center);  ///< m; none: as above
    std::optional<Vec2> center_override() const;  ///< m; none: from the shapes
    Position world_center() const;                ///< center of mass, world, m
    float area() const;                           ///< m², sum over the shapes
    Aabb aabb() const;                            ///< of all shapes; the origin if there are none
    uint32_t rebuilds() const;  ///< how often mass, center and inertia were computed again

    /// Pose before the last step, for drawing between steps. A teleport changes it too, so that the
    /// body is not drawn between its old and its new place.
    Pose previous_pose() const;
    /// Pose at `fraction` (0: previous, 1: current) of the last step.
    Pose interpolated(float fraction) const;

    Position world_point(const Vec2& local) const;  ///< from body to world coordinates, m
    Vec2 local_point(const Position& world) const;  ///< from world to body coordinates, m
    Vec2 world_vector(const Vec2& local) const;  ///< rotates a direction of the body into the world
    Vec2 local_vector(const Vec2& world) const;  ///< rotates a direction of the world into the body
    Vec2 velocity_at(const Position& world_point) const;  ///< m/s, of its point that is there now
    float kinetic_energy() const;                         ///< J

    /// Attaches a new shape. Throws std::invalid_argument, with the reason, for a geometry or a
    /// value out of range.
    Shape add(const Geometry& geometry, const ShapeDef& def = {});
    uint32_t shape_count() const;       ///< number of its shapes
    std::vector<Shape> shapes() const;  ///< in the order they were attached

    std::vector<Joint> joints() const;  ///< on it, in no particular order

    bool is_touching() const;  ///< any contact, sleeping or not; sensors do not count
    std::vector<Contact> contacts()
        const;  ///< touching contacts of the last step, sleeping ones included

    uint64_t user_data() const;  ///< a number of the host, without effect; saved with the world
    void set_user_data(uint64_t value);

  private:
    friend class Shape;
    friend class Joint;

    detail::WorldLink* link_ = nullptr;
    BodyId id_;
};

}  // namespace fettle::physics

FETTLE_PHYSICS_END
