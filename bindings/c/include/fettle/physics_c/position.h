/* Vectors, and points of the world. */

#pragma once

#include <fettle/physics_c/export.h>

#ifdef FETTLE_PHYSICS_DOUBLE
#include <fettle/physics_c/double_position.h>
#endif

FETTLE_PHYSICS_C_BEGIN

/** A vector, or a point in the coordinates of a body, in m unless its user says otherwise. */
typedef struct fettle_vec2 {
    float x, y; /* to the right and upwards */
} fettle_vec2;

#ifndef FETTLE_PHYSICS_DOUBLE
/** A point of the world, m. Where the library was built with FETTLE_PHYSICS_DOUBLE, it has double
    precision. */
typedef fettle_vec2 fettle_position;
/** One coordinate of a point of the world, m. */
typedef float fettle_coordinate;
#endif

FETTLE_PHYSICS_C_END
