/* Draws a world with functions of the host: shapes, joints and contacts as outlines. */

#pragma once

#include <fettle/physics_c/basics.h>

FETTLE_PHYSICS_C_BEGIN

/** How to draw, and what. Colors are 0xRRGGBB. A null function: this is not drawn. callbacks.h
   describes what a function may do. */
typedef struct fettle_debug_draw {
    uint32_t size;
    bool shapes;        /* true */
    bool joints;        /* true */
    bool contacts;      /* false */
    bool boxes;         /* false; around shapes */
    bool centers;       /* false; of mass */
    bool has_region;    /* false; true: only bodies with shapes that overlap the region */
    fettle_aabb region; /* m; for instance the view of a camera */
    float fraction;     /* 1; pose between the previous (0) and the current one (1), finite */
    void* user;         /* null; passed to each function */
    /** An outline, counter-clockwise; `closed`: it goes back to its first point. */
    void (*polygon)(void* user, const fettle_position* points, uint32_t count, bool closed,
                    uint32_t color);
    /** A circle, with the angle of its body. */
    void (*circle)(void* user, fettle_position center, float radius, float angle, uint32_t color);
    /** A line between two points. */
    void (*segment)(void* user, fettle_position from, fettle_position to, uint32_t color);
    /** A point, to be drawn in a size of the host. */
    void (*point)(void* user, fettle_position at, uint32_t color);
    /** The color of a shape of a body. Null: it shows whether the shape is a sensor, and otherwise
        whether the body is static, kinematic, awake or asleep. */
    uint32_t (*color_of)(void* user, const fettle_world* world, fettle_id body, fettle_id shape);
} fettle_debug_draw;

/** Writes the defaults and `size`; all functions are null. FETTLE_INVALID unless `size` is the size
   of the structure. */
fettle_code fettle_debug_draw_init(fettle_debug_draw* draw, size_t size);

/** Calls the functions of `draw` for everything that is to be drawn. */
fettle_code fettle_world_draw(fettle_world* world, const fettle_debug_draw* draw);

FETTLE_PHYSICS_C_END
