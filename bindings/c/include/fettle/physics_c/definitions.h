/* Definitions of the objects that a world creates; those of joints are in joint_definitions.h. Call
 * the function `..._init` of a definition, with its size, for the defaults that the comments state;
 * then change what is to be different. The size tells a later version of the library which members
 * there are, and a wrong one is refused. */

#pragma once

#include <fettle/physics_c/basics.h>

FETTLE_PHYSICS_C_BEGIN

/** A world. The functions of world_settings.h change each of these values later. */
typedef struct fettle_world_def {
    uint32_t size;
    int32_t substeps;            /* 4; solver sub-steps a step, 1 to 64 */
    fettle_vec2 gravity;         /* (0, -10) m/s2; finite */
    fettle_aabb bounds;          /* m; walls that keep dynamic bodies inside, if has_bounds */
    bool has_bounds;             /* false */
    bool sleeping;               /* true: resting islands fall asleep and cost no time */
    bool continuous;             /* true: fast bodies do not pass through static ones */
    bool persist_events;         /* false; true: report every continuing touch in every step */
    float bounds_friction;       /* 0.6; at least 0 */
    float bounds_restitution;    /* 0; 0 to 1 */
    float restitution_threshold; /* 1 m/s; slower impacts do not bounce */
    float hit_threshold;         /* 1 m/s; slower impacts make no hit event */
    float sleep_speed;           /* 0.05 m/s; an island slower than this for sleep_delay sleeps */
    float sleep_delay;           /* 0.5 s */
    float contact_hertz;         /* 60 Hz; frequency of a contact under load */
    float contact_damping;       /* 10; damping ratio of contacts */
    float push_speed;            /* 3 m/s; limit for pushing overlapping shapes apart */
    int32_t friction_mix;        /* FETTLE_MIX_GEOMETRIC; one of fettle_mix_rule */
    int32_t restitution_mix;     /* FETTLE_MIX_MAXIMUM */
    int32_t solver;              /* FETTLE_SOLVER_SOFT_STEP; one of fettle_solver */
    float max_speed; /* 1e4 m/s; above 0, at most 1e4: limit of the speed of every body */
} fettle_world_def;

/** A body. body.h has ranges, and the functions that change each of these values later. */
typedef struct fettle_body_def {
    uint32_t size;
    int32_t type;             /* FETTLE_BODY_DYNAMIC; one of fettle_body_type */
    fettle_position position; /* (0, 0) m */
    float angle;              /* 0 rad */
    float angular_velocity;   /* 0 rad/s */
    fettle_vec2 velocity;     /* (0, 0) m/s */
    fettle_vec2 force;        /* (0, 0) N, applied at the center of mass in every step */
    float torque;             /* 0 N m, applied in every step */
    float gravity_scale;      /* 1 */
    float linear_damping;     /* 0 1/s */
    float angular_damping;    /* 0 1/s */
    float mass;               /* kg, if has_mass; infinity: does not move */
    float inertia;            /* kg m2, if has_inertia; infinity: does not rotate */
    fettle_vec2 center;       /* center of mass in body coordinates, m, if has_center */
    bool has_mass;            /* false: from the shapes */
    bool has_inertia;         /* false: from the shapes */
    bool has_center;          /* false: from the shapes */
    bool awake;               /* true */
    bool can_sleep;           /* true */
    bool bullet;              /* false; true: continuous collision with moving bodies, too */
    bool locked_x;            /* false */
    bool locked_y;            /* false */
    bool locked_rotation;     /* false */
    bool enabled;             /* true; false: takes no part in steps and queries */
    bool has_sleep_speed;     /* false: that of the world */
    float sleep_speed;        /* m/s, if has_sleep_speed; at least 0 */
    float max_speed;          /* infinity, m/s; above 0 */
    const char* name;         /* null: none; at most 63 bytes, which are copied */
    uint64_t user_data;       /* 0 */
} fettle_body_def;

/** Surface, mass and filter of a shape. shape.h has ranges, and functions that change them later.
 */
typedef struct fettle_shape_def {
    uint32_t size;
    int32_t group;            /* 0; same non-zero group: positive always collides, negative never */
    float density;            /* 1 kg/m2 */
    float friction;           /* 0.6 */
    float restitution;        /* 0; 0 to 1 */
    float rolling_resistance; /* 0; lever arm of the resisting torque divided by the radius */
    float surface_speed;      /* 0 m/s; along the surface, counter-clockwise round the shape */
    bool sensor;              /* false; true: reports overlaps, applies no force */
    bool hit_events;          /* false; true: reports impacts above the hit threshold */
    bool contact_events;      /* true; its touches are reported if both shapes agree */
    bool sensor_events;       /* true; the same for a sensor and for a shape in one */
    bool before_solve;        /* true; false: no before-solve callback for its contacts */
    uint32_t material;        /* 0; a number of the host, without effect; at most 65535 */
    uint64_t category;        /* 1; one bit for each category */
    uint64_t mask;            /* all bits; categories it collides with */
    uint64_t user_data;       /* 0 */
} fettle_shape_def;

/** Geometry of a shape in body coordinates, m. A type uses the members that are named after it, and
    ignores the others. Lengths are from 1e-5 to 1e6, coordinates from -1e6 to 1e6. */
typedef struct fettle_geometry {
    uint32_t size;
    int32_t type;              /* circle to chain of fettle_shape_type */
    float radius;              /* circle: 0.5 */
    float radius_x, radius_y;  /* ellipse, before rotation: 0.5, 0.25 */
    float width, height;       /* box, with its rounding: 1, 1 */
    fettle_vec2 center;        /* circle, box, ellipse: (0, 0) */
    float angle;               /* box, ellipse: 0 rad */
    float rounding;            /* box, segment, polygon: 0; radius of the corners, at least 0 */
    fettle_vec2 from, to;      /* segment: (-0.5, 0), (0.5, 0) */
    const fettle_vec2* points; /* polygon: any points, it is their hull; concave: its outline;
                                  chain: its points, of which each segment is solid on its left
                                  (from left to right: ground). They are copied. Null: none */
    uint32_t point_count;      /* 0; at most 2^20, of a concave polygon 2^14 */
    bool closed;               /* chain: false; true: a segment from the last point to the first */
} fettle_geometry;

/** A mouse joint. */
typedef struct fettle_mouse_joint_def {
    uint32_t size;
    bool has_anchor;        /* false: the point of the body that is at the target */
    bool enabled;           /* true */
    fettle_id body;         /* must be set */
    fettle_position target; /* (0, 0) m, world */
    fettle_vec2 anchor;     /* m, body coordinates, if has_anchor */
    float hertz;            /* 5 Hz; from 0 (slack) to infinity */
    float damping_ratio;    /* 0.7; at least 0 */
    float max_force;        /* infinity, N; at least 0 */
    uint64_t user_data;     /* 0 */
} fettle_mouse_joint_def;

/** What a field of force does. */
enum fettle_field_type {
    FETTLE_FIELD_WIND = 0,
    FETTLE_FIELD_DRAG = 1,
    FETTLE_FIELD_BUOYANCY = 2,
    FETTLE_FIELD_ATTRACTOR = 3
};

/** A field of force. A type uses the members that are named after it, and ignores the others. */
typedef struct fettle_field_def {
    uint32_t size;
    int32_t type;         /* FETTLE_FIELD_WIND; one of fettle_field_type */
    bool has_region;      /* false: it acts everywhere */
    bool enabled;         /* true */
    int32_t falloff;      /* attractor: 2; 0 to 3, exponent of the distance */
    fettle_aabb region;   /* m; liquids act on shapes that overlap it, others on bodies with their
                             center of mass in it */
    fettle_vec2 velocity; /* wind: (5, 0) m/s */
    fettle_vec2 flow;     /* drag, buoyancy: (0, 0) m/s */
    float density;        /* wind: 1.2 kg/m2; buoyancy: 2 kg/m2; at least 0 */
    float linear;         /* drag: 1 N s/m for each m2; at least 0 */
    float quadratic;      /* drag: 0 N s2/m2 for each m2; at least 0 */
    fettle_coordinate level; /* buoyancy: 0 m; points with normal * point below it are submerged */
    fettle_vec2 normal;      /* buoyancy: (0, 1); upwards, of any length but 0 */
    float drag; /* buoyancy: 2 1/s; share of the displaced mass that resists; at least 0 */
    fettle_position center; /* attractor: (0, 0) m, world */
    float strength;         /* attractor: 10 m/s2 at a distance of 1 m; negative repels */
    float core;             /* attractor: 0.5 m; nearer, the pull is proportional to the distance */
    uint64_t mask;          /* all bits; it acts on shapes of these categories */
    uint64_t user_data;     /* 0 */
} fettle_field_def;

/** Writes the defaults and `size`. FETTLE_INVALID unless `size` is the size of the structure. */
fettle_code fettle_world_def_init(fettle_world_def* def, size_t size);
fettle_code fettle_body_def_init(fettle_body_def* def, size_t size);
fettle_code fettle_shape_def_init(fettle_shape_def* def, size_t size);
fettle_code fettle_mouse_joint_def_init(fettle_mouse_joint_def* def, size_t size);

/** As above, for a type: one of fettle_shape_type but the border. */
fettle_code fettle_geometry_init(fettle_geometry* geometry, size_t size, int32_t type);

/** As above, for a type: one of fettle_field_type. */
fettle_code fettle_field_def_init(fettle_field_def* def, size_t size, int32_t type);

FETTLE_PHYSICS_C_END
