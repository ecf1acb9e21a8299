/* Direct access to poses and velocities of all bodies, without copies and without a call for each
 * body. */

#pragma once

#include <fettle/physics_c/contact.h>

FETTLE_PHYSICS_C_BEGIN

/** State of a body that changes in each step. */
typedef struct fettle_body_state {
    fettle_position position; /* of the origin, m */
    float angle;              /* rad, not wrapped */
    float angular_velocity;   /* rad/s */
    fettle_vec2 velocity;     /* of the center of mass, m/s */
    float cosine, sine;       /* of the angle */
} fettle_body_state;

/** Arrays of a world. A body has the index fettle_slot(id) in them, which does not change while it
    lives. Slot 0 belongs to the world; what is in a free slot has no meaning. */
typedef struct fettle_columns {
    const fettle_body_state* states; /* now */
    const fettle_pose* previous;     /* before the last step */
    uint32_t body_slots;             /* length of both */
} fettle_columns;

/** The arrays themselves: they show every step and every edit. The pointers are valid until a body
   is created, or the world is restored, assigned, taken or destroyed. Writing through them is not
    allowed. */
fettle_code fettle_world_columns(const fettle_world* world, fettle_columns* columns);

/** Touching contacts of the last step, sleeping ones included. A list: see basics.h. */
fettle_code fettle_world_contacts(const fettle_world* world, fettle_contact* out, uint32_t room,
                                  uint32_t* count);

/** Whether two shapes touch; false if one of them does not exist. */
fettle_code fettle_world_is_touching(const fettle_world* world, fettle_id shape_a,
                                     fettle_id shape_b, bool* is_touching);

/** Contacts of two shapes that touch, one for each touching part. A list: see basics.h. */
fettle_code fettle_world_contacts_of(const fettle_world* world, fettle_id shape_a,
                                     fettle_id shape_b, fettle_contact* out, uint32_t room,
                                     uint32_t* count);

/** Two shapes that touch have no contact until they have separated; no callback is called for them.
   It has no effect on shapes that are apart. */
fettle_code fettle_world_ignore_until_separated(fettle_world* world, fettle_id shape_a,
                                                fettle_id shape_b);

/** A number of the host for two shapes that touch, without effect; 0 if there is none. It is kept
    while their touch lasts, and can still be read after the step that reports the end of the
   contact. A touch that a callback or fettle_world_ignore_until_separated ends has ended, although
   the shapes overlap. If a touch begins in the step in which another of the same shapes ends, it
   takes over the number. It belongs to the state of the world. FETTLE_INVALID if a number is set
   for shapes that do not touch; 0 removes it and is always allowed. */
fettle_code fettle_world_contact_data(const fettle_world* world, fettle_id shape_a,
                                      fettle_id shape_b, uint64_t* user_data);
fettle_code fettle_world_set_contact_data(fettle_world* world, fettle_id shape_a, fettle_id shape_b,
                                          uint64_t user_data);

/** One element of a column. FETTLE_STALE if the slot is free or does not exist. */
fettle_code fettle_world_state(const fettle_world* world, uint32_t slot, fettle_body_state* state);
fettle_code fettle_world_previous(const fettle_world* world, uint32_t slot, fettle_pose* pose);
fettle_code fettle_world_mass(const fettle_world* world, uint32_t slot, float* mass);
fettle_code fettle_world_velocity(const fettle_world* world, uint32_t slot, fettle_vec2* velocity);

/** The id of the body or shape in a slot; 0 if the slot is free or does not exist. */
fettle_code fettle_world_body_in(const fettle_world* world, uint32_t slot, fettle_id* body);
fettle_code fettle_world_shape_in(const fettle_world* world, uint32_t slot, fettle_id* shape);

/** Number of slots, free ones included. */
fettle_code fettle_world_body_slots(const fettle_world* world, uint32_t* body_slots);
fettle_code fettle_world_shape_slots(const fettle_world* world, uint32_t* shape_slots);

/** Numbers of a body that are written by slot. */
enum fettle_body_number {
    FETTLE_NUMBER_ANGULAR_VELOCITY = 0,
    FETTLE_NUMBER_TORQUE = 1,
    FETTLE_NUMBER_GRAVITY_SCALE = 2,
    FETTLE_NUMBER_LINEAR_DAMPING = 3,
    FETTLE_NUMBER_ANGULAR_DAMPING = 4
};

/** Result of writing by slot. */
enum fettle_written {
    FETTLE_WRITTEN_SAME = 0, /* the value was there already */
    FETTLE_WRITTEN_DONE = 1, /* the value is written */
    FETTLE_WRITTEN_REFUSED =
        2 /* nothing is written: call the setter of body.h, which wakes the body */
};

/** The fast way to set a value of an awake body: no callback, no allocation. The ranges are those
   of body.h. `written`: one of fettle_written. FETTLE_STALE if the slot is free or does not exist.
 */
fettle_code fettle_world_write(fettle_world* world, uint32_t slot, int32_t number, float value,
                               int32_t* written);
fettle_code fettle_world_write_velocity(fettle_world* world, uint32_t slot, float x, float y,
                                        int32_t* written);

/** Sets a velocity (m/s, finite) and wakes the body; `moves` is false, and nothing is done, if it
    does not move by itself. FETTLE_STALE if the slot is free or does not exist. */
fettle_code fettle_world_set_velocity(fettle_world* world, uint32_t slot, float x, float y,
                                      bool* moves);

/* --- many worlds at once, for learning and for search --- */

/** Steps worlds one after the other; all are checked before the first step. */
fettle_code fettle_worlds_step(fettle_world* const* worlds, uint32_t world_count, float dt);

/** Copies states of bodies: `bodies` has `body_count` ids for each world, world after world, and
    `states` gets as many states in the same order. Writes nothing unless all ids are valid. */
fettle_code fettle_worlds_read_states(const fettle_world* const* worlds, uint32_t world_count,
                                      const fettle_id* bodies, uint32_t body_count,
                                      fettle_body_state* states);

/** Applies a force (N, finite) to each of these bodies, for the next step only; `bodies` as above,
   as many forces in the same order. Applies none unless all are valid. */
fettle_code fettle_worlds_apply_forces(fettle_world* const* worlds, uint32_t world_count,
                                       const fettle_id* bodies, uint32_t body_count,
                                       const fettle_vec2* forces);

FETTLE_PHYSICS_C_END
