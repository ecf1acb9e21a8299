#include <calls/properties.h>

#include <fettle/physics_c/joint.h>

using namespace fettle::physics;
using namespace fettle::physics_c;

bool fettle_joint_is_valid(const fettle_world* world, fettle_id joint) {
    return lives<JointId>(world, joint);
}

fettle_code fettle_joint_destroy(fettle_world* world, fettle_id joint) {
    return edit<&Joint::destroy>(__func__, world, joint);
}

FETTLE_READING(joint, Joint, type, int32_t)
FETTLE_READING(joint, Joint, body_a, fettle_id)

fettle_code fettle_joint_set_body_a(fettle_world* world, fettle_id joint, fettle_id body) {
    return on<Joint>(__func__, world, joint,
                     [&](Joint it) { it.set_body_a(body_or_world("body_a", world, body)); });
}

FETTLE_READING(joint, Joint, body_b, fettle_id)

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

FETTLE_READING(joint, Joint, dormant, bool)
FETTLE_POSITION(joint, Joint, anchor_a)
FETTLE_POSITION(joint, Joint, anchor_b)
FETTLE_READING(joint, Joint, world_anchor_a, fettle_position)
FETTLE_READING(joint, Joint, world_anchor_b, fettle_position)
FETTLE_PROPERTY(joint, Joint, enabled, bool)
FETTLE_PROPERTY(joint, Joint, collide, bool)
FETTLE_PROPERTY(joint, Joint, break_force, float)
FETTLE_PROPERTY(joint, Joint, break_torque, float)
FETTLE_PROPERTY(joint, Joint, report_force, float)
FETTLE_PROPERTY(joint, Joint, report_torque, float)
FETTLE_PROPERTY(joint, Joint, constraint_hertz, float)
FETTLE_PROPERTY(joint, Joint, constraint_damping_ratio, float)
FETTLE_READING(joint, Joint, separation, float)
FETTLE_READING(joint, Joint, angular_separation, float)
FETTLE_PROPERTY(joint, Joint, broken, bool)
FETTLE_READING(joint, Joint, force, fettle_vec2)
FETTLE_READING(joint, Joint, torque, float)
FETTLE_PROPERTY(joint, Joint, user_data, uint64_t)
