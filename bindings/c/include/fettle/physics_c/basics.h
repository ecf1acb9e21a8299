/* What all functions have in common.
 *
 * Units are SI (m, kg, s, N), angles are in radians, counter-clockwise; numbers are single
 * precision, and so are points of the world, unless position.h says otherwise.
 *
 * Results. A function returns FETTLE_DONE, or another code after an error; then it has changed
 * nothing and written to none of its out parameters, and fettle_last_error() has the reason. A
 * pointer must not be null unless the function says that it may be. NaN is refused everywhere.
 * Nothing that a caller passes as an id, a number or a size makes a function crash.
 *
 * Memory. After FETTLE_NO_MEMORY, creating a body, or a shape that is not an outline, has changed
 * nothing, nor has a function that changes no world. Any other edit, or a step, may have been made
 * in part: then the functions of this world return FETTLE_NO_MEMORY until it gets another state
 * (fettle_world_assign, fettle_world_restore, fettle_world_take) or is destroyed.
 *
 * Lists. A function with `out`, `room` and `count` writes the first `room` elements to `out`, and
 * to `count` how many there are. `out` may be null if `room` is 0.
 *
 * Threads. Different worlds are independent. Only one thread at a time may use a world; but several
 * may call functions that take a `const fettle_world*` while no other function of this world runs,
 * if nothing was edited since the last step or since fettle_world_refresh.
 *
 * Foreign function interfaces. All headers in the order of fettle_physics.h, without comments,
 * lines that begin with `#` and the words FETTLE_PHYSICS_C_BEGIN and FETTLE_PHYSICS_C_END, are what
 * cffi and LuaJIT read. */

#pragma once

#include <fettle/physics_c/position.h>

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

FETTLE_PHYSICS_C_BEGIN

/** Result of a function: one of fettle_codes. */
typedef int32_t fettle_code;

/** What a function gives. */
enum fettle_codes {
    FETTLE_DONE = 0,
    FETTLE_INVALID =
        1,            /* an argument without meaning: null, NaN, out of range, wrong type or size */
    FETTLE_STALE = 2, /* the world, body, shape, joint or field does not exist (any more) */
    FETTLE_LOCKED = 3, /* inside a function that the world is calling, or the world has an owner */
    FETTLE_NO_MEMORY = 4, /* there is not enough memory, or there was not in an earlier call */
    FETTLE_FAILED = 5     /* anything else */
};

/** Message of the last error of this thread: the function, what was given, what was expected. Empty
    before the first one. Valid until the next error of this thread. */
const char* fettle_last_error(void);

/** Version of the library, as in "0.1.0". */
const char* fettle_physics_version(void);

/** Number of 32-bit values that the solver computes at a time on this machine: 4, 8 or 16. */
int32_t fettle_simd_width(void);

/** A world; its functions are in world.h. A pointer to a destroyed world is refused, as long as no
    more than a thousand worlds have been destroyed since. */
typedef struct fettle_world fettle_world;

/** Names a body, shape, joint or field in its world and in copies of it; 0 names none. An id of
    another kind, of another world or of a destroyed object is refused. */
typedef uint64_t fettle_id;

/** Slot of the object in the columns of its world (columns.h): the low 28 bits of the id. */
uint32_t fettle_slot(fettle_id id);

/** Axis-aligned box. */
typedef struct fettle_aabb {
    fettle_position min; /* lower left corner */
    fettle_position max; /* the upper right corner */
} fettle_aabb;

/** Where a body is. */
typedef struct fettle_pose {
    fettle_position position; /* of the origin, m */
    float angle;              /* rad, not wrapped */
} fettle_pose;

/** What moves a body. */
enum fettle_body_type {
    FETTLE_BODY_STATIC = 0,    /* never moves by itself; can be teleported */
    FETTLE_BODY_KINEMATIC = 1, /* moves by its velocity, no force moves it */
    FETTLE_BODY_DYNAMIC = 2    /* moved by forces, contacts and joints */
};

/** The geometry of a shape. */
enum fettle_shape_type {
    FETTLE_SHAPE_CIRCLE = 0,
    FETTLE_SHAPE_BOX = 1,
    FETTLE_SHAPE_SEGMENT = 2,
    FETTLE_SHAPE_POLYGON = 3,
    FETTLE_SHAPE_ELLIPSE = 4,
    FETTLE_SHAPE_CONCAVE = 5,
    FETTLE_SHAPE_CHAIN = 6,
    FETTLE_SHAPE_BORDER = 7 /* half-plane of the bounds; only in contacts, events and rays */
};

/** What a joint does with its two bodies: sliding_joints.h, holding_joints.h, coupling_joints.h. */
enum fettle_joint_type {
    FETTLE_JOINT_MOUSE = 0,
    FETTLE_JOINT_DISTANCE = 1,
    FETTLE_JOINT_REVOLUTE = 2,
    FETTLE_JOINT_PRISMATIC = 3,
    FETTLE_JOINT_WHEEL = 4,
    FETTLE_JOINT_WELD = 5,
    FETTLE_JOINT_MOTOR = 6,
    FETTLE_JOINT_PULLEY = 7,
    FETTLE_JOINT_GEAR = 8,
    FETTLE_JOINT_GROOVE = 9,
    FETTLE_JOINT_PIN_SLOT = 10,
    FETTLE_JOINT_RATCHET = 11,
    FETTLE_JOINT_FILTER = 12,
    FETTLE_JOINT_ROTARY_LIMIT = 13
};

/** By which rule a contact computes a value from those of its two surfaces. */
enum fettle_mix_rule {
    FETTLE_MIX_AVERAGE = 0,
    FETTLE_MIX_MINIMUM = 1,
    FETTLE_MIX_MAXIMUM = 2,
    FETTLE_MIX_MULTIPLY = 3,
    FETTLE_MIX_GEOMETRIC = 4
};

/** How contacts and joints are solved. */
enum fettle_solver {
    FETTLE_SOLVER_SOFT_STEP = 0,  /* sequential impulses with warm start on small steps */
    FETTLE_SOLVER_SEQUENTIAL = 1, /* one pass over the contacts in order of severity */
    FETTLE_SOLVER_DIRECT = 2      /* each island as one complementarity problem */
};

/** Whether points have a convex hull. */
enum fettle_hull_status {
    FETTLE_HULL_OK = 0,
    FETTLE_HULL_TOO_FEW_POINTS = 1, /* fewer than three different points */
    FETTLE_HULL_COLLINEAR = 2,      /* all on one line */
    FETTLE_HULL_NOT_FINITE = 3      /* NaN or infinity among the coordinates */
};

/** Convex hull of points in any order, counter-clockwise from the lowest of the leftmost points. It
    is a list (see above), empty unless `status`, one of fettle_hull_status, is FETTLE_HULL_OK. */
fettle_code fettle_convex_hull(const fettle_vec2* points, uint32_t point_count, fettle_vec2* out,
                               uint32_t room, uint32_t* count, int32_t* status);

/** A text for a user about one of fettle_hull_status; "unknown" for any other number. */
const char* fettle_describe(int32_t hull_status);

FETTLE_PHYSICS_C_END
