#include <fettle_physics.h>
#include <math.h>
#include <string.h>

#include "in_c.h"

/* A box on the ground, and what was called. */
struct scene {
    fettle_world* world;
    fettle_id ground, box, ground_shape, box_shape;
    int calls;
    int refused; /* edits inside a call */
};

static fettle_id body_with_box(fettle_world* world, int32_t type, float y, fettle_id* shape) {
    fettle_body_def def;
    fettle_geometry geometry;
    fettle_id body = 0;
    fettle_body_def_init(&def, sizeof def);
    def.type = type;
    def.position.y = y;
    fettle_world_create_body(world, &def, &body);
    fettle_geometry_init(&geometry, sizeof geometry, FETTLE_SHAPE_BOX);
    fettle_body_add(world, body, &geometry, NULL, shape);
    return body;
}

static struct scene new_scene(void) {
    struct scene scene = {0};
    fettle_world_create(NULL, &scene.world);
    scene.ground = body_with_box(scene.world, FETTLE_BODY_STATIC, -0.5f, &scene.ground_shape);
    scene.box = body_with_box(scene.world, FETTLE_BODY_DYNAMIC, 0.5f, &scene.box_shape);
    return scene;
}

/* Counts a call, and tries what is forbidden inside it. */
static void try_edits(struct scene* scene) {
    ++scene->calls;
    scene->refused += fettle_body_set_angle(scene->world, scene->box, 1) == FETTLE_LOCKED;
    scene->refused += fettle_world_step(scene->world, 1) == FETTLE_LOCKED;
    scene->refused += fettle_world_destroy(scene->world) == FETTLE_LOCKED;
    scene->refused += fettle_world_create_body(scene->world, NULL, NULL) == FETTLE_LOCKED;
    scene->refused += fettle_world_set_filter(scene->world, NULL, NULL) == FETTLE_LOCKED;
    scene->refused += fettle_world_clear(scene->world) == FETTLE_LOCKED;
}

static int all_refused(const struct scene* scene) {
    return scene->calls > 0 && scene->refused == 6 * scene->calls;
}

static bool pass_none(void* user, const fettle_world* world, fettle_id a, fettle_id b) {
    struct scene* scene = user;
    try_edits(scene);
    return world != scene->world || a == b;
}

static void no_friction(void* user, const fettle_world* world, fettle_contact_edit* contact) {
    struct scene* scene = user;
    try_edits(scene);
    if (fettle_shape_is_valid(world, contact->shape_a)) contact->friction = 0;
}

static void no_contact(void* user, const fettle_world* world, fettle_contact_edit* contact) {
    struct scene* scene = user;
    (void)world;
    try_edits(scene);
    contact->enabled = false;
}

static void count_refresh(void* user, const fettle_world* world, int32_t of, uint32_t slot) {
    struct scene* scene = user;
    (void)world, (void)slot, (void)of;
    try_edits(scene);
}

static const char* a_filter_lets_a_box_fall_through(void) {
    struct scene scene = new_scene();
    fettle_position position;
    DONE_C(fettle_world_set_filter(scene.world, pass_none, &scene));
    for (int i = 0; i < 60; ++i) DONE_C(fettle_world_step(scene.world, 1.0f / 60));
    CHECK_C(all_refused(&scene));
    DONE_C(fettle_body_position(scene.world, scene.box, &position));
    CHECK_C(position.y < -3);
    DONE_C(fettle_world_destroy(scene.world));
    return NULL;
}

static const char* contacts_are_mixed_and_switched_off(void) {
    struct scene scene = new_scene();
    fettle_position position;
    fettle_vec2 velocity;
    DONE_C(fettle_world_set_mixing(scene.world, no_friction, &scene));
    DONE_C(fettle_body_set_velocity(scene.world, scene.box, 0.5f, 0));
    for (int i = 0; i < 30; ++i) DONE_C(fettle_world_step(scene.world, 1.0f / 60));
    DONE_C(fettle_body_velocity(scene.world, scene.box, &velocity));
    CHECK_C(fabsf(velocity.x - 0.5f) < 1e-3f);
    DONE_C(fettle_world_set_mixing(scene.world, NULL, NULL));
    DONE_C(fettle_world_set_before_solve(scene.world, no_contact, &scene));
    for (int i = 0; i < 60; ++i) DONE_C(fettle_world_step(scene.world, 1.0f / 60));
    CHECK_C(all_refused(&scene));
    DONE_C(fettle_body_position(scene.world, scene.box, &position));
    CHECK_C(position.y < -3);
    DONE_C(fettle_world_destroy(scene.world));
    return NULL;
}

static const char* a_read_tells_that_it_updates(void) {
    struct scene scene = new_scene();
    float mass;
    DONE_C(fettle_world_on_refresh(scene.world, count_refresh, &scene));
    DONE_C(fettle_shape_set_width(scene.world, scene.box_shape, 2));
    DONE_C(fettle_body_mass(scene.world, scene.box, &mass));
    CHECK_C(mass == 2 && all_refused(&scene));
    CHECK_C(fettle_world_refresh(scene.world, 3, 0) == FETTLE_INVALID);
    DONE_C(fettle_world_refresh(scene.world, FETTLE_REFRESH_BODY, 1000000));
    DONE_C(fettle_world_destroy(scene.world));
    return NULL;
}

static bool accept_box(void* user, const fettle_world* world, fettle_id shape) {
    struct scene* scene = user;
    (void)world;
    try_edits(scene);
    return shape == scene->box_shape;
}

static bool visit_one(void* user, const fettle_world* world, fettle_id shape) {
    (void)world, (void)shape;
    try_edits(user);
    return false;
}

static bool visit_ray(void* user, const fettle_world* world, const fettle_ray_hit* hit) {
    (void)world;
    try_edits(user);
    return hit->fraction < 2;
}

static const char* queries_find_and_visit(void) {
    struct scene scene = new_scene();
    fettle_query_filter filter;
    fettle_ray_hit hit;
    fettle_point_hit nearest;
    fettle_separation gap;
    fettle_geometry circle;
    const fettle_aabb all = {{-9, -9}, {9, 9}};
    const fettle_pose pose = {{0, 3}, 0};
    fettle_id found[4];
    uint32_t count;
    bool is_found;
    DONE_C(fettle_world_query_aabb(scene.world, &all, NULL, found, 4, &count));
    CHECK_C(count == 2);
    DONE_C(fettle_query_filter_init(&filter, sizeof filter));
    filter.accept = accept_box;
    filter.user = &scene;
    DONE_C(fettle_world_query_aabb(scene.world, &all, &filter, found, 4, &count));
    CHECK_C(count == 1 && found[0] == scene.box_shape && all_refused(&scene));
    scene.calls = scene.refused = 0;
    DONE_C(fettle_world_visit_aabb(scene.world, &all, NULL, visit_one, &scene));
    CHECK_C(scene.calls == 1 && all_refused(&scene));
    DONE_C(fettle_world_visit_ray(scene.world, 0, 5, 0, -5, NULL, visit_ray, &scene));
    CHECK_C(scene.calls == 3 && all_refused(&scene));
    DONE_C(fettle_world_cast_ray(scene.world, 0, 5, 0, -5, NULL, &is_found, &hit));
    CHECK_C(is_found && hit.shape == scene.box_shape && fabs(hit.point.y - 1) < 1e-3);
    DONE_C(fettle_world_cast_ray(scene.world, 5, 5, 6, 5, NULL, &is_found, NULL));
    CHECK_C(!is_found);
    DONE_C(fettle_geometry_init(&circle, sizeof circle, FETTLE_SHAPE_CIRCLE));
    DONE_C(fettle_world_cast_geometry(scene.world, &circle, &pose, 0, -4, NULL, &is_found, &hit));
    CHECK_C(is_found && fabsf(hit.fraction - 0.375f) < 0.01f);
    DONE_C(fettle_world_closest(scene.world, 0, 4, INFINITY, NULL, &is_found, &nearest));
    CHECK_C(is_found && fabsf(nearest.distance - 3) < 1e-3f);
    DONE_C(fettle_distance(scene.world, scene.ground_shape, scene.world, scene.box_shape, &gap));
    CHECK_C(gap.distance < 1e-3f);
    CHECK_C(fettle_world_visit_aabb(scene.world, &all, NULL, NULL, NULL) == FETTLE_INVALID);
    DONE_C(fettle_body_set_angle(scene.world, scene.box, 0)); /* not locked any more */
    DONE_C(fettle_world_destroy(scene.world));
    return NULL;
}

static const char* an_owner_alone_creates_and_destroys(void) {
    struct scene scene = new_scene();
    fettle_owner* owner;
    const char* advice;
    bool acts;
    DONE_C(fettle_owner_create("ask the level instead", &owner));
    DONE_C(fettle_world_set_owner(scene.world, owner));
    CHECK_C(fettle_body_destroy(scene.world, scene.box) == FETTLE_LOCKED);
    CHECK_C(strstr(fettle_last_error(), "ask the level instead") != NULL);
    CHECK_C(fettle_owner_destroy(owner) == FETTLE_LOCKED);
    CHECK_C(fettle_owner_end(owner) == FETTLE_INVALID);
    DONE_C(fettle_owner_begin(owner));
    DONE_C(fettle_owner_acts(owner, &acts));
    DONE_C(fettle_owner_advice(owner, &advice));
    CHECK_C(acts && strcmp(advice, "ask the level instead") == 0);
    DONE_C(fettle_body_destroy(scene.world, scene.box));
    DONE_C(fettle_owner_end(owner));
    DONE_C(fettle_world_set_owner(scene.world, NULL));
    DONE_C(fettle_owner_destroy(owner));
    /* The pointer is stale now. */
    CHECK_C(fettle_owner_destroy(owner) == FETTLE_STALE);
    CHECK_C(fettle_owner_begin(owner) == FETTLE_STALE);
    CHECK_C(fettle_owner_end(owner) == FETTLE_STALE);
    CHECK_C(fettle_owner_acts(owner, &acts) == FETTLE_STALE);
    CHECK_C(fettle_owner_advice(owner, &advice) == FETTLE_STALE);
    CHECK_C(fettle_owner_on_unlocked(owner, NULL, NULL) == FETTLE_STALE);
    CHECK_C(fettle_world_set_owner(scene.world, owner) == FETTLE_STALE);
    CHECK_C(strstr(fettle_last_error(), "owner: it was destroyed") != NULL);
    DONE_C(fettle_world_destroy(scene.world));
    return NULL;
}

struct drawn {
    struct scene scene;
    int polygons, circles, segments, points;
    float highest;
};

static void draw_polygon(void* user, const fettle_position* points, uint32_t count, bool closed,
                         uint32_t color) {
    struct drawn* drawn = user;
    (void)closed, (void)color;
    ++drawn->polygons;
    for (uint32_t i = 0; i < count; ++i) drawn->highest = fmaxf(drawn->highest, (float)points[i].y);
    try_edits(&drawn->scene);
}

static void draw_circle(void* user, fettle_position center, float radius, float angle, uint32_t color) {
    (void)center, (void)radius, (void)angle, (void)color;
    ++((struct drawn*)user)->circles;
}

static void draw_segment(void* user, fettle_position from, fettle_position to, uint32_t color) {
    (void)from, (void)to, (void)color;
    ++((struct drawn*)user)->segments;
}

static void draw_point(void* user, fettle_position at, uint32_t color) {
    (void)at, (void)color;
    ++((struct drawn*)user)->points;
}

static const char* a_world_is_drawn_by_functions(void) {
    struct drawn drawn = {.scene = new_scene(), .highest = -9};
    fettle_world* world = drawn.scene.world;
    fettle_debug_draw draw;
    fettle_geometry circle;
    DONE_C(fettle_geometry_init(&circle, sizeof circle, FETTLE_SHAPE_CIRCLE));
    DONE_C(fettle_body_add(world, drawn.scene.box, &circle, NULL, NULL));
    DONE_C(fettle_debug_draw_init(&draw, sizeof draw));
    DONE_C(fettle_world_draw(world, &draw)); /* no functions: nothing happens */
    draw.user = &drawn;
    draw.polygon = draw_polygon;
    draw.circle = draw_circle;
    draw.segment = draw_segment;
    draw.point = draw_point;
    draw.centers = true;
    DONE_C(fettle_world_draw(world, &draw));
    CHECK_C(drawn.polygons == 2 && drawn.circles == 1 && drawn.points == 2);
    CHECK_C(fabsf(drawn.highest - 1) < 1e-4f && all_refused(&drawn.scene));
    DONE_C(fettle_shape_set_rounding(world, drawn.scene.box_shape, 0.2f));
    drawn.highest = -9;
    DONE_C(fettle_world_draw(world, &draw));
    CHECK_C(fabsf(drawn.highest - 1) < 1e-4f); /* the rounding is inside of the box */
    draw.fraction = NAN;
    CHECK_C(fettle_world_draw(world, &draw) == FETTLE_INVALID);
    CHECK_C(fettle_world_draw(world, NULL) == FETTLE_INVALID);
    DONE_C(fettle_world_destroy(world));
    return NULL;
}

static void rise(void* user, const fettle_world* world, fettle_velocity_edit* edit) {
    struct scene* scene = user;
    try_edits(scene);
    edit->velocity.y = edit->body == scene->box && world == scene->world ? 2 : -9;
}

static void stay(void* user, const fettle_world* world, fettle_position_edit* edit) {
    (void)world;
    try_edits(user);
    edit->pose.position.x = 3;
}

static const char* functions_move_a_body(void) {
    struct scene scene = new_scene();
    fettle_pose pose;
    fettle_vec2 velocity;
    DONE_C(fettle_body_set_velocity_function(scene.world, scene.box, rise, &scene));
    DONE_C(fettle_body_set_position_function(scene.world, scene.box, stay, &scene));
    for (int i = 0; i < 60; ++i) DONE_C(fettle_world_step(scene.world, 1.0f / 60));
    CHECK_C(all_refused(&scene) && scene.calls == 120);
    DONE_C(fettle_body_velocity(scene.world, scene.box, &velocity));
    CHECK_C(fabsf(velocity.y - 2) < 1e-4f);
    DONE_C(fettle_body_interpolated(scene.world, scene.box, 1, &pose));
    CHECK_C(pose.position.x == 3 && pose.position.y > 2);
    DONE_C(fettle_body_set_velocity_function(scene.world, scene.box, NULL, NULL));
    DONE_C(fettle_body_set_position_function(scene.world, scene.box, NULL, NULL));
    DONE_C(fettle_world_step(scene.world, 1.0f / 60));
    CHECK_C(scene.calls == 120);
    CHECK_C(fettle_body_set_velocity_function(scene.world, 0, rise, NULL) == FETTLE_STALE);
    CHECK_C(fettle_body_set_position_function(NULL, scene.box, stay, NULL) == FETTLE_INVALID);
    DONE_C(fettle_world_destroy(scene.world));
    return NULL;
}

static const char* segments_have_surfaces(void) {
    const fettle_vec2 points[] = {{-20, 0}, {0, 0}, {20, 0}};
    const fettle_segment_surface ice = {0, 0, 0, 0, 12};
    struct scene scene = new_scene();
    fettle_segment_surface told;
    fettle_geometry chain;
    fettle_id ground;
    uint32_t count;
    bool is_set;
    DONE_C(fettle_geometry_init(&chain, sizeof chain, FETTLE_SHAPE_CHAIN));
    chain.points = points;
    chain.point_count = 3;
    DONE_C(fettle_body_add(scene.world, scene.ground, &chain, NULL, &ground));
    DONE_C(fettle_shape_segment_count(scene.world, ground, &count));
    CHECK_C(count == 2);
    DONE_C(fettle_shape_set_segment_surface(scene.world, ground, 1, &ice));
    DONE_C(fettle_shape_segment_surface_override(scene.world, ground, 0, &is_set, &told));
    CHECK_C(!is_set);
    DONE_C(fettle_shape_segment_surface_override(scene.world, ground, 1, &is_set, &told));
    CHECK_C(is_set && told.friction == 0 && told.material == 12);
    DONE_C(fettle_shape_segment_surface(scene.world, ground, 0, &told));
    CHECK_C(told.friction > 0.5f);
    CHECK_C(fettle_shape_set_segment_surface(scene.world, ground, 2, &ice) == FETTLE_INVALID);
    CHECK_C(fettle_shape_set_segment_surfaces(scene.world, ground, &ice, 1) == FETTLE_INVALID);
    CHECK_C(fettle_shape_set_segment_surfaces(scene.world, ground, NULL, 2) == FETTLE_INVALID);
    CHECK_C(strstr(fettle_last_error(), "surfaces") != NULL);
    DONE_C(fettle_shape_set_segment_surface(scene.world, ground, 1, NULL));
    DONE_C(fettle_shape_segment_surface_override(scene.world, ground, 1, &is_set, &told));
    CHECK_C(!is_set);
    DONE_C(fettle_shape_set_segment_surfaces(scene.world, ground, NULL, 0));
    CHECK_C(fettle_shape_segment_count(scene.world, scene.box_shape, &count) == FETTLE_INVALID);
    DONE_C(fettle_world_destroy(scene.world));
    return NULL;
}

static void count_levels(void* user, int32_t level, const char* text) {
    int* counts = user;
    if (text[0] != 0) ++counts[level];
}

static void fail(void* user, const char* what) {
    (void)what;
    ++*(int*)user;
}

static void move_nowhere(void* user, const fettle_world* world, fettle_velocity_edit* edit) {
    (void)user, (void)world;
    edit->velocity.x = NAN;
}

static const char* a_log_tells_what_no_code_does(void) {
    struct scene scene = new_scene();
    int counts[3] = {0, 0, 0}, failures = 0;
    DONE_C(fettle_set_log(count_levels, counts));
    DONE_C(fettle_set_failure_function(fail, &failures));
    DONE_C(fettle_body_set_velocity_function(scene.world, scene.box, move_nowhere, NULL));
    DONE_C(fettle_world_step(scene.world, 1.0f / 60));
    CHECK_C(counts[FETTLE_LOG_WARNING] == 1 && failures == 0);
    DONE_C(fettle_set_log(NULL, NULL));
    DONE_C(fettle_set_failure_function(NULL, NULL));
    DONE_C(fettle_world_step(scene.world, 1.0f / 60));
    CHECK_C(counts[0] + counts[1] + counts[2] == 1);
    DONE_C(fettle_world_destroy(scene.world));
    return NULL;
}

struct recorded {
    struct scene scene;
    size_t size;
    unsigned char bytes[1 << 18];
};

static void append(void* user, const fettle_world* world, const void* bytes, size_t size) {
    struct recorded* recorded = user;
    (void)world;
    try_edits(&recorded->scene);
    if (recorded->size + size > sizeof recorded->bytes) return;
    memcpy(recorded->bytes + recorded->size, bytes, size);
    recorded->size += size;
}

static const char* a_recording_is_repeated(void) {
    static struct recorded recorded;
    fettle_replay* replay = NULL;
    fettle_replayed_step step;
    fettle_world* copy = NULL;
    uint64_t hash, repeated_hash, steps;
    bool repeated, is_recorded, is_cut_off;
    int count = 0, edits = 0;
    memset(&recorded, 0, sizeof recorded);
    recorded.scene = new_scene();
    fettle_world* const world = recorded.scene.world;
    CHECK_C(fettle_world_start_recording(world, NULL, NULL) == FETTLE_INVALID);
    DONE_C(fettle_world_start_recording(world, append, &recorded));
    CHECK_C(fettle_world_start_recording(world, append, &recorded) == FETTLE_INVALID);
    DONE_C(fettle_world_is_recorded(world, &is_recorded));
    CHECK_C(is_recorded);
    for (int i = 0; i < 20; ++i) {
        if (i % 5 == 0) DONE_C(fettle_body_set_velocity(world, recorded.scene.box, 1, 3));
        DONE_C(fettle_world_step(world, 1.0f / 60));
    }
    DONE_C(fettle_world_stop_recording(world));
    CHECK_C(all_refused(&recorded.scene) && recorded.scene.calls == 41);
    DONE_C(fettle_world_hash(world, &hash));
    DONE_C(fettle_replay_create(recorded.bytes, recorded.size, &replay));
    DONE_C(fettle_replay_steps(replay, &steps));
    CHECK_C(steps == 20);
    DONE_C(fettle_replay_is_cut_off(replay, &is_cut_off));
    CHECK_C(!is_cut_off);
    for (;;) {
        DONE_C(fettle_replay_step(replay, &step, &repeated));
        if (!repeated) break;
        CHECK_C(step.same && step.has_recorded_hash && step.number == (uint64_t)count++);
        edits += strstr(step.calls, "Body::set_velocity") != NULL;
    }
    CHECK_C(count == 20 && edits == 4);
    DONE_C(fettle_replay_world(replay, &copy));
    DONE_C(fettle_replay_destroy(replay));
    DONE_C(fettle_world_hash(copy, &repeated_hash));
    CHECK_C(repeated_hash == hash);
    DONE_C(fettle_replay_create(recorded.bytes, recorded.size - 1, &replay));
    DONE_C(fettle_replay_is_cut_off(replay, &is_cut_off));
    CHECK_C(is_cut_off);
    DONE_C(fettle_replay_destroy(replay));
    /* The pointer is stale now. */
    CHECK_C(fettle_replay_destroy(replay) == FETTLE_STALE);
    CHECK_C(fettle_replay_steps(replay, &steps) == FETTLE_STALE);
    CHECK_C(fettle_replay_is_cut_off(replay, &is_cut_off) == FETTLE_STALE);
    CHECK_C(fettle_replay_step(replay, &step, &repeated) == FETTLE_STALE);
    CHECK_C(fettle_replay_world(replay, &copy) == FETTLE_STALE);
    CHECK_C(strstr(fettle_last_error(), "replay: it was destroyed") != NULL);
    recorded.bytes[recorded.size - 9] ^= 1;
    CHECK_C(fettle_replay_create(recorded.bytes, recorded.size, &replay) == FETTLE_INVALID);
    CHECK_C(strstr(fettle_last_error(), "checksum") != NULL);
    CHECK_C(fettle_replay_create(NULL, 0, &replay) == FETTLE_INVALID);
    CHECK_C(fettle_replay_step(NULL, &step, &repeated) == FETTLE_INVALID);
    DONE_C(fettle_replay_destroy(NULL));
    DONE_C(fettle_world_destroy(copy));
    DONE_C(fettle_world_destroy(world));
    return NULL;
}

const struct named_c_test callbacks_in_c[] = {
    {"functions move a body", functions_move_a_body},
    {"a log tells what no code does", a_log_tells_what_no_code_does},
    {"segments have surfaces", segments_have_surfaces},
    {"a recording is repeated", a_recording_is_repeated},
    {"a filter lets a box fall through", a_filter_lets_a_box_fall_through},
    {"contacts are mixed and switched off", contacts_are_mixed_and_switched_off},
    {"a read tells that it updates", a_read_tells_that_it_updates},
    {"queries find and visit", queries_find_and_visit},
    {"an owner alone creates and destroys", an_owner_alone_creates_and_destroys},
    {"a world is drawn by functions", a_world_is_drawn_by_functions},
    {NULL, NULL}};
