/* Events of the last step and of the edits before it. Ids of destroyed objects are dangling on
 * purpose: they can still be compared, so a listener knows which object was destroyed. */

#pragma once

#include <fettle/physics_c/basics.h>

FETTLE_PHYSICS_C_BEGIN

/** A touch that begins or continues, or an impact. */
typedef struct fettle_contact_event {
    fettle_id shape_a, shape_b; /* the normal points away from a */
    fettle_id body_a, body_b;   /* of these shapes */
    fettle_position point;      /* world, m: middle of the manifold */
    fettle_vec2 normal;         /* from a to b */
    float speed;                /* m/s, along the normal (begin, hit: at which the shapes meet) */
    float impulse;              /* N s: that stops the approach (persist: of the last step) */
    float friction;             /* mixed */
    float restitution;          /* mixed */
    uint32_t part_a, part_b;    /* segment of a chain or piece of a concave polygon, from 0 */
    uint32_t material_a, material_b; /* of the shapes, or of the segments of chains */
} fettle_contact_event;

/** Two shapes no longer touch. */
typedef struct fettle_contact_end_event {
    fettle_id shape_a, shape_b; /* that touched */
    fettle_id body_a, body_b;   /* of these shapes */
} fettle_contact_end_event;

/** A shape has entered a sensor, or has left it. */
typedef struct fettle_sensor_event {
    fettle_id sensor, visitor;           /* shapes */
    fettle_id sensor_body, visitor_body; /* of these shapes */
} fettle_sensor_event;

/** A joint had more load than its break_force or break_torque; it no longer acts. */
typedef struct fettle_joint_break_event {
    fettle_id joint;          /* which bore the load */
    fettle_id body_a, body_b; /* 0: the world */
    fettle_vec2 force;        /* N, on body b, mean over the step */
    float torque;             /* N m, on body b, without the torque of the force */
} fettle_joint_break_event;

/** A joint had more load than its report_force or report_torque. */
typedef struct fettle_joint_load_event {
    fettle_id joint;          /* which bore the load */
    fettle_id body_a, body_b; /* 0: the world */
    fettle_vec2 force;        /* N, on body b, mean over the step */
    float torque;             /* N m, on body b, without the torque of the force */
} fettle_joint_load_event;

/** Arrays, each with its length. */
typedef struct fettle_events {
    const fettle_contact_event* contact_begin;   /* touches that began */
    const fettle_contact_event* contact_persist; /* only with persist_events */
    const fettle_contact_end_event* contact_end; /* touches that ended */
    const fettle_contact_event* contact_hit;     /* for shapes with hit_events */
    const fettle_sensor_event* sensor_begin;     /* shapes that entered a sensor */
    const fettle_sensor_event* sensor_end;       /* shapes that left a sensor */
    const fettle_joint_break_event* joint_broke; /* joints that broke */
    const fettle_joint_load_event* joint_loaded; /* above report_force or report_torque */
    const fettle_id* slept;                      /* bodies */
    const fettle_id* woke;                       /* bodies */
    uint32_t contact_begin_count;                /* length of contact_begin */
    uint32_t contact_persist_count;              /* length of contact_persist */
    uint32_t contact_end_count;                  /* length of contact_end */
    uint32_t contact_hit_count;                  /* length of contact_hit */
    uint32_t sensor_begin_count;                 /* length of sensor_begin */
    uint32_t sensor_end_count;                   /* length of sensor_end */
    uint32_t joint_broke_count;                  /* length of joint_broke */
    uint32_t joint_loaded_count;                 /* length of joint_loaded */
    uint32_t slept_count;                        /* length of slept */
    uint32_t woke_count;                         /* length of woke */
} fettle_events;

/** The events. The arrays belong to the world and are valid until the next call of this function
   for it, or until it is destroyed: stepping and editing do not change them. */
fettle_code fettle_world_events(fettle_world* world, fettle_events* events);

FETTLE_PHYSICS_C_END
