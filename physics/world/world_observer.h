#pragma once

#include <fettle/physics/callbacks.h>
#include <state/world_state.h>

#include <span>

// The interface through which a world reports its changes to a recording (physics/recording).

namespace fettle::physics::detail {

/// The result of a user function in a step, and the objects that it was called for.
struct Answer {
    enum class To : uint8_t { filter, mixing, before_solve, velocity, position };
    uint64_t about_a = 0, about_b = 0;  ///< the two shapes, or the body and 0: generation and slot
    To to = To::filter;
    bool given = true;    ///< false: the function threw
    bool first = true;    ///< the filter's answer; `ContactEdit::enabled`
    bool second = false;  ///< `ContactEdit::ignored`
    uint32_t unused = 0;
    /// The members of the edit that may be set, in their order.
    WorldCoordinate values[4] = {};
};
static_assert(sizeof(Answer) == 24 + 4 * sizeof(WorldCoordinate));

/// The functions of the user that a step may call.
struct Callbacks {
    bool filter = false, mixing = false, before_solve = false;
};

/// A body with functions of its own: `Body::set_velocity_function`.
struct BodyFunctions {
    BodyId body;
    VelocityFunction velocity = {};
    PositionFunction position = {};
    bool moves = false;  ///< it was awake at the beginning of the step
};

/// Receives the changes of a world. If `step_begins` or `step_ends` throws, it is removed.
class WorldObserver {
  public:
    WorldObserver() = default;
    WorldObserver(const WorldObserver&) = delete;
    WorldObserver& operator=(const WorldObserver&) = delete;
    virtual ~WorldObserver();
    /// A method that edits was called, and is about to check its arguments.
    virtual void edit_called(const char* of, const char* function) = 0;
    virtual void step_begins(const WorldState& state, const Callbacks& callbacks,
                             std::span<const BodyFunctions> functions, float dt) = 0;
    virtual void answered(const Answer& answer) = 0;
    /// `hash`: of the poses and velocities after the step.
    virtual void step_ends(const WorldState& state, uint64_t hash) = 0;
};

inline uint64_t key_of(ShapeId id) {
    return uint64_t{id.generation} << 32 | id.index;
}
inline uint64_t key_of(BodyId id) {
    return uint64_t{id.generation} << 32 | id.index;
}
inline Answer answer_of(const ContactEdit& edit, Answer::To to) {
    return {key_of(edit.shape_a.id()),
            key_of(edit.shape_b.id()),
            to,
            true,
            edit.enabled,
            edit.ignored,
            0,
            {edit.friction, edit.restitution, edit.surface_speed}};
}

}  // namespace fettle::physics::detail
