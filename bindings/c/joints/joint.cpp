#include <calls/calls.h>

#include <fettle/physics_c/joint.h>

using namespace fettle::physics;
using namespace fettle::physics_c;

bool fettle_joint_is_valid(const fettle_world* world, fettle_id joint) {
    return lives<JointId>(world, joint);
}

fettle_code fettle_joint_destroy(fettle_world* world, fettle_id joint) {
    return edit<&Joint::destroy>(__func__, world, joint);
}

fettle_code fettle_joint_type(const fettle_world* world, fettle_id joint, int32_t* type) {
    return read<&Joint::type>(__func__, world, joint, type);
}

fettle_code fettle_joint_body_a(const fettle_world* world, fettle_id joint, fettle_id* body_a) {
    return read<&Joint::body_a>(__func__, world, joint, body_a);
}

fettle_code fettle_joint_set_body_a(fettle_world* world, fettle_id joint, fettle_id body) {
    return on<Joint>(__func__, world, joint,
                     [&](Joint it) { it.set_body_a(body_or_world("body_a", world, body)); });
}

fettle_code fettle_joint_body_b(const fettle_world* world, fettle_id joint, fettle_id* body_b) {
    return read<&Joint::body_b>(__func__, world, joint, body_b);
}

fettle_code fettle_joint_set_body_b(fettle_world* world, fettle_id joint, fettle_id body) {
    return on<Joint>(__func__, world, joint,
                     [&](Joint it) { it.set_body_b(body_or_world("body_b", world, body)); });
}

fettle_code fettle_joint_connect(fettle_world* world, fettle_id joint, fettle_id body_a,
                                 fettle_id body_b) {
    return on<Joint>(__func__, world, joint, [&](Joint it) {
        it.connect(body_or_world("body_a", world, body_a), body_or_world("body_b", world, body_b));
    });
}

fettle_code fettle_joint_disconnect(fettle_world* world, fettle_id joint) {
    return edit<&Joint::disconnect>(__func__, world, joint);
}

fettle_code fettle_joint_dormant(const fettle_world* world, fettle_id joint, bool* dormant) {
    return read<&Joint::dormant>(__func__, world, joint, dormant);
}

fettle_code fettle_joint_anchor_a(const fettle_world* world, fettle_id joint,
                                  fettle_position* anchor_a) {
    return read<&Joint::anchor_a>(__func__, world, joint, anchor_a);
}

fettle_code fettle_joint_set_anchor_a(fettle_world* world, fettle_id joint, fettle_coordinate x,
                                      fettle_coordinate y) {
    return edit<&Joint::set_anchor_a>(__func__, world, joint, Position(x, y));
}

fettle_code fettle_joint_anchor_b(const fettle_world* world, fettle_id joint,
                                  fettle_position* anchor_b) {
    return read<&Joint::anchor_b>(__func__, world, joint, anchor_b);
}

fettle_code fettle_joint_set_anchor_b(fettle_world* world, fettle_id joint, fettle_coordinate x,
                                      fettle_coordinate y) {
    return edit<&Joint::set_anchor_b>(__func__, world, joint, Position(x, y));
}

fettle_code fettle_joint_world_anchor_a(const fettle_world* world, fettle_id joint,
                                        fettle_position* world_anchor_a) {
    return read<&Joint::world_anchor_a>(__func__, world, joint, world_anchor_a);
}

fettle_code fettle_joint_world_anchor_b(const fettle_world* world, fettle_id joint,
                                        fettle_position* world_anchor_b) {
    return read<&Joint::world_anchor_b>(__func__, world, joint, world_anchor_b);
}

fettle_code fettle_joint_enabled(const fettle_world* world, fettle_id joint, bool* enabled) {
    return read<&Joint::enabled>(__func__, world, joint, enabled);
}

fettle_code fettle_joint_set_enabled(fettle_world* world, fettle_id joint, bool enabled) {
    return edit<&Joint::set_enabled>(__func__, world, joint, enabled);
}

fettle_code fettle_joint_collide(const fettle_world* world, fettle_id joint, bool* collide) {
    return read<&Joint::collide>(__func__, world, joint, collide);
}

fettle_code fettle_joint_set_collide(fettle_world* world, fettle_id joint, bool collide) {
    return edit<&Joint::set_collide>(__func__, world, joint, collide);
}

fettle_code fettle_joint_break_force(const fettle_world* world, fettle_id joint,
                                     float* break_force) {
    return read<&Joint::break_force>(__func__, world, joint, break_force);
}

fettle_code fettle_joint_set_break_force(fettle_world* world, fettle_id joint, float break_force) {
    return edit<&Joint::set_break_force>(__func__, world, joint, break_force);
}

fettle_code fettle_joint_break_torque(const fettle_world* world, fettle_id joint,
                                      float* break_torque) {
    return read<&Joint::break_torque>(__func__, world, joint, break_torque);
}

fettle_code fettle_joint_set_break_torque(fettle_world* world, fettle_id joint,
                                          float break_torque) {
    return edit<&Joint::set_break_torque>(__func__, world, joint, break_torque);
}

fettle_code fettle_joint_report_force(const fettle_world* world, fettle_id joint,
                                      float* report_force) {
    return read<&Joint::report_force>(__func__, world, joint, report_force);
}

fettle_code fettle_joint_set_report_force(fettle_world* world, fettle_id joint,
                                          float report_force) {
    return edit<&Joint::set_report_force>(__func__, world, joint, report_force);
}

fettle_code fettle_joint_report_torque(const fettle_world* world, fettle_id joint,
                                       float* report_torque) {
    return read<&Joint::report_torque>(__func__, world, joint, report_torque);
}

fettle_code fettle_joint_set_report_torque(fettle_world* world, fettle_id joint,
                                           float report_torque) {
    return edit<&Joint::set_report_torque>(__func__, world, joint, report_torque);
}

fettle_code fettle_joint_constraint_hertz(const fettle_world* world, fettle_id joint,
                                          float* constraint_hertz) {
    return read<&Joint::constraint_hertz>(__func__, world, joint, constraint_hertz);
}

fettle_code fettle_joint_set_constraint_hertz(fettle_world* world, fettle_id joint,
                                              float constraint_hertz) {
    return edit<&Joint::set_constraint_hertz>(__func__, world, joint, constraint_hertz);
}

fettle_code fettle_joint_constraint_damping_ratio(const fettle_world* world, fettle_id joint,
                                                  float* constraint_damping_ratio) {
    return read<&Joint::constraint_damping_ratio>(__func__, world, joint, constraint_damping_ratio);
}

fettle_code fettle_joint_set_constraint_damping_ratio(fettle_world* world, fettle_id joint,
                                                      float constraint_damping_ratio) {
    return edit<&Joint::set_constraint_damping_ratio>(__func__, world, joint,
                                                      constraint_damping_ratio);
}

fettle_code fettle_joint_separation(const fettle_world* world, fettle_id joint, float* separation) {
    return read<&Joint::separation>(__func__, world, joint, separation);
}

fettle_code fettle_joint_angular_separation(const fettle_world* world, fettle_id joint,
                                            float* angular_separation) {
    return read<&Joint::angular_separation>(__func__, world, joint, angular_separation);
}

fettle_code fettle_joint_broken(const fettle_world* world, fettle_id joint, bool* broken) {
    return read<&Joint::broken>(__func__, world, joint, broken);
}

fettle_code fettle_joint_set_broken(fettle_world* world, fettle_id joint, bool broken) {
    return edit<&Joint::set_broken>(__func__, world, joint, broken);
}

fettle_code fettle_joint_force(const fettle_world* world, fettle_id joint, fettle_vec2* force) {
    return read<&Joint::force>(__func__, world, joint, force);
}

fettle_code fettle_joint_torque(const fettle_world* world, fettle_id joint, float* torque) {
    return read<&Joint::torque>(__func__, world, joint, torque);
}

fettle_code fettle_joint_user_data(const fettle_world* world, fettle_id joint,
                                   uint64_t* user_data) {
    return read<&Joint::user_data>(__func__, world, joint, user_data);
}

fettle_code fettle_joint_set_user_data(fettle_world* world, fettle_id joint, uint64_t user_data) {
    return edit<&Joint::set_user_data>(__func__, world, joint, user_data);
}
