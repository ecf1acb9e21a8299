/* Joints of any type, between two bodies or between one body and the world. As an argument or a
 * result, id 0 stands for the world. Errors are those of basics.h. A setter wakes both bodies.
 * Destroying a body destroys its joints. */

#pragma once

#include <fettle/physics_c/basics.h>

FETTLE_PHYSICS_C_BEGIN

/** Whether the id is that of a live joint of this world; false for null and for any other value. */
bool fettle_joint_is_valid(const fettle_world* world, fettle_id joint);

/** Destroys the joint. */
fettle_code fettle_joint_destroy(fettle_world* world, fettle_id joint);

/** One of fettle_joint_type. */
fettle_code fettle_joint_type(const fettle_world* world, fettle_id joint, int32_t* type);

/** Body a; 0: the world. The setter keeps the body coordinates of the anchor, and refuses the
    other body of the joint. */
fettle_code fettle_joint_body_a(const fettle_world* world, fettle_id joint, fettle_id* body_a);
fettle_code fettle_joint_set_body_a(fettle_world* world, fettle_id joint, fettle_id body);

/** Body b; 0: the world. The setter keeps the body coordinates of the anchor, and refuses the
    other body of the joint. */
fettle_code fettle_joint_body_b(const fettle_world* world, fettle_id joint, fettle_id* body_b);
fettle_code fettle_joint_set_body_b(fettle_world* world, fettle_id joint, fettle_id body);

/** Sets both bodies at once; they must differ, and one may be the world (0). */
fettle_code fettle_joint_connect(fettle_world* world, fettle_id joint, fettle_id body_a,
                                 fettle_id body_b);

/** Removes both bodies: the joint is dormant, keeps its settings, and does nothing. */
fettle_code fettle_joint_disconnect(fettle_world* world, fettle_id joint);

/** Whether it has no bodies; then both are the world. */
fettle_code fettle_joint_dormant(const fettle_world* world, fettle_id joint, bool* dormant);

/** Body coordinates of a, m, from -1e8 to 1e8. */
fettle_code fettle_joint_anchor_a(const fettle_world* world, fettle_id joint,
                                  fettle_position* anchor_a);
fettle_code fettle_joint_set_anchor_a(fettle_world* world, fettle_id joint, fettle_coordinate x,
                                      fettle_coordinate y);

/** Body coordinates of b, m, from -1e8 to 1e8. */
fettle_code fettle_joint_anchor_b(const fettle_world* world, fettle_id joint,
                                  fettle_position* anchor_b);
fettle_code fettle_joint_set_anchor_b(fettle_world* world, fettle_id joint, fettle_coordinate x,
                                      fettle_coordinate y);

/** Anchor a in the world, m. */
fettle_code fettle_joint_world_anchor_a(const fettle_world* world, fettle_id joint,
                                        fettle_position* world_anchor_a);

/** Anchor b in the world, m. */
fettle_code fettle_joint_world_anchor_b(const fettle_world* world, fettle_id joint,
                                        fettle_position* world_anchor_b);

/** Whether it acts at all. */
fettle_code fettle_joint_enabled(const fettle_world* world, fettle_id joint, bool* enabled);
fettle_code fettle_joint_set_enabled(fettle_world* world, fettle_id joint, bool enabled);

/** Whether its two bodies collide with each other. */
fettle_code fettle_joint_collide(const fettle_world* world, fettle_id joint, bool* collide);
fettle_code fettle_joint_set_collide(fettle_world* world, fettle_id joint, bool collide);

/** N, at least 0: if the mean force over a step is higher, the joint breaks. Infinity (the
    default): never. */
fettle_code fettle_joint_break_force(const fettle_world* world, fettle_id joint,
                                     float* break_force);
fettle_code fettle_joint_set_break_force(fettle_world* world, fettle_id joint, float break_force);

/** N m, at least 0; as break_force. */
fettle_code fettle_joint_break_torque(const fettle_world* world, fettle_id joint,
                                      float* break_torque);
fettle_code fettle_joint_set_break_torque(fettle_world* world, fettle_id joint, float break_torque);

/** N, at least 0: in each step in which the mean force is higher, the events have it in
    joint_loaded. Infinity (the default): never. */
fettle_code fettle_joint_report_force(const fettle_world* world, fettle_id joint,
                                      float* report_force);
fettle_code fettle_joint_set_report_force(fettle_world* world, fettle_id joint, float report_force);

/** N m, at least 0; as report_force. */
fettle_code fettle_joint_report_torque(const fettle_world* world, fettle_id joint,
                                       float* report_torque);
fettle_code fettle_joint_set_report_torque(fettle_world* world, fettle_id joint,
                                           float report_torque);

/** Hz, at least 0, finite: how fast the joint corrects an error of its position. 0 (the default):
    60, and more where it connects bodies of very different masses. */
fettle_code fettle_joint_constraint_hertz(const fettle_world* world, fettle_id joint,
                                          float* constraint_hertz);
fettle_code fettle_joint_set_constraint_hertz(fettle_world* world, fettle_id joint,
                                              float constraint_hertz);

/** From 0 to 1000; 2 by default. Only with a constraint_hertz. */
fettle_code fettle_joint_constraint_damping_ratio(const fettle_world* world, fettle_id joint,
                                                  float* constraint_damping_ratio);
fettle_code fettle_joint_set_constraint_damping_ratio(fettle_world* world, fettle_id joint,
                                                      float constraint_damping_ratio);

/** m: distance of the anchors from where the joint should hold them; soft springs do not count. */
fettle_code fettle_joint_separation(const fettle_world* world, fettle_id joint, float* separation);

/** Rad, as separation. */
fettle_code fettle_joint_angular_separation(const fettle_world* world, fettle_id joint,
                                            float* angular_separation);

/** Whether it broke; then it has no effect. Setting false repairs it. */
fettle_code fettle_joint_broken(const fettle_world* world, fettle_id joint, bool* broken);
fettle_code fettle_joint_set_broken(fettle_world* world, fettle_id joint, bool broken);

/** N, on body b in the last step. */
fettle_code fettle_joint_force(const fettle_world* world, fettle_id joint, fettle_vec2* force);

/** N m, on body b in the last step, without the torque of the force. */
fettle_code fettle_joint_torque(const fettle_world* world, fettle_id joint, float* torque);

/** Any number of the host's. It is part of snapshots. */
fettle_code fettle_joint_user_data(const fettle_world* world, fettle_id joint, uint64_t* user_data);
fettle_code fettle_joint_set_user_data(fettle_world* world, fettle_id joint, uint64_t user_data);

FETTLE_PHYSICS_C_END
