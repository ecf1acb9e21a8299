#pragma once

#include <fettle/physics/events.h>
#include <sleep/rocking.h>
#include <state/active_lists.h>
#include <state/step_scratch.h>
#include <state/world_state.h>

// Sleeping. Awake objects are listed. A sleeping body is in an island with all bodies that fell
// asleep with it; it costs nothing in a step and wakes with the whole island. Islands are found by
// union-find over the active contacts and joints, and only in steps in which some body has rested
// long enough: permanent updates would cost more.

namespace fettle::physics::detail {

/// Data that change when objects wake or fall asleep, and the list for their events.
struct Activity {
    ObjectState& objects;
    Columns& columns;
    ActiveLists& active;
    Events& events;  ///< events of the step, or of the edits after it
};

void wake_sleeping(const Activity& activity, uint32_t body);  ///< with its island
inline void wake_body(const Activity& activity, uint32_t body) {
    BodyRecord& record = activity.objects.bodies[body];
    if (record.asleep()) {
        wake_sleeping(activity, body);
    } else {
        record.sleep_time = 0.0f;
        end_stay(activity.active.stays, body);
    }
}
/// Wakes the bodies that the body touches or has a joint with.
void wake_touching(const Activity& activity, uint32_t body);
void wake_joint(const Activity& activity, uint32_t joint);
/// Wakes the sleeping bodies that have a joint with a body that moves.
void wake_jointed(const Activity& activity);
void wake_all(const Activity& activity);

/// The bodies become the members of `island`. The caller removes them from the lists of awake
/// objects.
void put_to_sleep(const Activity& activity, std::span<const uint32_t> bodies, uint32_t island);
/// Puts the body to sleep with all bodies that it touches or is joined to.
void put_group_to_sleep(const Activity& activity, uint32_t body);
/// `candidates`: number of bodies that have rested long enough. A body with a driven motion does
/// not rest, however slow it is: a kinematic body with a velocity, a body that a motor moves, and a
/// body that a belt carries.
void sleep_resting_islands(const Activity& activity, const JointScratch& joints,
                           const WorldDef& settings, uint32_t candidates, uint64_t step,
                           float& since_search);
/// For solvers that correct positions without velocities: a body is not at rest if it
/// moved faster than its sleep speed in the step of `dt` (s), whatever its velocity is.
void keep_pushed_awake(ObjectState& objects, const ActiveLists& active, const BodyScratch& bodies,
                       const WorldDef& settings, float dt);

void leave_island(ObjectState& objects, uint32_t body);
/// True if the body is awake; a kinematic body must also have a velocity.
bool in_motion(const ObjectState& objects, const Columns& columns, uint32_t body);

}  // namespace fettle::physics::detail
