#include <fettle_physics.h>
#include <math.h>
#include <stdio.h>

#include "in_c.h"
#include "small_world.h"

static const char* a_ball_falls_on_a_box(void) {
    fettle_world* world = new_world();
    const fettle_id ground = new_body(world, FETTLE_BODY_STATIC, 0, -0.5f);
    const fettle_id ball = new_body(world, FETTLE_BODY_DYNAMIC, 0, 3);
    fettle_position position;
    fettle_events events;
    float mass;
    int touches = 0;
    CHECK_C(add(world, ground, FETTLE_SHAPE_BOX) != 0 && add(world, ball, FETTLE_SHAPE_CIRCLE) != 0);
    DONE_C(fettle_body_mass(world, ball, &mass));
    CHECK_C(fabsf(mass - 3.14159265f / 4) < 1e-3f);
    for (int i = 0; i < 120; ++i) {
        DONE_C(fettle_world_step(world, 1.0f / 60));
        DONE_C(fettle_world_events(world, &events));
        for (uint32_t k = 0; k < events.contact_begin_count; ++k) {
            const fettle_contact_event* event = &events.contact_begin[k];
            CHECK_C(event->body_a == ball || event->body_b == ball);
            CHECK_C(event->speed > 5);
            ++touches;
        }
    }
    CHECK_C(touches == 1);
    DONE_C(fettle_body_position(world, ball, &position));
    CHECK_C(fabs(position.y - 0.5) < 0.02);
    DONE_C(fettle_world_destroy(world));
    return NULL;
}

static const char* definitions_have_the_defaults_of_the_library(void) {
    fettle_world_def world;
    fettle_body_def body;
    fettle_shape_def shape;
    fettle_geometry box;
    fettle_field_def liquid;
    fettle_mouse_joint_def mouse;
    DONE_C(fettle_world_def_init(&world, sizeof world));
    CHECK_C(world.size == sizeof world && world.gravity.y == -10 && world.substeps == 4);
    CHECK_C(world.friction_mix == FETTLE_MIX_GEOMETRIC && world.sleeping && !world.has_bounds);
    DONE_C(fettle_body_def_init(&body, sizeof body));
    CHECK_C(body.type == FETTLE_BODY_DYNAMIC && body.gravity_scale == 1 && body.awake);
    DONE_C(fettle_shape_def_init(&shape, sizeof shape));
    CHECK_C(shape.density == 1 && shape.mask == UINT64_MAX && shape.category == 1);
    DONE_C(fettle_geometry_init(&box, sizeof box, FETTLE_SHAPE_BOX));
    CHECK_C(box.width == 1 && box.height == 1 && box.radius == 0);
    DONE_C(fettle_field_def_init(&liquid, sizeof liquid, FETTLE_FIELD_BUOYANCY));
    CHECK_C(liquid.density == 2 && liquid.normal.y == 1 && liquid.enabled);
    DONE_C(fettle_mouse_joint_def_init(&mouse, sizeof mouse));
    CHECK_C(isinf(mouse.max_force) && mouse.hertz == 5);
    return NULL;
}

static const char* a_wrong_size_is_refused_and_nothing_is_written(void) {
    fettle_world* world = new_world();
    fettle_body_def def;
    uint32_t count;
    memset(&def, 7, sizeof def);
    CHECK_C(fettle_body_def_init(&def, sizeof def - 4) == FETTLE_INVALID);
    CHECK_C(def.type == 0x07070707);
    CHECK_C(fettle_world_create_body(world, &def, NULL) == FETTLE_INVALID);
    CHECK_C(message_has("fettle_world_create_body: size = 117901063: expected"));
    DONE_C(fettle_world_body_count(world, &count));
    CHECK_C(count == 0);
    DONE_C(fettle_world_destroy(world));
    return NULL;
}

static const char* ids_of_another_kind_or_world_are_refused(void) {
    fettle_world *world = new_world(), *other = new_world();
    const fettle_id ball = new_body(world, FETTLE_BODY_DYNAMIC, 0, 0);
    const fettle_id shape = add(world, ball, FETTLE_SHAPE_CIRCLE);
    float value = 7;
    CHECK_C(fettle_body_is_valid(world, ball) && !fettle_body_is_valid(other, ball));
    CHECK_C(!fettle_body_is_valid(NULL, ball) && !fettle_shape_is_valid(world, ball));
    CHECK_C(fettle_body_angle(world, shape, &value) == FETTLE_INVALID);
    CHECK_C(message_has("expected the id of a body") && message_has("which names a shape"));
    CHECK_C(fettle_body_angle(other, ball, &value) == FETTLE_STALE);
    char object[64];
    snprintf(object, sizeof object, "got that of body %u (0x%016llx)", (unsigned)fettle_slot(ball),
             (unsigned long long)ball);
    CHECK_C(message_has(object) && message_has("), which was destroyed, or is of another world"));
    CHECK_C(fettle_body_angle(world, 0, &value) == FETTLE_STALE && message_has("names none"));
    CHECK_C(fettle_body_angle(world, UINT64_MAX, &value) == FETTLE_INVALID);
    CHECK_C(fettle_body_angle(NULL, ball, &value) == FETTLE_INVALID && message_has("world"));
    CHECK_C(fettle_body_angle(world, ball, NULL) == FETTLE_INVALID && message_has("null"));
    fettle_weld_joint_def def;
    fettle_id joint = 0;
    DONE_C(fettle_weld_joint_def_init(&def, sizeof def));
    def.body_a = ball;
    def.body_b = shape;
    CHECK_C(fettle_world_create_weld_joint(world, &def, &joint) == FETTLE_INVALID && joint == 0);
    CHECK_C(message_has("weld_joint: body_b: expected the id of a body"));
    const fettle_id bodies[2] = {ball, 0};
    fettle_body_state states[2];
    const fettle_world* const worlds[1] = {world};
    CHECK_C(fettle_worlds_read_states(worlds, 1, bodies, 2, states) == FETTLE_STALE);
    CHECK_C(message_has("bodies[1]: expected the id of a body, got 0"));
    CHECK_C(fettle_world_step(world, NAN) == FETTLE_INVALID && message_has("dt = nan: expected"));
    DONE_C(fettle_body_destroy(world, ball));
    CHECK_C(fettle_body_destroy(world, ball) == FETTLE_STALE);
    CHECK_C(fettle_shape_friction(world, shape, &value) == FETTLE_STALE);
    CHECK_C(value == 7);
    DONE_C(fettle_world_destroy(other));
    CHECK_C(fettle_world_step(other, 1) == FETTLE_STALE && message_has("it was destroyed"));
    CHECK_C(fettle_world_destroy(other) == FETTLE_STALE);
    DONE_C(fettle_world_destroy(world));
    return NULL;
}

static const char* values_without_meaning_are_refused_by_name(void) {
    fettle_world* world = new_world();
    const fettle_id ball = new_body(world, FETTLE_BODY_DYNAMIC, 1, 2);
    const fettle_id shape = add(world, ball, FETTLE_SHAPE_CIRCLE);
    fettle_position position;
    fettle_pose pose;
    bool inside;
    CHECK_C(fettle_body_set_position(world, ball, NAN, 0) == FETTLE_INVALID);
    CHECK_C(message_has("fettle_body_set_position: position"));
    CHECK_C(fettle_body_set_linear_damping(world, ball, -1) == FETTLE_INVALID);
    CHECK_C(fettle_body_set_type(world, ball, 256) == FETTLE_INVALID && message_has("0 to 2"));
    CHECK_C(fettle_shape_set_restitution(world, shape, 2) == FETTLE_INVALID);
    CHECK_C(fettle_shape_set_width(world, shape, 2) == FETTLE_INVALID && message_has("a circle"));
    CHECK_C(fettle_body_interpolated(world, ball, NAN, &pose) == FETTLE_INVALID);
    CHECK_C(fettle_shape_contains(world, shape, 0, NAN, &inside) == FETTLE_INVALID);
    CHECK_C(fettle_world_step(world, NAN) == FETTLE_INVALID);
    DONE_C(fettle_body_position(world, ball, &position));
    CHECK_C(position.x == 1 && position.y == 2);
    DONE_C(fettle_world_destroy(world));
    return NULL;
}

static const char* columns_are_the_states_themselves(void) {
    fettle_world* world = new_world();
    const fettle_id ball = new_body(world, FETTLE_BODY_DYNAMIC, 0, 5);
    fettle_columns columns;
    fettle_body_state state;
    fettle_position position;
    int32_t written;
    DONE_C(fettle_world_columns(world, &columns));
    CHECK_C(fettle_slot(ball) < columns.body_slots);
    const fettle_body_state* at = &columns.states[fettle_slot(ball)];
    CHECK_C(at->position.y == 5);
    run(world, 30);
    DONE_C(fettle_body_position(world, ball, &position));
    CHECK_C(at->position.y == position.y && position.y < 4.5f);
    CHECK_C(columns.previous[fettle_slot(ball)].position.y > position.y);
    DONE_C(fettle_world_write_velocity(world, fettle_slot(ball), 3, 4, &written));
    CHECK_C(written == FETTLE_WRITTEN_DONE && at->velocity.x == 3 && at->velocity.y == 4);
    DONE_C(fettle_world_state(world, fettle_slot(ball), &state));
    CHECK_C(state.velocity.x == 3);
    CHECK_C(fettle_world_state(world, 1000, &state) == FETTLE_STALE);
    CHECK_C(fettle_world_write(world, fettle_slot(ball), FETTLE_NUMBER_LINEAR_DAMPING, -1,
                               &written) == FETTLE_INVALID);
    DONE_C(fettle_world_destroy(world));
    return NULL;
}

static const char* a_saved_world_goes_on_along_the_same_bits(void) {
    fettle_world *world = new_world(), *copy = NULL, *other = new_world();
    const void* bytes;
    size_t size;
    uint64_t first, second, third;
    add(world, new_body(world, FETTLE_BODY_STATIC, 0, -1), FETTLE_SHAPE_BOX);
    for (int i = 0; i < 5; ++i)
        add(world, new_body(world, FETTLE_BODY_DYNAMIC, 0.1f * (float)i, 1 + (float)i), FETTLE_SHAPE_BOX);
    run(world, 20);
    DONE_C(fettle_world_clone(world, &copy));
    DONE_C(fettle_world_save(world, &bytes, &size));
    DONE_C(fettle_world_restore(other, bytes, size));
    run(world, 40);
    run(copy, 40);
    run(other, 40);
    DONE_C(fettle_world_hash(world, &first));
    DONE_C(fettle_world_hash(copy, &second));
    DONE_C(fettle_world_hash(other, &third));
    CHECK_C(first == second && first == third);
    CHECK_C(fettle_world_restore(other, bytes, size - 1) == FETTLE_INVALID);
    CHECK_C(fettle_world_take(other, other) == FETTLE_INVALID);
    DONE_C(fettle_world_restore(world, bytes, size));
    DONE_C(fettle_world_assign(copy, world));
    run(copy, 40);
    DONE_C(fettle_world_hash(copy, &second));
    CHECK_C(first == second);
    DONE_C(fettle_world_destroy(world));
    DONE_C(fettle_world_destroy(copy));
    DONE_C(fettle_world_destroy(other));
    return NULL;
}

static const char* a_list_says_how_many_there_are(void) {
    fettle_world* world = new_world();
    fettle_id bodies[3] = {1, 1, 1};
    uint32_t count = 0;
    const fettle_id first = new_body(world, FETTLE_BODY_DYNAMIC, 0, 0);
    new_body(world, FETTLE_BODY_DYNAMIC, 0, 3);
    DONE_C(fettle_world_bodies(world, NULL, 0, &count));
    CHECK_C(count == 2);
    DONE_C(fettle_world_bodies(world, bodies, 1, &count));
    CHECK_C(count == 2 && bodies[0] == first && bodies[1] == 1);
    CHECK_C(fettle_world_bodies(world, NULL, 1, &count) == FETTLE_INVALID);
    DONE_C(fettle_world_destroy(world));
    return NULL;
}

static const char* joints_are_told_apart_by_their_type(void) {
    fettle_world* world = new_world();
    fettle_revolute_joint_def def;
    fettle_id joint, other;
    fettle_position position;
    float angle;
    const fettle_id ball = new_body(world, FETTLE_BODY_DYNAMIC, 1, 0);
    add(world, ball, FETTLE_SHAPE_CIRCLE);
    DONE_C(fettle_revolute_joint_def_init(&def, sizeof def));
    def.body_b = ball;
    def.anchor_b = (fettle_position){-1, 0};
    def.motor_speed = 2;
    def.max_motor_torque = INFINITY;
    DONE_C(fettle_world_create_revolute_joint(world, &def, &joint));
    CHECK_C(fettle_gear_joint_set_ratio(world, joint, 2) == FETTLE_INVALID);
    CHECK_C(message_has("expected a gear joint, got a revolute joint"));
    CHECK_C(fettle_mouse_joint_target(world, joint, &position) == FETTLE_INVALID);
    run(world, 60);
    DONE_C(fettle_revolute_joint_angle(world, joint, &angle));
    CHECK_C(fabsf(angle - 2) < 0.05f);
    DONE_C(fettle_body_position(world, ball, &position));
    CHECK_C(fabs(position.x * position.x + position.y * position.y - 1) < 0.02);
    DONE_C(fettle_world_create_joint_like(world, world, joint, &other));
    DONE_C(fettle_revolute_joint_motor_speed(world, other, &angle));
    CHECK_C(angle == 2);
    CHECK_C(fettle_world_create_revolute_joint(world, NULL, &joint) == FETTLE_INVALID);
    DONE_C(fettle_world_destroy(world));
    return NULL;
}

static const char* a_liquid_lifts_what_is_lighter(void) {
    fettle_world* world = new_world();
    fettle_field_def def, told;
    fettle_id field;
    fettle_position position;
    const fettle_id ball = new_body(world, FETTLE_BODY_DYNAMIC, 0, -5);
    add(world, ball, FETTLE_SHAPE_CIRCLE);
    DONE_C(fettle_field_def_init(&def, sizeof def, FETTLE_FIELD_BUOYANCY));
    DONE_C(fettle_world_create_field(world, &def, &field));
    run(world, 600);
    DONE_C(fettle_body_position(world, ball, &position));
    CHECK_C(fabs(position.y) < 0.1);
    told.size = sizeof told;
    DONE_C(fettle_field_definition(world, field, &told));
    CHECK_C(told.type == FETTLE_FIELD_BUOYANCY && told.density == 2);
    def.falloff = 9;
    def.type = FETTLE_FIELD_ATTRACTOR;
    CHECK_C(fettle_field_set(world, field, &def) == FETTLE_INVALID && message_has("falloff"));
    DONE_C(fettle_world_destroy(world));
    return NULL;
}

static const char* many_worlds_are_stepped_and_read_at_once(void) {
    fettle_world* worlds[3];
    fettle_id balls[3];
    fettle_vec2 forces[3] = {{0, 0}, {10, 0}, {20, 0}};
    fettle_body_state states[3];
    for (int i = 0; i < 3; ++i) {
        worlds[i] = new_world();
        balls[i] = new_body(worlds[i], FETTLE_BODY_DYNAMIC, (float)i, 0);
    }
    DONE_C(fettle_worlds_apply_forces(worlds, 3, balls, 1, forces));
    DONE_C(fettle_worlds_step(worlds, 3, 0.1f));
    DONE_C(fettle_worlds_read_states((const fettle_world* const*)worlds, 3, balls, 1, states));
    CHECK_C(states[0].velocity.x == 0 && fabsf(states[1].velocity.x - 1) < 1e-4f);
    CHECK_C(fabsf(states[2].velocity.x - 2) < 1e-4f && states[2].position.x > 2);
    forces[1].y = NAN;
    CHECK_C(fettle_worlds_apply_forces(worlds, 3, balls, 1, forces) == FETTLE_INVALID);
    CHECK_C(message_has("forces[1].y = nan"));
    balls[2] = balls[1];
    CHECK_C(fettle_worlds_apply_forces(worlds, 3, balls, 1, forces) == FETTLE_STALE);
    for (int i = 0; i < 3; ++i) DONE_C(fettle_world_destroy(worlds[i]));
    CHECK_C(fettle_worlds_step(worlds, 3, 0.1f) == FETTLE_STALE);
    return NULL;
}

static const char* geometries_need_no_world(void) {
    fettle_geometry circle, box;
    fettle_mass_properties mass;
    fettle_separation separation;
    fettle_contact_manifold manifold;
    fettle_surface_hit hit;
    fettle_grid_layout layout;
    fettle_line_point points[8];
    const fettle_pose beside = {{3, 0}, 0}, near_it = {{0.99f, 0}, 0};
    const fettle_movement stays = {{{0, 0}, 0}, {{0, 0}, 0}, {0, 0}};
    const fettle_movement comes = {{{5, 0}, 0}, {{-5, 0}, 0}, {0, 0}};
    const float filled[] = {1};
    uint32_t count;
    float fraction;
    bool found;
    DONE_C(fettle_geometry_init(&circle, sizeof circle, FETTLE_SHAPE_CIRCLE));
    DONE_C(fettle_geometry_init(&box, sizeof box, FETTLE_SHAPE_BOX));
    DONE_C(fettle_geometry_mass_properties(&box, 2, &mass));
    CHECK_C(mass.area == 1 && mass.mass == 2 && fabsf(mass.inertia - 1.0f / 3) < 1e-6f);
    DONE_C(fettle_geometry_contains(&box, &beside, 3.4f, 0.4f, &found));
    CHECK_C(found);
    DONE_C(fettle_geometry_distance(&circle, NULL, &box, &beside, &separation));
    CHECK_C(fabsf(separation.distance - 2) < 1e-6f && separation.point_b.x == 2.5f);
    DONE_C(fettle_geometry_contact_manifolds(&box, NULL, &circle, &near_it, 0, &manifold, 1, &count));
    CHECK_C(count == 1 && manifold.point_count == 1 && manifold.normal.x == 1);
    DONE_C(fettle_geometry_cast_ray(&box, NULL, -2, 0, 2, 0, &found, &hit));
    CHECK_C(found && fabsf(hit.fraction - 0.375f) < 1e-6f && hit.normal.x == -1);
    DONE_C(fettle_geometry_time_of_impact(&circle, &comes, &circle, &stays, &found, &fraction));
    CHECK_C(found && fabsf(fraction - 0.4f) < 1e-4f);
    DONE_C(fettle_grid_layout_init(&layout, sizeof layout));
    CHECK_C(fettle_grid_outlines(filled, 1, &layout, 0.5f, 0, points, 8, &count) == FETTLE_INVALID);
    CHECK_C(message_has("values"));
    layout.columns = layout.rows = 1;
    DONE_C(fettle_grid_outlines(filled, 1, &layout, 0.5f, 0, points, 8, &count));
    CHECK_C(count == 4 && points[3].closed && points[3].line == 0);
    DONE_C(fettle_join_lines(points, 4, NULL, points, 8, &count));
    CHECK_C(count == 4 && !points[0].closed);
    return NULL;
}

static const char* bodies_have_names_and_limits_and_are_disabled(void) {
    fettle_world* world = new_world();
    fettle_body_def def;
    fettle_id body = 0, found = 0;
    const char* name = NULL;
    const float sleep_speed = 0.5f;
    float speed = 0;
    bool is_set = false, enabled = true;
    uint32_t count = 9;
    DONE_C(fettle_body_def_init(&def, sizeof def));
    CHECK_C(def.enabled && isinf(def.max_speed) && def.name == NULL && !def.has_sleep_speed);
    def.name = "crate";
    def.max_speed = 2;
    DONE_C(fettle_world_create_body(world, &def, &body));
    CHECK_C(add(world, body, FETTLE_SHAPE_BOX) != 0);
    DONE_C(fettle_body_name(world, body, &name));
    CHECK_C(strcmp(name, "crate") == 0);
    CHECK_C(fettle_body_set_name(world, body, NULL) == FETTLE_INVALID && message_has("name"));
    DONE_C(fettle_body_set_sleep_speed(world, body, &sleep_speed));
    DONE_C(fettle_body_sleep_speed_override(world, body, &is_set, &speed));
    CHECK_C(is_set && speed == 0.5f);
    run(world, 60);
    DONE_C(fettle_world_moved_bodies(world, &found, 1, &count));
    CHECK_C(count == 1 && found == body);
    fettle_position place;
    fettle_vec2 velocity;
    DONE_C(fettle_body_velocity(world, body, &velocity));
    CHECK_C(fabsf(velocity.y + 2) < 1e-3f);
    DONE_C(fettle_body_set_enabled(world, body, false));
    DONE_C(fettle_body_enabled(world, body, &enabled));
    run(world, 10);
    DONE_C(fettle_world_moved_bodies(world, NULL, 0, &count));
    CHECK_C(!enabled && count == 0);
    DONE_C(fettle_body_set_enabled(world, body, true));
    DONE_C(fettle_body_set_target(world, body, 1, 2, 0, 1));
    run(world, 1);
    DONE_C(fettle_body_position(world, body, &place));
    CHECK_C(place.x > 0);
    CHECK_C(fettle_body_set_target(world, body, 1, 2, 0, 0) == FETTLE_INVALID && message_has("dt"));
    DONE_C(fettle_world_reserve(world, 100, 100, 100, 100));
    DONE_C(fettle_world_destroy(world));
    return NULL;
}

static const char* contacts_are_named_by_two_shapes(void) {
    fettle_world* world = new_world();
    const fettle_id ground = new_body(world, FETTLE_BODY_STATIC, 0, -0.5f);
    const fettle_id ball = new_body(world, FETTLE_BODY_DYNAMIC, 0, 0.5f);
    const fettle_id top = add(world, ground, FETTLE_SHAPE_BOX);
    const fettle_id round = add(world, ball, FETTLE_SHAPE_CIRCLE);
    fettle_contact contact;
    fettle_position place;
    uint32_t count = 0, material = 0;
    uint64_t number = 0;
    bool touching = false;
    run(world, 10);
    DONE_C(fettle_world_is_touching(world, round, top, &touching));
    DONE_C(fettle_world_contacts_of(world, round, top, &contact, 1, &count));
    CHECK_C(touching && count == 1 && contact.point_count == 1);
    DONE_C(fettle_shape_set_material(world, round, 7));
    DONE_C(fettle_shape_material(world, round, &material));
    CHECK_C(material == 7);
    CHECK_C(fettle_shape_set_material(world, round, 65536) == FETTLE_INVALID &&
            message_has("material"));
    DONE_C(fettle_shape_set_contact_events(world, round, false));
    DONE_C(fettle_world_set_contact_data(world, round, top, 7));
    DONE_C(fettle_world_contact_data(world, top, round, &number));
    CHECK_C(number == 7);
    CHECK_C(fettle_world_set_contact_data(world, round, round, 7) == FETTLE_INVALID &&
            message_has("do not touch"));
    DONE_C(fettle_world_ignore_until_separated(world, round, top));
    run(world, 60);
    DONE_C(fettle_body_position(world, ball, &place));
    CHECK_C(place.y < -2);
    DONE_C(fettle_world_is_touching(world, round, ground, &touching));
    CHECK_C(!touching);
    DONE_C(fettle_world_destroy(world));
    return NULL;
}

static const char* a_mover_walks_to_a_wall(void) {
    fettle_world* world = new_world();
    fettle_mover_def def;
    fettle_mover_state state;
    fettle_moved moved;
    fettle_mover_plane plane;
    uint32_t count;
    bool done;
    const fettle_id wall = new_body(world, FETTLE_BODY_STATIC, 3, 1);
    add(world, wall, FETTLE_SHAPE_BOX);
    DONE_C(fettle_mover_def_init(&def, sizeof def));
    DONE_C(fettle_mover_state_init(&state, sizeof state));
    CHECK_C(def.radius == 0.4f && def.up.y == 1 && def.mask == ~(uint64_t)0);
    for (int i = 0; i < 60; ++i) {
        DONE_C(fettle_mover_move(world, &def, &state, 3, 0, 1.0f / 60, &moved));
        DONE_C(fettle_world_step(world, 1.0f / 60));
    }
    CHECK_C(moved.hit_wall && moved.wall != 0 && !moved.on_ground);
    CHECK_C(state.position.x > 2.05f && state.position.x < 2.1f);
    DONE_C(fettle_mover_planes(world, &def, &state, 0.1f, &plane, 1, &count));
    CHECK_C(count == 1 && plane.normal.x < -0.9f && plane.shape == moved.wall);
    DONE_C(fettle_mover_fits(world, &def, &state, 1, &done));
    CHECK_C(done);
    DONE_C(fettle_mover_set_height(world, &def, &state, 1, &done));
    CHECK_C(done && def.height == 1);
    DONE_C(fettle_mover_drop(world, &def, &state, &done));
    CHECK_C(!done);
    def.skin = 0;
    CHECK_C(fettle_mover_move(world, &def, &state, 3, 0, 1, &moved) == FETTLE_INVALID &&
            message_has("skin"));
    DONE_C(fettle_world_destroy(world));
    return NULL;
}

static const char* an_error_writes_no_result(void) {
    fettle_world* world = new_world();
    const fettle_id ground = new_body(world, FETTLE_BODY_STATIC, 0, 0);
    fettle_geometry line;
    fettle_id chain;
    fettle_vec2 points[3] = {{0, 0}, {1, 0}, {2, 1}}, piece[2] = {{7, 7}, {7, 7}};
    uint32_t count = 7;
    DONE_C(fettle_geometry_init(&line, sizeof line, FETTLE_SHAPE_CHAIN));
    line.points = points;
    line.point_count = 3;
    DONE_C(fettle_body_add(world, ground, &line, NULL, &chain));
    CHECK_C(fettle_shape_pieces(world, chain, 0, piece, 2, &count, NULL) == FETTLE_INVALID);
    CHECK_C(piece[0].x == 7 && piece[1].y == 7 && count == 7);
    fettle_world_destroy(world);
    return NULL;
}

static void destroy(void* times, fettle_world* world) {
    *(int*)times += fettle_world_destroy(world) == FETTLE_DONE;
}

static const char* a_function_after_the_step_may_destroy_the_world(void) {
    fettle_world* world = new_world();
    int times = 0;
    DONE_C(fettle_world_after_step(world, destroy, &times));
    DONE_C(fettle_world_after_step(world, destroy, &times));
    DONE_C(fettle_world_step(world, 1.0f / 60));
    CHECK_C(times == 1);
    CHECK_C(fettle_world_step(world, 1.0f / 60) == FETTLE_STALE);
    return NULL;
}

const struct named_c_test worlds_in_c[] = {
    {"a ball falls on a box", a_ball_falls_on_a_box},
    {"definitions have the defaults of the library", definitions_have_the_defaults_of_the_library},
    {"a wrong size is refused and nothing is written", a_wrong_size_is_refused_and_nothing_is_written},
    {"ids of another kind or world are refused", ids_of_another_kind_or_world_are_refused},
    {"values without meaning are refused by name", values_without_meaning_are_refused_by_name},
    {"columns are the states themselves", columns_are_the_states_themselves},
    {"a saved world goes on along the same bits", a_saved_world_goes_on_along_the_same_bits},
    {"a list says how many there are", a_list_says_how_many_there_are},
    {"joints are told apart by their type", joints_are_told_apart_by_their_type},
    {"a liquid lifts what is lighter", a_liquid_lifts_what_is_lighter},
    {"a mover walks to a wall", a_mover_walks_to_a_wall},
    {"many worlds are stepped and read at once", many_worlds_are_stepped_and_read_at_once},
    {"geometries need no world", geometries_need_no_world},
    {"bodies have names and limits and are disabled", bodies_have_names_and_limits_and_are_disabled},
    {"contacts are named by two shapes", contacts_are_named_by_two_shapes},
    {"an error writes no result", an_error_writes_no_result},
    {"a function after the step may destroy the world",
     a_function_after_the_step_may_destroy_the_world},
    {NULL, NULL}};
