/* Contacts as they were in the last step. */

#pragma once

#include <fettle/physics_c/basics.h>

FETTLE_PHYSICS_C_BEGIN

/** A point of a contact. */
typedef struct fettle_contact_point {
    fettle_position point; /* world, m */
    float separation;      /* m, negative: overlap */
    float normal_impulse;  /* N s in one sub-step */
    float tangent_impulse; /* N s in one sub-step */
    uint32_t feature;      /* identifies the vertex and edge between steps */
} fettle_contact_point;

/** A contact between two shapes. One of the bodies may be the border of the world. */
typedef struct fettle_contact {
    fettle_id body_a, body_b;        /* of these shapes */
    fettle_id shape_a, shape_b;      /* that touch */
    fettle_vec2 normal;              /* from a to b */
    float friction;                  /* mixed */
    float restitution;               /* mixed */
    float normal_force;              /* N, mean over the last sub-step, sum of both points */
    int32_t point_count;             /* 1 or 2 */
    fettle_contact_point points[2];  /* the first point_count of them */
    uint32_t part_a, part_b;         /* segment of a chain or piece of a concave polygon, from 0 */
    uint32_t material_a, material_b; /* of the shapes, or of the segments of chains */
} fettle_contact;

FETTLE_PHYSICS_C_END
