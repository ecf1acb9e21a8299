#include <fettle/physics_c/world.h>

#include <calls/calls.h>

using namespace fettle::physics;
using namespace fettle::physics_c;

// --- Objects

fettle_code fettle_world_create_body(fettle_world* world, const fettle_body_def* def,
                                     fettle_id* body) {
    return guarded(__func__,
                   [&] { store_id(body, editable(world).create_body(definition_of(def)).id()); });
}

fettle_code fettle_world_create_shape(fettle_world* world, const fettle_geometry* geometry,
                                      const fettle_shape_def* def, fettle_id* shape) {
    return guarded(__func__, [&] {
        store_id(shape,
                 editable(world).create_shape(geometry_of(geometry), definition_of(def)).id());
    });
}

fettle_code fettle_world_create_field(fettle_world* world, const fettle_field_def* def,
                                      fettle_id* field) {
    return guarded(__func__,
                   [&] { store_id(field, editable(world).create_field(definition_of(def)).id()); });
}

fettle_code fettle_world_create_joint(fettle_world* world, int32_t type, uint64_t user_data,
                                      fettle_id* joint) {
    return guarded(__func__, [&] {
        World& in = editable(world);
        store_id(
            joint,
            in.create_joint(enumerator("type", type, JointType::rotary_limit), user_data).id());
    });
}

fettle_code fettle_world_create_joint_like(fettle_world* world, const fettle_world* of,
                                           fettle_id like, fettle_id* joint) {
    return guarded(__func__, [&] {
        store_id(joint, editable(world).create_joint(handle<Joint>(of, like)).id());
    });
}

fettle_code fettle_world_create_mouse_joint(fettle_world* world, const fettle_mouse_joint_def* def,
                                            fettle_id* joint) {
    return guarded(__func__, [&] {
        store_id(joint, editable(world).create_mouse_joint(definition_of(world, def)).id());
    });
}

fettle_code fettle_world_bodies(const fettle_world* world, fettle_id* out, uint32_t room,
                                uint32_t* count) {
    return list<&World::bodies>(__func__, world, out, room, count);
}

fettle_code fettle_world_shapes(const fettle_world* world, fettle_id* out, uint32_t room,
                                uint32_t* count) {
    return list<&World::shapes>(__func__, world, out, room, count);
}

fettle_code fettle_world_joints(const fettle_world* world, fettle_id* out, uint32_t room,
                                uint32_t* count) {
    return list<&World::joints>(__func__, world, out, room, count);
}

fettle_code fettle_world_fields(const fettle_world* world, fettle_id* out, uint32_t room,
                                uint32_t* count) {
    return list<&World::fields>(__func__, world, out, room, count);
}

fettle_code fettle_world_moved_bodies(const fettle_world* world, fettle_id* out, uint32_t room,
                                      uint32_t* count) {
    return list<&World::moved_bodies>(__func__, world, out, room, count);
}

fettle_code fettle_world_body_count(const fettle_world* world, uint32_t* body_count) {
    return read<&World::body_count>(__func__, world, body_count);
}

fettle_code fettle_world_shape_count(const fettle_world* world, uint32_t* shape_count) {
    return read<&World::shape_count>(__func__, world, shape_count);
}

fettle_code fettle_world_joint_count(const fettle_world* world, uint32_t* joint_count) {
    return read<&World::joint_count>(__func__, world, joint_count);
}
