/* Functions of the host that a world calls, and the owner of a world.
 *
 * `user` is the pointer that was given with the function. A function may read the world and make
 * queries of it. Functions that edit, step, restore, assign, clear or destroy the world, or that
 * set a callback, are refused with FETTLE_LOCKED inside it, and so are saving, copying and
 * fettle_world_validate inside a step, and saving and fettle_world_validate inside a visitor and a
 * function that draws. Other worlds are not affected. It runs on the thread of the
 * caller, and must return: it must not jump out or throw past the library (an exception of a C++
 * function is caught, and the call of the world gives FETTLE_FAILED after it is complete).
 *
 * Callbacks and owner are not part of snapshots: copying, saving and restoring do not change those
 * of a world, and a clone has none. */

#pragma once

#include <fettle/physics_c/basics.h>

FETTLE_PHYSICS_C_BEGIN

/** A contact about to be solved. The members from `friction` to `ignored` may be set; the first
    four of them are valid for the step. */
typedef struct fettle_contact_edit {
    fettle_id shape_a, shape_b;      /* the normal points from a to b */
    fettle_position point;           /* world, m: middle of the manifold of the deepest part */
    fettle_vec2 normal;              /* from a to b */
    float speed;                     /* m/s, approach speed along the normal */
    float impulse;                   /* N s, normal impulse of the last step */
    float separation;                /* m, negative when the shapes overlap */
    float friction;                  /* mixed; 0 or more; NaN changes nothing */
    float restitution;               /* mixed; 0 to 1 */
    float surface_speed;             /* mixed; m/s */
    bool enabled;                    /* false: no contact in this step */
    bool ignored;                    /* true: no contact until the shapes have separated */
    uint32_t part_a, part_b;         /* segment of a chain or piece of a concave polygon, from 0 */
    uint32_t material_a, material_b; /* of the shapes, or of the segments of chains */
} fettle_contact_edit;

/** What a refresh updates. */
enum fettle_refresh_of {
    FETTLE_REFRESH_EVERYTHING = 0,
    FETTLE_REFRESH_BODY = 1,
    FETTLE_REFRESH_SHAPE = 2
};

/** Whether two shapes whose filters agree may collide. */
typedef bool (*fettle_pair_filter)(void* user, const fettle_world* world, fettle_id shape_a,
                                   fettle_id shape_b);
/** Edits a contact that is about to be solved. */
typedef void (*fettle_contact_callback)(void* user, const fettle_world* world,
                                        fettle_contact_edit* contact);
/** `of`: one of fettle_refresh_of; `slot`: of the body or shape. */
typedef void (*fettle_refresh_callback)(void* user, const fettle_world* world, int32_t of,
                                        uint32_t slot);

/** Called for every pair of shapes whose boxes begin to overlap, and again after an edit of a
 * filter. Setting it calls it for all pairs. A null function: none. */
fettle_code fettle_world_set_filter(fettle_world* world, fettle_pair_filter function, void* user);

/** Mixes the surfaces of every contact in every step, after the mix rules; called for each touching
    part of an outline. A null function: none. */
fettle_code fettle_world_set_mixing(fettle_world* world, fettle_contact_callback function,
                                    void* user);

/** Called for every contact before it is solved, once for two shapes. A null function: none. */
fettle_code fettle_world_set_before_solve(fettle_world* world, fettle_contact_callback function,
                                          void* user);

/** True: the last two functions are called on all threads that work on a step, for several contacts
    at a time and in no order. They must be safe to run so and must not destroy the world, and
    fettle_world_after_step is refused in them. What they set is taken in the order of the contacts:
    if that depends on nothing but what they get, so do the results. False, as at first: on the
    thread of the caller, one after the other. */
fettle_code fettle_world_set_parallel_callbacks(fettle_world* world, bool parallel_callbacks);
fettle_code fettle_world_parallel_callbacks(const fettle_world* world, bool* parallel_callbacks);

/** The motion of a body in a step, before contacts and joints act. The last two members may be
    set; they are limited, and NaN changes nothing. */
typedef struct fettle_velocity_edit {
    fettle_id body;         /* whose function is called */
    float dt;               /* s, length of the step */
    fettle_vec2 before;     /* m/s, before the step */
    float angular_before;   /* rad/s, before the step */
    fettle_vec2 velocity;   /* m/s, after gravity, forces, fields and damping of this step */
    float angular_velocity; /* rad/s, the same */
} fettle_velocity_edit;

/** The pose of a body at the end of a step. The last member may be set; it is limited, and NaN
    changes nothing. */
typedef struct fettle_position_edit {
    fettle_id body;     /* whose function is called */
    float dt;           /* s, length of the step */
    fettle_pose before; /* before the step */
    fettle_pose pose;   /* after the step */
} fettle_position_edit;

/** May set the velocity of a body. */
typedef void (*fettle_velocity_function)(void* user, const fettle_world* world,
                                         fettle_velocity_edit* edit);
/** May set the pose of a body. */
typedef void (*fettle_position_function)(void* user, const fettle_world* world,
                                         fettle_position_edit* edit);

/** Called once in every step in which the body is awake, before contacts and joints: it may set the
    velocity that they act on. The change is spread evenly over the sub-steps, so that the body
   rests on others as under a force. The function stays set when the body is destroyed, since
   restoring a state may create the body again. A null function: none. */
fettle_code fettle_body_set_velocity_function(fettle_world* world, fettle_id body,
                                              fettle_velocity_function function, void* user);

/** Called at the end of every step at whose beginning the body was awake: it may set its pose. A
    null function: none. */
fettle_code fettle_body_set_position_function(fettle_world* world, fettle_id body,
                                              fettle_position_function function, void* user);

/** Called before a read updates edited data. A null function: none. */
fettle_code fettle_world_on_refresh(fettle_world* world, fettle_refresh_callback function,
                                    void* user);

/** Makes the update that a read would make: of everything, or of the body or shape in a slot. Does
    nothing if nothing is out of date or the slot is free. */
fettle_code fettle_world_refresh(fettle_world* world, int32_t of, uint32_t slot);

/** Whether the world is calling a function now. */
fettle_code fettle_world_locked(const fettle_world* world, bool* locked);

/** For a host that keeps data for every object of a world. Once a world has an owner, objects can
   be created and destroyed, and their user data set, only while the owner acts: otherwise these
   calls give FETTLE_LOCKED. */
typedef struct fettle_owner fettle_owner;
/** Called when the world may be edited again. */
typedef void (*fettle_unlocked_callback)(void* user);

/** An owner. `advice` is copied to the end of messages, as in "delete the entity instead". */
fettle_code fettle_owner_create(const char* advice, fettle_owner** owner);

/** Called at the end of a step, an edit or a query in which a world of the owner called functions.
   A null function: none. */
fettle_code fettle_owner_on_unlocked(fettle_owner* owner, fettle_unlocked_callback function,
                                     void* user);

/** FETTLE_LOCKED while a world has this owner, or while it acts. The pointer is refused afterwards,
   as that of a world is. */
fettle_code fettle_owner_destroy(fettle_owner* owner);

/** Between begin and end, calls count as calls by the owner. They may be nested; an end without a
    begin is FETTLE_INVALID. */
fettle_code fettle_owner_begin(fettle_owner* owner);
fettle_code fettle_owner_end(fettle_owner* owner);

/** Whether the owner acts, and the advice in its messages, which lives as long as the owner. */
fettle_code fettle_owner_acts(const fettle_owner* owner, bool* acts);
fettle_code fettle_owner_advice(const fettle_owner* owner, const char** advice);

/** Sets the owner of a world; null: every caller may create and destroy. */
fettle_code fettle_world_set_owner(fettle_world* world, fettle_owner* owner);

FETTLE_PHYSICS_C_END
