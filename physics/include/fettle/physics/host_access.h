#pragma once

#include <fettle/physics/export.h>
#include <fettle/physics/function.h>
#include <fettle/physics/world.h>

#include <cstdint>
#include <span>
#include <vector>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// Result of writing a number or a velocity by slot. `same`: the value was there already. `done`:
/// the value is written. `refused`: nothing is written, and the setter of `Body` must be called
/// instead. Reasons: the slot is free, the body sleeps, does not move by itself, has a mass or
/// shapes that were edited since the last step, or the world is locked (callbacks.h). Writing calls
/// no callback and allocates nothing.
enum class Written : uint8_t { same, done, refused };

/// Numbers of a body that hosts write by slot, named like the setters of `Body`. These setters
/// document the ranges; writing by slot does not check them.
enum class BodyNumber : uint8_t {
    /// `Body::set_angular_velocity`
    angular_velocity,
    /// `Body::set_torque`
    torque,
    /// `Body::set_gravity_scale`
    gravity_scale,
    /// `Body::set_linear_damping`
    linear_damping,
    /// `Body::set_angular_damping`
    angular_damping
};

/// The data that a read updates: all edited data, or the derived data of one body or shape.
struct Refresh {
    /// The data that is updated.
    enum class Of : uint8_t { everything, body, shape };
    Of of = Of::everything;  ///< what is updated
    uint32_t slot = 0;       ///< of the body or shape
};
/// Called before a read updates edited data: `HostAccess::on_refresh`.
using RefreshCallback = Function<void(const Refresh&)>;

/// Access to the objects of a world by their slots, for hosts that store slots instead of handles:
/// a property tree, an interface to another language. Other programs do not need it.
///
/// A slot is `BodyId::index`, which does not change while the body lives; slot 0 belongs to the
/// world. A slot beyond the last one is an error: functions that read throw std::invalid_argument,
/// and functions that write do nothing. Nothing checks that a body lives in the slot: what is read
/// from a free slot has no meaning. A reference or a span is valid until the next body is created,
/// or until the world gets another state.
class HostAccess {
  public:
    HostAccess() = delete;  ///< it has only static functions

    /// Pose and velocities of a body.
    static const BodyState& state(const World& world, uint32_t slot) {
        return at(world.columns_->states, slot);
    }
    /// Pose of a body before the last step.
    static const Pose& previous(const World& world, uint32_t slot) {
        return at(world.columns_->previous, slot);
    }
    /// The states of all slots, free ones included.
    static std::span<const BodyState> states(const World& world) { return world.columns_->states; }
    /// The poses of all slots before the last step, free ones included.
    static std::span<const Pose> previous_poses(const World& world) {
        return world.columns_->previous;
    }
    static float mass(const World& world, uint32_t slot);     ///< kg
    static Vec2 velocity(const World& world, uint32_t slot);  ///< of the center of mass, m/s

    /// Sets the velocity of the center of mass, m/s, and wakes the body. Returns false and does
    /// nothing if the slot is free or the body does not move by itself. Throws `Locked` inside a
    /// function that the world is calling.
    static bool set_velocity(World& world, uint32_t slot, const Vec2& velocity);
    /// Writes a number, if that is possible without the setter of `Body`: see `Written`.
    template <BodyNumber number>
    static Written write(World& world, uint32_t slot, float value);
    /// Writes the velocity of the center of mass, m/s, in the same way.
    static Written write_velocity(World& world, uint32_t slot, const Vec2& velocity);

    /// Generation of the body in a slot; 0 if the slot is free or does not exist.
    static uint32_t body_generation(const World& world, uint32_t slot) {
        return generation(world.columns_->body_generations, slot);
    }
    /// As `body_generation`, for shapes.
    static uint32_t shape_generation(const World& world, uint32_t slot) {
        return generation(world.columns_->shape_generations, slot);
    }
    /// As `body_generation`, for joints.
    static uint32_t joint_generation(const World& world, uint32_t slot) {
        return generation(world.columns_->joint_generations, slot);
    }
    /// Number of slots of bodies, free ones included.
    static uint32_t body_slots(const World& world) {
        return uint32_t(world.columns_->body_generations.size());
    }
    /// Number of slots of shapes, free ones included.
    static uint32_t shape_slots(const World& world) {
        return uint32_t(world.columns_->shape_generations.size());
    }

    /// `callback` is called before a read updates edited data. The moment of this update affects
    /// all later results, to the last bit: to repeat edits exactly, repeat the same updates between
    /// them with `refresh`. Reads inside a step or inside the callback do not call it. Like the
    /// callbacks of `World`, it is not part of the state.
    static void on_refresh(World& world, RefreshCallback callback);
    /// True: the callbacks of mixing and before-solve run on the thread of the caller, also if
    /// `World::set_parallel_callbacks` permits others. For a host whose own callbacks call scripts.
    static void set_serial_callbacks(World& world, bool serial);
    /// Makes the update that a read would make; does nothing if nothing is out of date or the slot
    /// is free. `World::refresh` updates everything.
    static void refresh(World& world, const Refresh& wanted);

  private:
    [[noreturn]] static void refuse(uint32_t slot, size_t slots);
    template <class T>
    static const T& at(const std::vector<T>& column, uint32_t slot) {
        if (slot >= column.size()) [[unlikely]]
            refuse(slot, column.size());
        return column[slot];
    }
    static uint32_t generation(const std::vector<uint32_t>& generations, uint32_t slot) {
        return slot < generations.size() ? generations[slot] : 0;
    }
};

template <>
Written HostAccess::write<BodyNumber::angular_velocity>(World&, uint32_t slot, float value);
template <>
Written HostAccess::write<BodyNumber::torque>(World&, uint32_t slot, float value);
template <>
Written HostAccess::write<BodyNumber::gravity_scale>(World&, uint32_t slot, float value);
template <>
Written HostAccess::write<BodyNumber::linear_damping>(World&, uint32_t slot, float value);
template <>
Written HostAccess::write<BodyNumber::angular_damping>(World&, uint32_t slot, float value);

}  // namespace fettle::physics

FETTLE_PHYSICS_END
