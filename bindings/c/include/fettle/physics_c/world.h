/* Worlds: their life, their steps, their objects and their snapshots. */

#pragma once

#include <fettle/physics_c/definitions.h>
#include <fettle/physics_c/joint_definitions.h>

FETTLE_PHYSICS_C_BEGIN

/** A new world; a null def stands for the defaults. */
fettle_code fettle_world_create(const fettle_world_def* def, fettle_world** world);

/** Destroys the world with all its objects. FETTLE_LOCKED inside a function that it is calling,
   except for one of fettle_world_after_step. Null is allowed and does nothing. */
fettle_code fettle_world_destroy(fettle_world* world);

/** Advances by `dt` seconds; does nothing unless it is positive and finite; NaN is refused. */
fettle_code fettle_world_step(fettle_world* world, float dt);

/** Calls `function` once with `user`, when the running step has ended; outside of a step: after the
    next one. It may edit the world, so a callback can order an edit by it. It may also destroy the
    world; the functions that were to be called after it are not called then. */
typedef void (*fettle_after_step)(void* user, fettle_world* world);
fettle_code fettle_world_after_step(fettle_world* world, fettle_after_step function, void* user);

/** Reserves memory for this number of objects at least, each at most 2^24. */
fettle_code fettle_world_reserve(fettle_world* world, uint32_t bodies, uint32_t shapes,
                                 uint32_t contacts, uint32_t joints);

/** Wakes all bodies. */
fettle_code fettle_world_wake_all(fettle_world* world);

/** Destroys every body, shape, joint and field. */
fettle_code fettle_world_clear(fettle_world* world);

/* --- objects; the out parameter for the id may be null --- */

/** A body; a null def stands for the defaults. */
fettle_code fettle_world_create_body(fettle_world* world, const fettle_body_def* def,
                                     fettle_id* body);

/** A detached shape; a null def stands for the defaults. fettle_body_add makes one on a body. */
fettle_code fettle_world_create_shape(fettle_world* world, const fettle_geometry* geometry,
                                      const fettle_shape_def* def, fettle_id* shape);

/** A field of force. */
fettle_code fettle_world_create_field(fettle_world* world, const fettle_field_def* def,
                                      fettle_id* field);

/** A dormant joint of one of fettle_joint_type, to be set and then connected (joint.h). */
fettle_code fettle_world_create_joint(fettle_world* world, int32_t type, uint64_t user_data,
                                      fettle_id* joint);

/** A dormant joint with the settings and user data of another one, of any world (`of`). */
fettle_code fettle_world_create_joint_like(fettle_world* world, const fettle_world* of,
                                           fettle_id like, fettle_id* joint);

/** Drags a point of a body towards a target. */
fettle_code fettle_world_create_mouse_joint(fettle_world* world, const fettle_mouse_joint_def* def,
                                            fettle_id* joint);

/** A rod of the current length. */
fettle_code fettle_world_create_distance_joint(fettle_world* world,
                                               const fettle_distance_joint_def* def,
                                               fettle_id* joint);

/** A pin; the current angle counts as 0. */
fettle_code fettle_world_create_revolute_joint(fettle_world* world,
                                               const fettle_revolute_joint_def* def,
                                               fettle_id* joint);

/** A slider; holds the current angle. */
fettle_code fettle_world_create_prismatic_joint(fettle_world* world,
                                                const fettle_prismatic_joint_def* def,
                                                fettle_id* joint);

/** A sprung wheel (b) of a vehicle (a). */
fettle_code fettle_world_create_wheel_joint(fettle_world* world, const fettle_wheel_joint_def* def,
                                            fettle_id* joint);

/** Holds point and current angle. */
fettle_code fettle_world_create_weld_joint(fettle_world* world, const fettle_weld_joint_def* def,
                                           fettle_id* joint);

/** A drive or friction; the current angle is its offset. */
fettle_code fettle_world_create_motor_joint(fettle_world* world, const fettle_motor_joint_def* def,
                                            fettle_id* joint);

/** A rope over two wheels of the world. */
fettle_code fettle_world_create_pulley_joint(fettle_world* world,
                                             const fettle_pulley_joint_def* def, fettle_id* joint);

/** Rotates b with a. */
fettle_code fettle_world_create_gear_joint(fettle_world* world, const fettle_gear_joint_def* def,
                                           fettle_id* joint);

/** A pin of b in a groove of a. */
fettle_code fettle_world_create_groove_joint(fettle_world* world,
                                             const fettle_groove_joint_def* def, fettle_id* joint);

/** A pin of b in a straight slot of a. */
fettle_code fettle_world_create_pin_slot_joint(fettle_world* world,
                                               const fettle_pin_slot_joint_def* def,
                                               fettle_id* joint);

/** Lets b rotate in one direction only; the current angle counts as 0. */
fettle_code fettle_world_create_ratchet_joint(fettle_world* world,
                                              const fettle_ratchet_joint_def* def,
                                              fettle_id* joint);

/** The two bodies do not collide with each other; it does nothing else. */
fettle_code fettle_world_create_filter_joint(fettle_world* world,
                                             const fettle_filter_joint_def* def, fettle_id* joint);

/** Keeps the angle of b relative to a between two angles; the current angle counts as 0. */
fettle_code fettle_world_create_rotary_limit_joint(fettle_world* world,
                                                   const fettle_rotary_limit_joint_def* def,
                                                   fettle_id* joint);

/** Ids of all live objects in slot order, without the border of the world. Lists: see basics.h. */
fettle_code fettle_world_bodies(const fettle_world* world, fettle_id* out, uint32_t room,
                                uint32_t* count);
fettle_code fettle_world_shapes(const fettle_world* world, fettle_id* out, uint32_t room,
                                uint32_t* count);
fettle_code fettle_world_joints(const fettle_world* world, fettle_id* out, uint32_t room,
                                uint32_t* count);
fettle_code fettle_world_fields(const fettle_world* world, fettle_id* out, uint32_t room,
                                uint32_t* count);

/** Bodies that have another pose than before the last step, in slot order. Lists: see basics.h. */
fettle_code fettle_world_moved_bodies(const fettle_world* world, fettle_id* out, uint32_t room,
                                      uint32_t* count);

/** Number of live objects. */
fettle_code fettle_world_body_count(const fettle_world* world, uint32_t* body_count);
fettle_code fettle_world_shape_count(const fettle_world* world, uint32_t* shape_count);
fettle_code fettle_world_joint_count(const fettle_world* world, uint32_t* joint_count);

/* --- snapshots: the complete state, with the same ids and the same future, bit for bit --- */

/** A copy of the world, without its callbacks and owner. Ids are valid in both. */
fettle_code fettle_world_clone(const fettle_world* world, fettle_world** clone);

/** Gives the world the state of another one: ids valid there are valid here again. Callbacks and
    owner stay. */
fettle_code fettle_world_assign(fettle_world* world, const fettle_world* from);

/** As fettle_world_assign, without copying; `from`, another world, is empty afterwards. */
fettle_code fettle_world_take(fettle_world* world, fettle_world* from);

/** The complete state as bytes with a checksum, the same on every machine. They belong to the world
   and are valid until the next save of it, or until it is destroyed. */
fettle_code fettle_world_save(fettle_world* world, const void** bytes, size_t* size);

/** Restores a saved state. FETTLE_INVALID, and nothing changes, if a byte was changed, removed or
    added, or if another version wrote it. `bytes` may be what fettle_world_save of it gave. */
fettle_code fettle_world_restore(fettle_world* world, const void* bytes, size_t size);

/** Hash of position, angle and velocities of all bodies. Equal histories have equal hashes. */
fettle_code fettle_world_hash(const fettle_world* world, uint64_t* hash);

/* --- measuring and checking --- */

/** What a step did. Times are in ms. */
typedef struct fettle_statistics {
    uint64_t steps;           /* since the world was created */
    uint32_t bodies;          /* of all types */
    uint32_t awake_bodies;    /* dynamic and moving kinematic ones */
    uint32_t shapes;          /* detached ones, too */
    uint32_t joints;          /* without dormant ones */
    uint32_t awake_joints;    /* joints that a step processes */
    uint32_t contacts;        /* pairs whose fat boxes overlap */
    uint32_t awake_contacts;  /* contacts that a step processes */
    uint32_t touching;        /* awake contacts with a manifold that was solved */
    uint32_t islands;         /* sleeping islands */
    uint32_t moved_proxies;   /* proxies that left their fat box */
    uint32_t direct_solves;   /* complementarity problems that the direct solver solved */
    uint32_t direct_failures; /* such problems that were solved by sweeps instead */
    float edits_ms;           /* derived data of edited bodies and shapes */
    float pairs_ms;           /* broad phase */
    float narrow_ms;          /* manifolds */
    float solve_ms;           /* prepare, sub-steps, store */
    float finish_ms;          /* poses, boxes, continuous collision */
    float sleep_ms;           /* islands */
    float total_ms;           /* the whole step */
} fettle_statistics;

/** Statistics of the last step. */
fettle_code fettle_world_statistics(const fettle_world* world, fettle_statistics* statistics);

/** Heap memory of a world for one purpose. */
typedef struct fettle_memory_share {
    const char* purpose; /* lives as long as the library */
    uint64_t used;       /* bytes in use */
    uint64_t reserved;   /* bytes, including reserved room */
} fettle_memory_share;

/** Heap memory by purpose. A list: see basics.h. */
fettle_code fettle_world_memory(const fettle_world* world, fettle_memory_share* out, uint32_t room,
                                uint32_t* count);

/** Checks that the world is consistent: a null fault, or a description of the first one, which is
    valid until the next check of it or until it is destroyed. For tests: slow. */
fettle_code fettle_world_validate(fettle_world* world, const char** fault);

FETTLE_PHYSICS_C_END
