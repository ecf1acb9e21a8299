/* A definition for each type of joint but the mouse joint (definitions.h). They begin with the same
 * members. Id 0 is the world, whose anchor is in world coordinates; both may not be the world. The
 * setters of sliding_joints.h, holding_joints.h and coupling_joints.h have the ranges, and change
 * each of these values later. A lower limit above the upper one is refused here; a setter
 * accepts it, since the other one may follow. A value that a definition does not set is measured
 * when the joint is made. The `hertz` of a spring is limited to a fifth of the rate of sub-steps:
 * to 48 Hz, if a step of 1/60 s has four. */

#pragma once

#include <fettle/physics_c/basics.h>

FETTLE_PHYSICS_C_BEGIN

/** A rod, a rope or a spring between two points. */
typedef struct fettle_distance_joint_def {
    uint32_t size;
    bool collide;                   /* false; whether the two bodies collide with each other */
    bool enabled;                   /* true */
    fettle_id body_a;               /* 0 */
    fettle_id body_b;               /* 0 */
    fettle_position anchor_a;       /* (0, 0) m, body coordinates */
    fettle_position anchor_b;       /* (0, 0) m, body coordinates */
    uint64_t user_data;             /* 0 */
    float break_force;              /* infinity, N; joint.h describes these six */
    float break_torque;             /* infinity, N m */
    float report_force;             /* infinity, N */
    float report_torque;            /* infinity, N m */
    float constraint_hertz;         /* 0 Hz: as the load needs */
    float constraint_damping_ratio; /* 2 */
    bool has_length;                /* false: the current distance */
    float length;                   /* m, of the rod, or of the spring at rest, if has_length */
    float min_length;               /* 0 m */
    float max_length;               /* infinity, m */
    float hertz;                    /* infinity, Hz: a rod; 0: slack between the limits */
    float damping_ratio;            /* 0; of the spring, at least 0; 1: no swinging */
    float lower_spring_force;       /* minus infinity, N; a negative force pulls */
    float upper_spring_force;       /* infinity, N; a positive force pushes */
    float motor_speed;              /* 0 m/s, of the distance */
    float max_motor_force;          /* 0 N; 0: no motor */
} fettle_distance_joint_def;

/** Holds two points together; the bodies rotate about this point. */
typedef struct fettle_revolute_joint_def {
    uint32_t size;
    bool collide;                   /* false; whether the two bodies collide with each other */
    bool enabled;                   /* true */
    fettle_id body_a;               /* 0 */
    fettle_id body_b;               /* 0 */
    fettle_position anchor_a;       /* (0, 0) m, body coordinates */
    fettle_position anchor_b;       /* (0, 0) m, body coordinates */
    uint64_t user_data;             /* 0 */
    float break_force;              /* infinity, N; joint.h describes these six */
    float break_torque;             /* infinity, N m */
    float report_force;             /* infinity, N */
    float report_torque;            /* infinity, N m */
    float constraint_hertz;         /* 0 Hz: as the load needs */
    float constraint_damping_ratio; /* 2 */
    bool has_reference_angle;       /* false: the current angle counts as 0 */
    float reference_angle;          /* rad, if has_reference_angle */
    float lower_angle;              /* minus infinity, rad */
    float upper_angle;              /* infinity, rad */
    float motor_speed;              /* 0 rad/s, of b relative to a */
    float max_motor_torque;         /* 0 N m; 0: no motor */
    float hertz;                    /* 0 Hz; of a spring to target_angle; 0: no spring */
    float damping_ratio;            /* 0; of the spring, at least 0; 1: no swinging */
    float target_angle;             /* 0 rad */
} fettle_revolute_joint_def;

/** Lets b slide along an axis of a without rotating. */
typedef struct fettle_prismatic_joint_def {
    uint32_t size;
    bool collide;                   /* false; whether the two bodies collide with each other */
    bool enabled;                   /* true */
    fettle_id body_a;               /* 0 */
    fettle_id body_b;               /* 0 */
    fettle_position anchor_a;       /* (0, 0) m, body coordinates */
    fettle_position anchor_b;       /* (0, 0) m, body coordinates */
    uint64_t user_data;             /* 0 */
    float break_force;              /* infinity, N; joint.h describes these six */
    float break_torque;             /* infinity, N m */
    float report_force;             /* infinity, N */
    float report_torque;            /* infinity, N m */
    float constraint_hertz;         /* 0 Hz: as the load needs */
    float constraint_damping_ratio; /* 2 */
    fettle_vec2 axis;               /* (1, 0); coordinates of a, of any length but 0 */
    float lower_translation;        /* minus infinity, m */
    float upper_translation;        /* infinity, m */
    float motor_speed;              /* 0 m/s, of b relative to a along the axis */
    float max_motor_force;          /* 0 N; 0: no motor */
    float hertz;                    /* 0 Hz; of a spring to target_translation; 0: no spring */
    float damping_ratio;            /* 0; of the spring, at least 0; 1: no swinging */
    float target_translation;       /* 0 m */
    bool has_reference_angle;       /* false: the current angle is held */
    float reference_angle;          /* rad, if has_reference_angle */
} fettle_prismatic_joint_def;

/** A wheel (b) of a vehicle (a). */
typedef struct fettle_wheel_joint_def {
    uint32_t size;
    bool collide;                   /* false; whether the two bodies collide with each other */
    bool enabled;                   /* true */
    fettle_id body_a;               /* 0 */
    fettle_id body_b;               /* 0 */
    fettle_position anchor_a;       /* (0, 0) m, body coordinates */
    fettle_position anchor_b;       /* (0, 0) m, body coordinates */
    uint64_t user_data;             /* 0 */
    float break_force;              /* infinity, N; joint.h describes these six */
    float break_torque;             /* infinity, N m */
    float report_force;             /* infinity, N */
    float report_torque;            /* infinity, N m */
    float constraint_hertz;         /* 0 Hz: as the load needs */
    float constraint_damping_ratio; /* 2 */
    fettle_vec2 axis;        /* (0, 1); of the suspension, coordinates of a, of any length but 0 */
    float lower_translation; /* minus infinity, m */
    float upper_translation; /* infinity, m */
    float hertz;             /* 4 Hz; of the suspension; 0: none */
    float damping_ratio;     /* 0.7; of the suspension, at least 0 */
    float motor_speed;       /* 0 rad/s, of the wheel relative to the vehicle */
    float max_motor_torque;  /* 0 N m; 0: no motor */
} fettle_wheel_joint_def;

/** Holds two bodies together at a point and at an angle. */
typedef struct fettle_weld_joint_def {
    uint32_t size;
    bool collide;                   /* false; whether the two bodies collide with each other */
    bool enabled;                   /* true */
    fettle_id body_a;               /* 0 */
    fettle_id body_b;               /* 0 */
    fettle_position anchor_a;       /* (0, 0) m, body coordinates */
    fettle_position anchor_b;       /* (0, 0) m, body coordinates */
    uint64_t user_data;             /* 0 */
    float break_force;              /* infinity, N; joint.h describes these six */
    float break_torque;             /* infinity, N m */
    float report_force;             /* infinity, N */
    float report_torque;            /* infinity, N m */
    float constraint_hertz;         /* 0 Hz: as the load needs */
    float constraint_damping_ratio; /* 2 */
    bool has_reference_angle;       /* false: the current angle is held */
    float reference_angle;          /* rad, if has_reference_angle */
    float hertz;                    /* infinity, Hz: rigid; stiffness at the point */
    float damping_ratio;            /* 0; of the spring, at least 0; 1: no swinging */
    float angular_hertz;            /* infinity, Hz: rigid; stiffness of the angle */
    float angular_damping_ratio;    /* 0; of the angle, at least 0 */
} fettle_weld_joint_def;

/** Drives b relative to a, with a limited force and torque. */
typedef struct fettle_motor_joint_def {
    uint32_t size;
    bool collide;                   /* false; whether the two bodies collide with each other */
    bool enabled;                   /* true */
    fettle_id body_a;               /* 0 */
    fettle_id body_b;               /* 0 */
    fettle_position anchor_a;       /* (0, 0) m, body coordinates */
    fettle_position anchor_b;       /* (0, 0) m, body coordinates */
    uint64_t user_data;             /* 0 */
    float break_force;              /* infinity, N; joint.h describes these six */
    float break_torque;             /* infinity, N m */
    float report_force;             /* infinity, N */
    float report_torque;            /* infinity, N m */
    float constraint_hertz;         /* 0 Hz: as the load needs */
    float constraint_damping_ratio; /* 2 */
    fettle_vec2 linear_velocity;    /* (0, 0) m/s, of anchor b, coordinates of a */
    float angular_velocity;         /* 0 rad/s */
    float max_force;                /* 0 N */
    float max_torque;               /* 0 N m */
    fettle_vec2 linear_offset;      /* (0, 0) m, of anchor b from anchor a, coordinates of a */
    bool has_angular_offset;        /* false: the current angle */
    float angular_offset;           /* rad, if has_angular_offset */
    float hertz;                    /* 0 Hz; stiffness to the offsets; 0: velocities only */
    float damping_ratio;            /* 1; of that stiffness, at least 0 */
} fettle_motor_joint_def;

/** A rope from a over two wheels of the world to b. */
typedef struct fettle_pulley_joint_def {
    uint32_t size;
    bool collide;                   /* false; whether the two bodies collide with each other */
    bool enabled;                   /* true */
    fettle_id body_a;               /* 0 */
    fettle_id body_b;               /* 0 */
    fettle_position anchor_a;       /* (0, 0) m, body coordinates */
    fettle_position anchor_b;       /* (0, 0) m, body coordinates */
    uint64_t user_data;             /* 0 */
    float break_force;              /* infinity, N; joint.h describes these six */
    float break_torque;             /* infinity, N m */
    float report_force;             /* infinity, N */
    float report_torque;            /* infinity, N m */
    float constraint_hertz;         /* 0 Hz: as the load needs */
    float constraint_damping_ratio; /* 2 */
    fettle_position ground_a;       /* (-1, 1) m, world; the wheel above a */
    fettle_position ground_b;       /* (1, 1) m, world; the wheel above b */
    float ratio;                    /* 1; force on b divided by the force on a */
    bool has_length;                /* false: the rope is taut now */
    float length;                   /* m, with ratio times the part at b, if has_length */
} fettle_pulley_joint_def;

/** Rotates b with a. */
typedef struct fettle_gear_joint_def {
    uint32_t size;
    bool collide;                   /* false; whether the two bodies collide with each other */
    bool enabled;                   /* true */
    fettle_id body_a;               /* 0 */
    fettle_id body_b;               /* 0 */
    fettle_position anchor_a;       /* (0, 0) m, body coordinates */
    fettle_position anchor_b;       /* (0, 0) m, body coordinates */
    uint64_t user_data;             /* 0 */
    float break_force;              /* infinity, N; joint.h describes these six */
    float break_torque;             /* infinity, N m */
    float report_force;             /* infinity, N */
    float report_torque;            /* infinity, N m */
    float constraint_hertz;         /* 0 Hz: as the load needs */
    float constraint_damping_ratio; /* 2 */
    float ratio;                    /* 1; rotation of b divided by the rotation of a */
    bool has_phase;                 /* false: that of the current angles */
    float phase;                    /* rad, if has_phase */
} fettle_gear_joint_def;

/** A pin of b in a groove of a that begins at anchor a. */
typedef struct fettle_groove_joint_def {
    uint32_t size;
    bool collide;                   /* false; whether the two bodies collide with each other */
    bool enabled;                   /* true */
    fettle_id body_a;               /* 0 */
    fettle_id body_b;               /* 0 */
    fettle_position anchor_a;       /* (0, 0) m, body coordinates */
    fettle_position anchor_b;       /* (0, 0) m, body coordinates */
    uint64_t user_data;             /* 0 */
    float break_force;              /* infinity, N; joint.h describes these six */
    float break_torque;             /* infinity, N m */
    float report_force;             /* infinity, N */
    float report_torque;            /* infinity, N m */
    float constraint_hertz;         /* 0 Hz: as the load needs */
    float constraint_damping_ratio; /* 2 */
    fettle_position end;            /* (1, 0) m, coordinates of a; the groove begins at anchor a */
} fettle_groove_joint_def;

/** A pin of b in a straight slot of a. */
typedef struct fettle_pin_slot_joint_def {
    uint32_t size;
    bool collide;                   /* false; whether the two bodies collide with each other */
    bool enabled;                   /* true */
    fettle_id body_a;               /* 0 */
    fettle_id body_b;               /* 0 */
    fettle_position anchor_a;       /* (0, 0) m, body coordinates */
    fettle_position anchor_b;       /* (0, 0) m, body coordinates */
    uint64_t user_data;             /* 0 */
    float break_force;              /* infinity, N; joint.h describes these six */
    float break_torque;             /* infinity, N m */
    float report_force;             /* infinity, N */
    float report_torque;            /* infinity, N m */
    float constraint_hertz;         /* 0 Hz: as the load needs */
    float constraint_damping_ratio; /* 2 */
    fettle_vec2 axis;               /* (1, 0); coordinates of a, of any length but 0 */
    float lower_translation;        /* minus infinity, m */
    float upper_translation;        /* infinity, m */
    float motor_speed;              /* 0 m/s, of b relative to a along the axis */
    float max_motor_force;          /* 0 N; 0: no motor */
    float hertz;                    /* 0 Hz; of a spring to target_translation; 0: no spring */
    float damping_ratio;            /* 0; of the spring, at least 0; 1: no swinging */
    float target_translation;       /* 0 m */
} fettle_pin_slot_joint_def;

/** Lets b rotate relative to a in one direction only. */
typedef struct fettle_ratchet_joint_def {
    uint32_t size;
    bool collide;                   /* false; whether the two bodies collide with each other */
    bool enabled;                   /* true */
    fettle_id body_a;               /* 0 */
    fettle_id body_b;               /* 0 */
    fettle_position anchor_a;       /* (0, 0) m, body coordinates */
    fettle_position anchor_b;       /* (0, 0) m, body coordinates */
    uint64_t user_data;             /* 0 */
    float break_force;              /* infinity, N; joint.h describes these six */
    float break_torque;             /* infinity, N m */
    float report_force;             /* infinity, N */
    float report_torque;            /* infinity, N m */
    float constraint_hertz;         /* 0 Hz: as the load needs */
    float constraint_damping_ratio; /* 2 */
    bool has_reference_angle;       /* false: the current angle counts as 0 */
    float reference_angle;          /* rad, if has_reference_angle */
    float tooth;                    /* 0 rad; between teeth; 0: it holds at any angle */
    bool backwards;                 /* false; true: b rotates freely clockwise */
} fettle_ratchet_joint_def;

/** The two bodies do not collide with each other; nothing else. */
typedef struct fettle_filter_joint_def {
    uint32_t size;
    bool collide;                   /* false; whether the two bodies collide with each other */
    bool enabled;                   /* true */
    fettle_id body_a;               /* 0 */
    fettle_id body_b;               /* 0 */
    fettle_position anchor_a;       /* (0, 0) m, body coordinates */
    fettle_position anchor_b;       /* (0, 0) m, body coordinates */
    uint64_t user_data;             /* 0 */
    float break_force;              /* infinity, N; joint.h describes these six */
    float break_torque;             /* infinity, N m */
    float report_force;             /* infinity, N */
    float report_torque;            /* infinity, N m */
    float constraint_hertz;         /* 0 Hz: as the load needs */
    float constraint_damping_ratio; /* 2 */
} fettle_filter_joint_def;

/** Keeps the angle of b relative to a between two angles, wherever the bodies are. */
typedef struct fettle_rotary_limit_joint_def {
    uint32_t size;
    bool collide;                   /* false; whether the two bodies collide with each other */
    bool enabled;                   /* true */
    fettle_id body_a;               /* 0 */
    fettle_id body_b;               /* 0 */
    fettle_position anchor_a;       /* (0, 0) m, body coordinates */
    fettle_position anchor_b;       /* (0, 0) m, body coordinates */
    uint64_t user_data;             /* 0 */
    float break_force;              /* infinity, N; joint.h describes these six */
    float break_torque;             /* infinity, N m */
    float report_force;             /* infinity, N */
    float report_torque;            /* infinity, N m */
    float constraint_hertz;         /* 0 Hz: as the load needs */
    float constraint_damping_ratio; /* 2 */
    bool has_reference_angle;       /* false: the current angle counts as 0 */
    float reference_angle;          /* rad, if has_reference_angle */
    float lower_angle;              /* minus infinity, rad */
    float upper_angle;              /* infinity, rad */
} fettle_rotary_limit_joint_def;

/** Writes the defaults and `size`. FETTLE_INVALID unless `size` is the size of the structure. */
fettle_code fettle_distance_joint_def_init(fettle_distance_joint_def* def, size_t size);
fettle_code fettle_revolute_joint_def_init(fettle_revolute_joint_def* def, size_t size);
fettle_code fettle_prismatic_joint_def_init(fettle_prismatic_joint_def* def, size_t size);
fettle_code fettle_wheel_joint_def_init(fettle_wheel_joint_def* def, size_t size);
fettle_code fettle_weld_joint_def_init(fettle_weld_joint_def* def, size_t size);
fettle_code fettle_motor_joint_def_init(fettle_motor_joint_def* def, size_t size);
fettle_code fettle_pulley_joint_def_init(fettle_pulley_joint_def* def, size_t size);
fettle_code fettle_gear_joint_def_init(fettle_gear_joint_def* def, size_t size);
fettle_code fettle_groove_joint_def_init(fettle_groove_joint_def* def, size_t size);
fettle_code fettle_pin_slot_joint_def_init(fettle_pin_slot_joint_def* def, size_t size);
fettle_code fettle_ratchet_joint_def_init(fettle_ratchet_joint_def* def, size_t size);
fettle_code fettle_filter_joint_def_init(fettle_filter_joint_def* def, size_t size);
fettle_code fettle_rotary_limit_joint_def_init(fettle_rotary_limit_joint_def* def, size_t size);

FETTLE_PHYSICS_C_END
