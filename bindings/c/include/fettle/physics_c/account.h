/* What changed the velocity of a body in the last step: for tools that explain a motion. Errors are
 * those of basics.h. */

#pragma once

#include <fettle/physics_c/basics.h>

FETTLE_PHYSICS_C_BEGIN

/** The part of a contact of two shapes in the change of a velocity. Objects that were destroyed
    since the step have dangling ids. */
typedef struct fettle_contact_share {
    fettle_id own;       /* the shape of the body */
    fettle_id other;     /* the shape that it touches */
    fettle_id body;      /* of `other`; it may be the border of the world */
    fettle_vec2 impulse; /* N s, on the body of `own` */
    fettle_vec2 change;  /* m/s */
    float twist;         /* N m s, about the center of mass of that body */
    float turn;          /* rad/s */
} fettle_contact_share;

/** The part of a joint in the change of a velocity. */
typedef struct fettle_joint_share {
    fettle_id joint;     /* on the body */
    fettle_vec2 impulse; /* N s, on the body */
    fettle_vec2 change;  /* m/s */
    float twist;         /* N m s, about its center of mass */
    float turn;          /* rad/s */
} fettle_joint_share;

/** The changes of the angular velocity of a body in a step, besides those by contacts and joints.
 */
typedef struct fettle_turn_account {
    float earlier; /* rad/s at the end of the step before; `before` if it is unknown */
    float before;  /* rad/s at the start of the step */
    float after;   /* rad/s at its end */
    float torque;  /* rad/s, as all that follow; by the torque of the body */
    float applied; /* by fettle_body_apply_torque, and by forces beside the center of mass */
    float fields;  /* by fields of force */
    float damping; /* by damping */
    float rest; /* other changes: limits of speed, bounces of curved shapes, the reaction of joints
                   to an impact, rounding */
    float size; /* the sum of the sizes of all changes, also of those that cancel */
} fettle_turn_account;

/** The changes of the velocity of a body in a step. `after` minus `before` is their sum, with the
    shares of contacts and joints. */
typedef struct fettle_velocity_account {
    fettle_vec2 earlier; /* m/s at the end of the step before; `before` if it is unknown */
    fettle_vec2 before;  /* m/s at the start of the step */
    fettle_vec2 after;   /* m/s at its end */
    fettle_vec2 gravity; /* m/s, as all that follow */
    fettle_vec2 force;   /* by the force of the body */
    fettle_vec2 applied; /* by fettle_body_apply_force */
    fettle_vec2 fields;  /* by fields of force */
    fettle_vec2 damping; /* by linear damping */
    fettle_vec2 rest; /* other changes: locked axes, limits of speed, the reaction of joints to an
                         impact, rounding */
    fettle_turn_account turn; /* of the angular velocity */
} fettle_velocity_account;

/** From the next step on, adds up what changes the velocity of this body; other results do not
    depend on that. A world keeps eight accounts: with one more, the one that began first ends.
    Accounts are for the solver FETTLE_SOLVER_SOFT_STEP, and no part of snapshots. */
fettle_code fettle_world_keep_account(fettle_world* world, fettle_id body);

/** The account of a body for the last step. False in `is_set`, and zeros, if it was not kept, or if
    the body was asleep or does not move by forces. */
fettle_code fettle_world_account(const fettle_world* world, fettle_id body, bool* is_set,
                                 fettle_velocity_account* account);

/** The shares of contacts and of joints in this account; none if there is no account. Lists: see
    basics.h. */
fettle_code fettle_world_account_contacts(const fettle_world* world, fettle_id body,
                                          fettle_contact_share* out, uint32_t room,
                                          uint32_t* count);
fettle_code fettle_world_account_joints(const fettle_world* world, fettle_id body,
                                        fettle_joint_share* out, uint32_t room, uint32_t* count);

FETTLE_PHYSICS_C_END
