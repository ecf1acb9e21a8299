/* Points of the world in double precision: for libraries and programs that are built with
 * FETTLE_PHYSICS_DOUBLE. Lengths and vectors are single precision. */

#pragma once

#include <fettle/physics_c/export.h>

FETTLE_PHYSICS_C_BEGIN

/** One coordinate of a point of the world, m. */
typedef double fettle_coordinate;

/** A point of the world, m. */
typedef struct fettle_position {
    double x, y; /* to the right and upwards */
} fettle_position;

/** Another name, so that a program and a library of different precision do not link. */
#define fettle_world_create fettle_world_create_double
/** As `fettle_world_create`. */
#define fettle_replay_create fettle_replay_create_double

FETTLE_PHYSICS_C_END
