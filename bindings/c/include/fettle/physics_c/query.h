/* Queries for shapes. They include every edit made before them, and the order of their results is
 * repeatable. `filter` may be null: then everything but sensors is found. Coordinates
 * are from -1e8 to 1e8 m.
 *
 * Each query exists with a list and with a visitor. A visitor is called for each result and returns
 * whether to go on; callbacks.h describes what it may do. `user` is passed on to it. */

#pragma once

#include <fettle/physics_c/definitions.h>

FETTLE_PHYSICS_C_BEGIN

/** Called for each shape that passes the rest of a filter; false: it is not found. */
typedef bool (*fettle_accept)(void* user, const fettle_world* world, fettle_id shape);

/** The shapes that a query finds. */
typedef struct fettle_query_filter {
    uint32_t size;
    int32_t group;        /* 0; same non-zero group: positive is found, negative is not */
    uint64_t category;    /* all bits; a shape's mask must contain one of these bits */
    uint64_t mask;        /* all bits; a shape must have one of these categories */
    fettle_accept accept; /* null: all pass */
    void* user;           /* null; for accept */
    bool sensors;         /* false; true: find sensors, too */
} fettle_query_filter;

/** Writes the defaults and `size`. FETTLE_INVALID unless `size` is the size of the structure. */
fettle_code fettle_query_filter_init(fettle_query_filter* filter, size_t size);

/** Where a ray or a cast shape meets a shape. */
typedef struct fettle_ray_hit {
    fettle_id shape;       /* that was found */
    fettle_position point; /* world, m */
    fettle_vec2 normal; /* outward; opposite to the motion if a cast shape overlaps at the start */
    float fraction;     /* 0 at the start of the ray, 1 at its end */
} fettle_ray_hit;

/** A point on a shape. */
typedef struct fettle_point_hit {
    fettle_id shape;       /* that was found */
    fettle_position point; /* on its surface; the query point if that is inside */
    fettle_vec2 normal;    /* outward; zero inside */
    float distance;        /* m; 0 inside */
} fettle_point_hit;

/** Distance between two shapes. */
typedef struct fettle_separation {
    float distance;          /* m; 0 when they overlap */
    fettle_position point_a; /* nearest to b, world, m */
    fettle_position point_b; /* nearest to a */
    fettle_vec2 normal;      /* from a to b; zero when they overlap */
} fettle_separation;

/** Called for each result; false ends the query. */
typedef bool (*fettle_shape_visitor)(void* user, const fettle_world* world, fettle_id shape);
typedef bool (*fettle_ray_visitor)(void* user, const fettle_world* world,
                                   const fettle_ray_hit* hit);

/** Shapes that contain a point. */
fettle_code fettle_world_query_point(const fettle_world* world, fettle_coordinate x,
                                     fettle_coordinate y, const fettle_query_filter* filter,
                                     fettle_id* out, uint32_t room, uint32_t* count);
fettle_code fettle_world_visit_point(fettle_world* world, fettle_coordinate x, fettle_coordinate y,
                                     const fettle_query_filter* filter,
                                     fettle_shape_visitor visitor, void* user);

/** Shapes that overlap a box. */
fettle_code fettle_world_query_aabb(const fettle_world* world, const fettle_aabb* box,
                                    const fettle_query_filter* filter, fettle_id* out,
                                    uint32_t room, uint32_t* count);
fettle_code fettle_world_visit_aabb(fettle_world* world, const fettle_aabb* box,
                                    const fettle_query_filter* filter, fettle_shape_visitor visitor,
                                    void* user);

/** Shapes that overlap a shape, which may be of another world (`of`) and of the same one; shapes of
    its own body are ignored. */
fettle_code fettle_world_query_overlap(const fettle_world* world, const fettle_world* of,
                                       fettle_id shape, const fettle_query_filter* filter,
                                       fettle_id* out, uint32_t room, uint32_t* count);
fettle_code fettle_world_visit_overlap(fettle_world* world, const fettle_world* of, fettle_id shape,
                                       const fettle_query_filter* filter,
                                       fettle_shape_visitor visitor, void* user);

/** Shapes that overlap a geometry at a pose; a null pose: the origin. */
fettle_code fettle_world_query_overlap_geometry(const fettle_world* world,
                                                const fettle_geometry* geometry,
                                                const fettle_pose* pose,
                                                const fettle_query_filter* filter, fettle_id* out,
                                                uint32_t room, uint32_t* count);
fettle_code fettle_world_visit_overlap_geometry(fettle_world* world,
                                                const fettle_geometry* geometry,
                                                const fettle_pose* pose,
                                                const fettle_query_filter* filter,
                                                fettle_shape_visitor visitor, void* user);

/** The first shape on a ray. `found` says whether there is one; only then `hit`, which may be
   null, is written. */
fettle_code fettle_world_cast_ray(const fettle_world* world, fettle_coordinate from_x,
                                  fettle_coordinate from_y, fettle_coordinate to_x,
                                  fettle_coordinate to_y, const fettle_query_filter* filter,
                                  bool* found, fettle_ray_hit* hit);

/** All shapes on a ray, nearest first. */
fettle_code fettle_world_cast_ray_all(const fettle_world* world, fettle_coordinate from_x,
                                      fettle_coordinate from_y, fettle_coordinate to_x,
                                      fettle_coordinate to_y, const fettle_query_filter* filter,
                                      fettle_ray_hit* out, uint32_t room, uint32_t* count);
fettle_code fettle_world_visit_ray(fettle_world* world, fettle_coordinate from_x,
                                   fettle_coordinate from_y, fettle_coordinate to_x,
                                   fettle_coordinate to_y, const fettle_query_filter* filter,
                                   fettle_ray_visitor visitor, void* user);

/** The first shape that a shape, which may be of another world (`of`), meets along a motion (m); at
    fraction 0 if they overlap at the start. `found` and `hit` as for fettle_world_cast_ray. */
fettle_code fettle_world_cast_shape(const fettle_world* world, const fettle_world* of,
                                    fettle_id shape, float motion_x, float motion_y,
                                    const fettle_query_filter* filter, bool* found,
                                    fettle_ray_hit* hit);

/** As fettle_world_cast_shape, for a geometry at a pose; a null pose: the origin. */
fettle_code fettle_world_cast_geometry(const fettle_world* world, const fettle_geometry* geometry,
                                       const fettle_pose* pose, float motion_x, float motion_y,
                                       const fettle_query_filter* filter, bool* found,
                                       fettle_ray_hit* hit);

/** The shape nearest to a point, at most `reach` (m, from 0 to infinity) away; the border is
   ignored. `found` and `hit` as for fettle_world_cast_ray. */
fettle_code fettle_world_closest(const fettle_world* world, fettle_coordinate x,
                                 fettle_coordinate y, float reach,
                                 const fettle_query_filter* filter, bool* found,
                                 fettle_point_hit* hit);

/** Distance between two shapes, which may be of different worlds. */
fettle_code fettle_distance(const fettle_world* world_a, fettle_id shape_a,
                            const fettle_world* world_b, fettle_id shape_b,
                            fettle_separation* separation);

/** An explosion that acts on the surfaces which face it. */
typedef struct fettle_explosion_def {
    uint32_t size;
    fettle_position point; /* (0, 0) m */
    float radius;          /* 1 m, at least 0; nearer shapes get the full impulse */
    float falloff; /* 0 m, at least 0; the impulse falls to 0 over this distance beyond radius */
    float impulse_per_length; /* 1 N s for each meter of the perimeter of a shape, seen from the
                                 center of the explosion; negative pulls */
} fettle_explosion_def;

/** Writes the defaults and `size`. FETTLE_INVALID unless `size` is the size of the structure. */
fettle_code fettle_explosion_def_init(fettle_explosion_def* def, size_t size);

/** Pushes the dynamic bodies around a point. The impulse acts on each shape at its point nearest to
 * the explosion. */
fettle_code fettle_world_explode_surfaces(fettle_world* world, const fettle_explosion_def* def,
                                          const fettle_query_filter* filter);

/** Pushes dynamic bodies away from a point: with `impulse` (N s, finite) at distance 0, falling
    linearly to 0 at `radius` (m, from 0 to 1e8), at the nearest point of the body. */
fettle_code fettle_world_explode(fettle_world* world, fettle_coordinate x, fettle_coordinate y,
                                 float radius, float impulse, const fettle_query_filter* filter);

FETTLE_PHYSICS_C_END
