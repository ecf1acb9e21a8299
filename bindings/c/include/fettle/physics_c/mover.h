/* A character mover: it moves a capsule through a world, along walls, up slopes and steps, on
 * moving platforms. It is not an object of the world but two structures of the caller: the
 * definition, and the state, which is all that it keeps from move to move. Errors are those of
 * basics.h; a definition with a value out of its range is refused by every function that takes it.
 */

#pragma once

#include <fettle/physics_c/definitions.h>

FETTLE_PHYSICS_C_BEGIN

/** Settings of a mover: an upright capsule, whose position is its lowest point. */
typedef struct fettle_mover_def {
    uint32_t size;
    int32_t group;     /* 0; as fettle_shape_def.group */
    uint64_t category; /* 1; categories of the mover */
    uint64_t mask;     /* all bits; categories of the shapes that are obstacles */
    uint64_t ledges;   /* 0; categories of shapes that are solid only from above */
    fettle_id body;    /* 0; a body whose shapes are not obstacles */
    fettle_vec2 up;    /* (0, 1); from its feet to its head, of any length but 0 */
    float radius;      /* 0.4 m, 0.01 to 1000 */
    float height;      /* 1.8 m, at least twice the radius, at most 1000 */
    float max_slope;   /* 0.87 rad, 0 to 1.5; steeper ground is a wall */
    float step_height; /* 0.3 m, 0 to 1000; it climbs steps up to this height */
    float snap;        /* 0.25 m, 0 to 1000; walking, it stays on ground that falls by this */
    float skin;        /* 0.01 m, 0.001 to 0.1; distance that it keeps from everything */
    float mass;        /* 80 kg, at least 0; its weight and its inertia on dynamic bodies */
    float push_force;  /* 600 N, at least 0; the most with which it pushes a dynamic body */
} fettle_mover_def;

/** The state of a mover: a plain value that can be copied and saved. */
typedef struct fettle_mover_state {
    uint32_t size;
    bool on_ground;              /* after the last move */
    bool climbing;               /* true: it moves freely, without ground, steps and rides */
    fettle_position position;    /* of its feet, m */
    fettle_vec2 ground_normal;   /* zero in the air */
    fettle_vec2 ground_velocity; /* with which its ground carries it, m/s; zero in the air but after
                                    a drop */
    fettle_id ground;            /* the shape on which it stands; 0 in the air */
    fettle_id dropped;           /* the shape through which it falls; 0: none */
    uint32_t ground_part;        /* segment or piece of the ground, as in fettle_contact */
} fettle_mover_state;

/** What happened in a move. */
typedef struct fettle_moved {
    fettle_vec2 motion;          /* m, the ride on the ground included */
    fettle_vec2 velocity;        /* for the next move, m/s; relative to the ground, in the air to
                                    the world */
    fettle_vec2 ground_normal;   /* zero in the air */
    fettle_vec2 ground_velocity; /* of the ground, without what walls keep from it, m/s */
    fettle_vec2 wall_normal;     /* of the last wall or ceiling that it hit */
    fettle_id ground;            /* shape below its feet; 0 in the air */
    fettle_id wall;              /* shape of the last wall or ceiling; 0: none */
    bool on_ground;              /* it stands */
    bool hit_wall;               /* it was stopped by a wall */
    bool hit_ceiling;            /* it was stopped by a ceiling */
    bool stepped;                /* it climbed a step */
    bool crushed;                /* there is no room between the shapes that press it */
} fettle_moved;

/** A plane that bounds the motion of a mover. */
typedef struct fettle_mover_plane {
    fettle_vec2 normal;    /* from the shape to the mover; its length is 1 */
    fettle_position point; /* on the surface, m */
    float separation;      /* m; negative when they overlap */
    fettle_id shape;       /* that bounds it */
} fettle_mover_plane;

/** Write the defaults and `size`. FETTLE_INVALID unless `size` is the size of the structure. */
fettle_code fettle_mover_def_init(fettle_mover_def* def, size_t size);
fettle_code fettle_mover_state_init(fettle_mover_state* state, size_t size);

/** Moves it by velocity (m/s, relative to the ground if it stands) times dt (s), and with the
   ground. To be called before fettle_world_step with the same dt. It does nothing unless dt > 0.
   `moved` may be null. */
fettle_code fettle_mover_move(fettle_world* world, const fettle_mover_def* def,
                              fettle_mover_state* state, float velocity_x, float velocity_y,
                              float dt, fettle_moved* moved);

/** Lets it fall through the ledge or the chain on which it stands; false in `dropped`, which may be
    null: it stands on none. */
fettle_code fettle_mover_drop(const fettle_world* world, const fettle_mover_def* def,
                              fettle_mover_state* state, bool* dropped);

/** Whether a mover of this height (m) has room at its position. */
fettle_code fettle_mover_fits(const fettle_world* world, const fettle_mover_def* def,
                              const fettle_mover_state* state, float height, bool* fits);

/** Changes def->height if there is room for it; otherwise `changed`, which may be null, is false.
 */
fettle_code fettle_mover_set_height(const fettle_world* world, fettle_mover_def* def,
                                    const fettle_mover_state* state, float height, bool* changed);

/** The planes of all obstacles within a distance (m, 0 to 1000), nearest first. */
fettle_code fettle_mover_planes(const fettle_world* world, const fettle_mover_def* def,
                                const fettle_mover_state* state, float distance,
                                fettle_mover_plane* out, uint32_t room, uint32_t* count);

/** For movers of the host's own: the motion (m) nearest to a wanted one after which all planes are
    at least `distance` (m) away; if there is none, one that divides the overlap among them. It uses
    the normals, whose length is 1, and the separations; the other members may be anything. */
fettle_code fettle_solve_planes(float motion_x, float motion_y, const fettle_mover_plane* planes,
                                uint32_t plane_count, float distance, fettle_vec2* motion);

/** A velocity (m/s) without the parts that go into the planes, of which it uses the normals. */
fettle_code fettle_clip_velocity(float velocity_x, float velocity_y,
                                 const fettle_mover_plane* planes, uint32_t plane_count,
                                 fettle_vec2* velocity);

FETTLE_PHYSICS_C_END
