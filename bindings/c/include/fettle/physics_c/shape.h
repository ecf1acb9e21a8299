/* Shapes: parts of bodies, or detached. Errors are those of basics.h. A property that the type of a
 * shape does not have (the radius of a box) is refused with FETTLE_INVALID. */

#pragma once

#include <fettle/physics_c/definitions.h>

FETTLE_PHYSICS_C_BEGIN

/** Whether the id is that of a live shape of this world; false for null and for any other value. */
bool fettle_shape_is_valid(const fettle_world* world, fettle_id shape);

/** Destroys the shape. */
fettle_code fettle_shape_destroy(fettle_world* world, fettle_id shape);

/** One of fettle_shape_type. */
fettle_code fettle_shape_type(const fettle_world* world, fettle_id shape, int32_t* type);

/** The body that it is attached to; 0 when it is detached. */
fettle_code fettle_shape_body(const fettle_world* world, fettle_id shape, fettle_id* body);

/** Attaches the shape to a body of the same world; it leaves the one it was attached to. */
fettle_code fettle_shape_attach(fettle_world* world, fettle_id shape, fettle_id body);

/** Detaches the shape from its body. Then it does nothing. */
fettle_code fettle_shape_detach(fettle_world* world, fettle_id shape);

/** Geometry of the shape; geometry->size must be set (fettle_geometry_init). `points` is null:
    fettle_shape_vertices has them; `point_count` says how many there are. */
fettle_code fettle_shape_geometry(const fettle_world* world, fettle_id shape,
                                  fettle_geometry* geometry);

/** Another geometry, which may be of another type. Refuses what definitions.h does, and changes
    nothing then. */
fettle_code fettle_shape_set_geometry(fettle_world* world, fettle_id shape,
                                      const fettle_geometry* geometry);

/** Surface of one segment of a chain. The members mean what they mean in fettle_shape_def;
    `surface_speed` is against the order of the points. `material`: from 0 to 65535. A number that
    is infinity is that of the shape, and so is the material 65535. */
typedef struct fettle_segment_surface {
    float friction;           /* 0 or more */
    float restitution;        /* 0 to 1 */
    float rolling_resistance; /* 0 or more */
    float surface_speed;      /* m/s */
    uint32_t material;        /* without effect */
} fettle_segment_surface;

/** Chain: number of its segments. They count from 0, in the order of the points. A surface stays
    with its number when the points change, and ends when the shape becomes one of another type. */
fettle_code fettle_shape_segment_count(const fettle_world* world, fettle_id shape,
                                       uint32_t* segment_count);

/** Chain: the surface of a segment: its own values, and those of the shape for the others. */
fettle_code fettle_shape_segment_surface(const fettle_world* world, fettle_id shape,
                                         uint32_t segment, fettle_segment_surface* surface);

/** Chain: gives a segment a surface of its own; null: that of the shape. Wakes the body. */
fettle_code fettle_shape_set_segment_surface(fettle_world* world, fettle_id shape, uint32_t segment,
                                             const fettle_segment_surface* surface);

/** Chain: the own surface of a segment; `is_set` is false if it has that of the shape. */
fettle_code fettle_shape_segment_surface_override(const fettle_world* world, fettle_id shape,
                                                  uint32_t segment, bool* is_set,
                                                  fettle_segment_surface* surface);

/** Chain: sets the surfaces of all segments, in order; `count` is their number, or 0: each has that
    of the shape. */
fettle_code fettle_shape_set_segment_surfaces(fettle_world* world, fettle_id shape,
                                              const fettle_segment_surface* surfaces,
                                              uint32_t count);

/** Circle: m, from 1e-5 to 1e6. */
fettle_code fettle_shape_radius(const fettle_world* world, fettle_id shape, float* radius);
fettle_code fettle_shape_set_radius(fettle_world* world, fettle_id shape, float radius);

/** Ellipse: half of its width before rotation, m, from 1e-5 to 1e6. */
fettle_code fettle_shape_radius_x(const fettle_world* world, fettle_id shape, float* radius_x);
fettle_code fettle_shape_set_radius_x(fettle_world* world, fettle_id shape, float radius_x);

/** Ellipse: half of its height before rotation, m, from 1e-5 to 1e6. */
fettle_code fettle_shape_radius_y(const fettle_world* world, fettle_id shape, float* radius_y);
fettle_code fettle_shape_set_radius_y(fettle_world* world, fettle_id shape, float radius_y);

/** Circle, box, ellipse: body coordinates, m, from -1e6 to 1e6. */
fettle_code fettle_shape_center(const fettle_world* world, fettle_id shape, fettle_vec2* center);
fettle_code fettle_shape_set_center(fettle_world* world, fettle_id shape, float x, float y);

/** Box: full width with its rounding, m, from 1e-5 to 1e6. */
fettle_code fettle_shape_width(const fettle_world* world, fettle_id shape, float* width);
fettle_code fettle_shape_set_width(fettle_world* world, fettle_id shape, float width);

/** Box: full height with its rounding, m, from 1e-5 to 1e6. */
fettle_code fettle_shape_height(const fettle_world* world, fettle_id shape, float* height);
fettle_code fettle_shape_set_height(fettle_world* world, fettle_id shape, float height);

/** Box, ellipse: rad, in the body, from -1e8 to 1e8. */
fettle_code fettle_shape_angle(const fettle_world* world, fettle_id shape, float* angle);
fettle_code fettle_shape_set_angle(fettle_world* world, fettle_id shape, float angle);

/** Box, segment, polygon: radius of the corners, m, from 0 to 1e6. */
fettle_code fettle_shape_rounding(const fettle_world* world, fettle_id shape, float* rounding);
fettle_code fettle_shape_set_rounding(fettle_world* world, fettle_id shape, float rounding);

/** Segment: its begin, body coordinates, m, from -1e6 to 1e6. */
fettle_code fettle_shape_from(const fettle_world* world, fettle_id shape, fettle_vec2* from);
fettle_code fettle_shape_set_from(fettle_world* world, fettle_id shape, float x, float y);

/** Segment: its end, body coordinates, m, from -1e6 to 1e6. */
fettle_code fettle_shape_to(const fettle_world* world, fettle_id shape, fettle_vec2* to);
fettle_code fettle_shape_set_to(fettle_world* world, fettle_id shape, float x, float y);

/** Body coordinates, m. Polygon: its hull, counter-clockwise. Box and segment: their corners
    without rounding. Concave polygon and chain: the points that were set. Circle and ellipse:
    none. A list: see basics.h. */
fettle_code fettle_shape_vertices(const fettle_world* world, fettle_id shape, fettle_vec2* out,
                                  uint32_t room, uint32_t* count);

/** Polygon: becomes the hull of the points (m, from -1e6 to 1e6). Concave polygon, chain: these
    points, at most 2^14 of a concave polygon. Refuses points without such a shape and leaves it as
    it was. */
fettle_code fettle_shape_set_vertices(fettle_world* world, fettle_id shape,
                                      const fettle_vec2* points, uint32_t count);

/** As fettle_shape_set_vertices, for polygons only; points without a hull give one of
    fettle_hull_status and are not errors. */
fettle_code fettle_shape_try_set_vertices(fettle_world* world, fettle_id shape,
                                          const fettle_vec2* points, uint32_t count,
                                          int32_t* status);

/** Polygon: becomes the hull with one point more, body coordinates, m, from -1e6 to 1e6. */
fettle_code fettle_shape_add_vertex(fettle_world* world, fettle_id shape, float x, float y);

/** Chain: whether a segment goes from the last point to the first. */
fettle_code fettle_shape_closed(const fettle_world* world, fettle_id shape, bool* closed);
fettle_code fettle_shape_set_closed(fettle_world* world, fettle_id shape, bool closed);

/** Points of one convex piece of a concave polygon, or of one segment of a chain, body
    coordinates, m; `pieces` says how many there are, 0 for other types. A piece that does not
    exist has no points. A list: see basics.h. */
fettle_code fettle_shape_pieces(const fettle_world* world, fettle_id shape, uint32_t piece,
                                fettle_vec2* out, uint32_t room, uint32_t* count, uint32_t* pieces);

/** kg/m2; finite, at least 0. */
fettle_code fettle_shape_density(const fettle_world* world, fettle_id shape, float* density);
fettle_code fettle_shape_set_density(fettle_world* world, fettle_id shape, float density);

/** Coulomb coefficient; finite, at least 0. A contact mixes both by the rule of the world. */
fettle_code fettle_shape_friction(const fettle_world* world, fettle_id shape, float* friction);
fettle_code fettle_shape_set_friction(fettle_world* world, fettle_id shape, float friction);

/** From 0 to 1. A contact mixes both by the rule of the world. */
fettle_code fettle_shape_restitution(const fettle_world* world, fettle_id shape,
                                     float* restitution);
fettle_code fettle_shape_set_restitution(fettle_world* world, fettle_id shape, float restitution);

/** Lever arm of the resisting torque divided by the radius, for round shapes; finite, at least 0.
 */
fettle_code fettle_shape_rolling_resistance(const fettle_world* world, fettle_id shape,
                                            float* rolling_resistance);
fettle_code fettle_shape_set_rolling_resistance(fettle_world* world, fettle_id shape,
                                                float rolling_resistance);

/** m/s, conveyor: along the surface, counter-clockwise round the shape; finite. */
fettle_code fettle_shape_surface_speed(const fettle_world* world, fettle_id shape,
                                       float* surface_speed);
fettle_code fettle_shape_set_surface_speed(fettle_world* world, fettle_id shape,
                                           float surface_speed);

/** Whether it reports overlaps and applies no force. */
fettle_code fettle_shape_sensor(const fettle_world* world, fettle_id shape, bool* sensor);
fettle_code fettle_shape_set_sensor(fettle_world* world, fettle_id shape, bool sensor);

/** Whether impacts above the hit threshold of the world are reported. */
fettle_code fettle_shape_hit_events(const fettle_world* world, fettle_id shape, bool* hit_events);
fettle_code fettle_shape_set_hit_events(fettle_world* world, fettle_id shape, bool hit_events);

/** Whether its touches are reported: if this is true for both shapes, from the next touch on. A
   touch whose begin was reported is reported to its end. */
fettle_code fettle_shape_contact_events(const fettle_world* world, fettle_id shape,
                                        bool* contact_events);
fettle_code fettle_shape_set_contact_events(fettle_world* world, fettle_id shape,
                                            bool contact_events);

/** The same for a sensor, and for a shape in one. */
fettle_code fettle_shape_sensor_events(const fettle_world* world, fettle_id shape,
                                       bool* sensor_events);
fettle_code fettle_shape_set_sensor_events(fettle_world* world, fettle_id shape,
                                           bool sensor_events);

/** Whether the before-solve callback is called for its contacts: true for both shapes. */
fettle_code fettle_shape_before_solve(const fettle_world* world, fettle_id shape,
                                      bool* before_solve);
fettle_code fettle_shape_set_before_solve(fettle_world* world, fettle_id shape, bool before_solve);

/** A number of the host, without effect; at most 65535. */
fettle_code fettle_shape_material(const fettle_world* world, fettle_id shape, uint32_t* material);
fettle_code fettle_shape_set_material(fettle_world* world, fettle_id shape, uint32_t material);

/** Categories of the shape, one bit each. */
fettle_code fettle_shape_category(const fettle_world* world, fettle_id shape, uint64_t* category);
fettle_code fettle_shape_set_category(fettle_world* world, fettle_id shape, uint64_t category);

/** Categories it collides with; both shapes must agree. */
fettle_code fettle_shape_mask(const fettle_world* world, fettle_id shape, uint64_t* mask);
fettle_code fettle_shape_set_mask(fettle_world* world, fettle_id shape, uint64_t mask);

/** Same non-zero group: positive always collides, negative never. */
fettle_code fettle_shape_group(const fettle_world* world, fettle_id shape, int32_t* group);
fettle_code fettle_shape_set_group(fettle_world* world, fettle_id shape, int32_t group);

/** m2. */
fettle_code fettle_shape_area(const fettle_world* world, fettle_id shape, float* area);

/** kg: density times area. */
fettle_code fettle_shape_mass(const fettle_world* world, fettle_id shape, float* mass);

/** Box around it, world, m; body coordinates when it is detached. */
fettle_code fettle_shape_aabb(const fettle_world* world, fettle_id shape, fettle_aabb* aabb);

/** As fettle_shape_vertices, in the world. A list: see basics.h. */
fettle_code fettle_shape_world_vertices(const fettle_world* world, fettle_id shape,
                                        fettle_position* out, uint32_t room, uint32_t* count);

/** Whether a point of the world (m, finite) is inside. */
fettle_code fettle_shape_contains(const fettle_world* world, fettle_id shape, fettle_coordinate x,
                                  fettle_coordinate y, bool* inside);

/** Centroid, world, m. */
fettle_code fettle_shape_world_center(const fettle_world* world, fettle_id shape,
                                      fettle_position* world_center);

/** Whether it has any contact; sensors do not count. */
fettle_code fettle_shape_is_touching(const fettle_world* world, fettle_id shape, bool* is_touching);

/** How often its derived geometry was computed again. */
fettle_code fettle_shape_rebuilds(const fettle_world* world, fettle_id shape, uint32_t* rebuilds);

/** Any number of the host's. It is part of snapshots. */
fettle_code fettle_shape_user_data(const fettle_world* world, fettle_id shape, uint64_t* user_data);
fettle_code fettle_shape_set_user_data(fettle_world* world, fettle_id shape, uint64_t user_data);

FETTLE_PHYSICS_C_END
