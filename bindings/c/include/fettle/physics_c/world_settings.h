/* Settings of a world. Their defaults are those of fettle_world_def. Errors are those of basics.h.
 */

#pragma once

#include <fettle/physics_c/basics.h>

FETTLE_PHYSICS_C_BEGIN

/** m/s2; finite. The setter wakes all bodies. */
fettle_code fettle_world_gravity(const fettle_world* world, fettle_vec2* gravity);
fettle_code fettle_world_set_gravity(fettle_world* world, float x, float y);

/** Solver sub-steps a step, 1 to 64. A step that is longer than 1/60 s, or much longer than the
    last one, may get more of them. */
fettle_code fettle_world_substeps(const fettle_world* world, int32_t* substeps);
fettle_code fettle_world_set_substeps(fettle_world* world, int32_t substeps);

/** The number of sub-steps of the last step; 0 before the first step. */
fettle_code fettle_world_last_substeps(const fettle_world* world, int32_t* substeps);

/** Whether walls keep dynamic bodies inside, and where they are (m; zero if there are none). */
fettle_code fettle_world_bounds(const fettle_world* world, bool* is_set, fettle_aabb* bounds);

/** Walls at these coordinates (m, from -1e8 to 1e8, min below max); null: none. Wakes all bodies.
 */
fettle_code fettle_world_set_bounds(fettle_world* world, const fettle_aabb* bounds);

/** Of these walls; finite, at least 0. */
fettle_code fettle_world_bounds_friction(const fettle_world* world, float* bounds_friction);
fettle_code fettle_world_set_bounds_friction(fettle_world* world, float bounds_friction);

/** Of these walls, from 0 to 1. */
fettle_code fettle_world_bounds_restitution(const fettle_world* world, float* bounds_restitution);
fettle_code fettle_world_set_bounds_restitution(fettle_world* world, float bounds_restitution);

/** Whether resting islands fall asleep and cost no time; false wakes all bodies. */
fettle_code fettle_world_sleeping(const fettle_world* world, bool* sleeping);
fettle_code fettle_world_set_sleeping(fettle_world* world, bool sleeping);

/** Whether fast bodies do not pass through static ones. */
fettle_code fettle_world_continuous(const fettle_world* world, bool* continuous);
fettle_code fettle_world_set_continuous(fettle_world* world, bool continuous);

/** m/s; finite, at least 0. Slower impacts do not bounce. */
fettle_code fettle_world_restitution_threshold(const fettle_world* world,
                                               float* restitution_threshold);
fettle_code fettle_world_set_restitution_threshold(fettle_world* world,
                                                   float restitution_threshold);

/** m/s; finite, at least 0. Slower impacts make no hit event. */
fettle_code fettle_world_hit_threshold(const fettle_world* world, float* hit_threshold);
fettle_code fettle_world_set_hit_threshold(fettle_world* world, float hit_threshold);

/** m/s; finite, at least 0. An island slower than this for sleep_delay sleeps. */
fettle_code fettle_world_sleep_speed(const fettle_world* world, float* sleep_speed);
fettle_code fettle_world_set_sleep_speed(fettle_world* world, float sleep_speed);

/** s; finite, at least 0. */
fettle_code fettle_world_sleep_delay(const fettle_world* world, float* sleep_delay);
fettle_code fettle_world_set_sleep_delay(fettle_world* world, float sleep_delay);

/** Hz; finite, at least 0: frequency of a contact under load. The solver uses at most a quarter
    of the sub-step rate. */
fettle_code fettle_world_contact_hertz(const fettle_world* world, float* contact_hertz);
fettle_code fettle_world_set_contact_hertz(fettle_world* world, float contact_hertz);

/** Damping ratio of contacts; finite, at least 0. */
fettle_code fettle_world_contact_damping(const fettle_world* world, float* contact_damping);
fettle_code fettle_world_set_contact_damping(fettle_world* world, float contact_damping);

/** m/s; finite, at least 0: limit for pushing overlapping shapes apart. */
fettle_code fettle_world_push_speed(const fettle_world* world, float* push_speed);
fettle_code fettle_world_set_push_speed(fettle_world* world, float push_speed);

/** m/s; above 0, at most 1e4 (the default): no body, not even a kinematic one, is faster at the end
    of a step. Contacts may exceed it within the step; fettle_body_set_max_speed, which limits a
    single body, also excludes that. */
fettle_code fettle_world_max_speed(const fettle_world* world, float* max_speed);
fettle_code fettle_world_set_max_speed(fettle_world* world, float max_speed);

/** One of fettle_solver. The setter wakes all bodies. */
fettle_code fettle_world_solver(const fettle_world* world, int32_t* solver);
fettle_code fettle_world_set_solver(fettle_world* world, int32_t solver);

/** One of fettle_mix_rule. The setter wakes all bodies. */
fettle_code fettle_world_friction_mix(const fettle_world* world, int32_t* friction_mix);
fettle_code fettle_world_set_friction_mix(fettle_world* world, int32_t friction_mix);

/** One of fettle_mix_rule. The setter wakes all bodies. */
fettle_code fettle_world_restitution_mix(const fettle_world* world, int32_t* restitution_mix);
fettle_code fettle_world_set_restitution_mix(fettle_world* world, int32_t restitution_mix);

/** Whether every continuing touch is reported in every step. */
fettle_code fettle_world_persist_events(const fettle_world* world, bool* persist_events);
fettle_code fettle_world_set_persist_events(fettle_world* world, bool persist_events);

/** Number of threads that share the work of a step, the calling one included, 1 to 64. Changes no
   result. FETTLE_FAILED if the system provides fewer; then the number stays. */
fettle_code fettle_world_threads(const fettle_world* world, int32_t* threads);
fettle_code fettle_world_set_threads(fettle_world* world, int32_t threads);

/** A task of a step, to be called once with the context and its number. */
typedef void (*fettle_task)(void* context, uint32_t number);

/** Lets other threads call `task` for the numbers 0 to `count` - 1, without waiting for them. On
   the thread that steps, a task returns at once. */
typedef void (*fettle_start_tasks)(void* user, uint32_t count, fettle_task task, void* context);

/** Returns when all tasks have returned; after this none may be called any more. */
typedef void (*fettle_finish_tasks)(void* user);

/** Threads of the host do the work of steps: `threads` tasks, 1 to 64, of which the calling thread
    does one. Each step calls `start` once and then `finish` once. It changes no result. Both
    functions null: one thread. A host that cannot start its threads lets `start` return without
    them: the step needs no task to run. The functions must not jump out. What a C++ function throws
    makes the step FETTLE_FAILED: after `start`, no step was made; after `finish`, the whole step
    was made, and the world steps on one thread until this function is called again. */
fettle_code fettle_world_set_scheduler(fettle_world* world, fettle_start_tasks start,
                                       fettle_finish_tasks finish, void* user, int32_t threads);

/** Largest number of values that are computed at a time: 4, 8 or 16. Changes no result. */
fettle_code fettle_world_limit_simd_width(fettle_world* world, int32_t most);

FETTLE_PHYSICS_C_END
