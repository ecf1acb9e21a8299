/* Functions on geometries that need no world. They are the functions that a world computes with. A
 * null pose is the origin. Coordinates are from -1e8 to 1e8 m. */

#pragma once

#include <fettle/physics_c/contact.h>
#include <fettle/physics_c/query.h>

FETTLE_PHYSICS_C_BEGIN

/** Area, mass and inertia of a geometry; a chain has none. */
typedef struct fettle_mass_properties {
    float area;           /* m2 */
    float mass;           /* kg */
    fettle_vec2 centroid; /* body coordinates, m */
    float inertia;        /* kg m2, about the centroid */
} fettle_mass_properties;

/** The point where a ray enters a geometry. */
typedef struct fettle_surface_hit {
    fettle_position point; /* m */
    fettle_vec2 normal;    /* of the surface, outward */
    float fraction;        /* 0 at the start of the ray, 1 at its end */
} fettle_surface_hit;

/** The contact points of two convex parts. */
typedef struct fettle_contact_manifold {
    fettle_vec2 normal;             /* from a to b */
    int32_t point_count;            /* 1 or 2 */
    fettle_contact_point points[2]; /* impulses are 0 */
} fettle_contact_manifold;

/** A uniform motion from one pose to another. */
typedef struct fettle_movement {
    fettle_pose from;   /* at fraction 0 */
    fettle_pose to;     /* at fraction 1 */
    fettle_vec2 center; /* the point that moves on a straight line, body coordinates, m */
} fettle_movement;

/** A point of one of several lines. */
typedef struct fettle_line_point {
    fettle_vec2 point; /* m */
    uint32_t line;     /* the number of its line, from 0 on */
    bool closed;       /* whether the line is closed */
} fettle_line_point;

/** The direction of a closed chain, which decides on which side it is solid. */
enum fettle_winding {
    FETTLE_WINDING_AS_GIVEN = 0,
    FETTLE_WINDING_CLOCKWISE = 1,        /* an island: solid for bodies outside */
    FETTLE_WINDING_COUNTER_CLOCKWISE = 2 /* a container: solid for bodies inside */
};

/** How lines are joined. */
typedef struct fettle_join_options {
    uint32_t size;
    float reach;    /* 0.001 m; nearer ends are joined */
    float straight; /* 0 m; points this near to the line through those that remain are dropped */
    int32_t closed; /* FETTLE_WINDING_AS_GIVEN; one of fettle_winding, for closed chains */
} fettle_join_options;

/** Where the samples of a grid are: sample (column, row) at origin + cell * (column, row). */
typedef struct fettle_grid_layout {
    uint32_t size;
    uint32_t columns;   /* 0 */
    uint32_t rows;      /* 0 */
    fettle_vec2 origin; /* (0, 0) m */
    float cell;         /* 1 m between two samples; positive */
} fettle_grid_layout;

/** Writes the defaults and `size`. FETTLE_INVALID unless `size` is the size of the structure. */
fettle_code fettle_join_options_init(fettle_join_options* options, size_t size);
fettle_code fettle_grid_layout_init(fettle_grid_layout* layout, size_t size);

/** Area, mass and inertia, with a density (kg/m2, at least 0). A chain has none. */
fettle_code fettle_geometry_mass_properties(const fettle_geometry* geometry, float density,
                                            fettle_mass_properties* mass_properties);

/** The smallest box around a geometry. */
fettle_code fettle_geometry_bounding_box(const fettle_geometry* geometry, const fettle_pose* pose,
                                         fettle_aabb* bounding_box);

/** Whether a point is in the geometry or on its edge. */
fettle_code fettle_geometry_contains(const fettle_geometry* geometry, const fettle_pose* pose,
                                     fettle_coordinate x, fettle_coordinate y, bool* contains);

/** The point where a ray enters a geometry. `found` says whether there is one: not if the ray
    begins inside; only then `hit`, which may be null, is written. */
fettle_code fettle_geometry_cast_ray(const fettle_geometry* geometry, const fettle_pose* pose,
                                     fettle_coordinate from_x, fettle_coordinate from_y,
                                     fettle_coordinate to_x, fettle_coordinate to_y, bool* found,
                                     fettle_surface_hit* hit);

/** Distance and nearest points of two geometries. A chain counts on both sides. */
fettle_code fettle_geometry_distance(const fettle_geometry* a, const fettle_pose* pose_a,
                                     const fettle_geometry* b, const fettle_pose* pose_b,
                                     fettle_separation* separation);

/** A list of the manifolds of two geometries that overlap or are nearer than `margin` (m, at least
    0): one for each pair of convex parts that touch. */
fettle_code fettle_geometry_contact_manifolds(const fettle_geometry* a, const fettle_pose* pose_a,
                                              const fettle_geometry* b, const fettle_pose* pose_b,
                                              float margin, fettle_contact_manifold* out,
                                              uint32_t room, uint32_t* count);

/** The fraction of two movements at which the geometries first come within 0.1 mm of each other.
    `found` says whether they do; only then `fraction`, which may be null, is written. */
fettle_code fettle_geometry_time_of_impact(const fettle_geometry* a,
                                           const fettle_movement* movement_a,
                                           const fettle_geometry* b,
                                           const fettle_movement* movement_b, bool* found,
                                           float* fraction);

/** The convex parts of a geometry, counter-clockwise, as a list of their points: corners of a box
   or a polygon, pieces of a concave polygon (at most sixteen vertices each), segments of a chain.
 */
fettle_code fettle_geometry_parts(const fettle_geometry* geometry, fettle_line_point* out,
                                  uint32_t room, uint32_t* count);

/** Joins lines, which may be in any order and direction, into chains: a list of their points. The
    points of one line are in sequence; its `closed` is not read. Null options are the defaults. */
fettle_code fettle_join_lines(const fettle_line_point* points, uint32_t point_count,
                              const fettle_join_options* options, fettle_line_point* out,
                              uint32_t room, uint32_t* count);

/** The points of a line without those that are at most `straight` (m, at least 0) from the line
    through the points that remain. */
fettle_code fettle_without_straight_points(const fettle_vec2* points, uint32_t point_count,
                                           bool closed, float straight, fettle_vec2* out,
                                           uint32_t room, uint32_t* count);

/** The closed outlines of the area where a grid of numbers (row after row) is above `threshold`, as
   a list of their points: clockwise around an area, counter-clockwise around a hole. There must be
    columns * rows values, at most 2^24; for cells that are filled or not, 1 and 0 with the
   threshold 0.5. `straight` as above. */
fettle_code fettle_grid_outlines(const float* values, uint32_t value_count,
                                 const fettle_grid_layout* layout, float threshold, float straight,
                                 fettle_line_point* out, uint32_t room, uint32_t* count);

FETTLE_PHYSICS_C_END
