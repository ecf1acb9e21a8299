#include <fettle_physics.h>
#include <math.h>

#include "in_c.h"
#include "small_world.h"

/* Readings for tools and engines: accounts of velocities, planes of a mover, colors of a drawing.
 */

static const char* an_account_tells_what_changed_a_velocity(void) {
    fettle_world* world = new_world();
    const fettle_id ground = new_body(world, FETTLE_BODY_STATIC, 0, -0.5f);
    const fettle_id crate = new_body(world, FETTLE_BODY_DYNAMIC, 0, 0.5f);
    const fettle_id hung = new_body(world, FETTLE_BODY_DYNAMIC, 5, 5);
    const fettle_id floor = add(world, ground, FETTLE_SHAPE_BOX);
    const fettle_id box = add(world, crate, FETTLE_SHAPE_BOX);
    fettle_revolute_joint_def pin;
    fettle_velocity_account account;
    fettle_contact_share touch;
    fettle_joint_share hold;
    fettle_id joint;
    uint32_t count;
    bool is_set;
    add(world, hung, FETTLE_SHAPE_BOX);
    DONE_C(fettle_revolute_joint_def_init(&pin, sizeof pin));
    pin.body_b = hung;
    pin.anchor_a = (fettle_position){5, 5};
    DONE_C(fettle_world_create_revolute_joint(world, &pin, &joint));
    DONE_C(fettle_world_account(world, crate, &is_set, &account));
    CHECK_C(!is_set && account.gravity.y == 0);
    DONE_C(fettle_world_account_contacts(world, crate, &touch, 1, &count));
    CHECK_C(count == 0);
    DONE_C(fettle_world_keep_account(world, crate));
    DONE_C(fettle_world_keep_account(world, hung));
    DONE_C(fettle_body_apply_force(world, crate, 3, 0));
    run(world, 1);
    DONE_C(fettle_world_account(world, crate, &is_set, &account));
    CHECK_C(is_set && fabsf(account.gravity.y + 10.0f / 60) < 1e-5f);
    CHECK_C(fabsf(account.applied.x - 3.0f / 60) < 1e-5f);
    DONE_C(fettle_world_account_contacts(world, crate, &touch, 1, &count));
    CHECK_C(count == 1 && touch.own == box && touch.other == floor && touch.body == ground);
    CHECK_C(touch.change.y > 0 && touch.impulse.y > 0);
    /* All parts together are the change. */
    CHECK_C(fabsf(account.before.x + account.applied.x + touch.change.x + account.rest.x -
                  account.after.x) < 1e-6f);
    DONE_C(fettle_world_account_joints(world, hung, &hold, 1, &count));
    CHECK_C(count == 1 && hold.joint == joint && fabsf(hold.change.y - 10.0f / 60) < 1e-3f);
    CHECK_C(fettle_world_keep_account(world, joint) == FETTLE_INVALID);
    DONE_C(fettle_body_destroy(world, crate));
    CHECK_C(fettle_world_account(world, crate, &is_set, &account) == FETTLE_STALE);
    CHECK_C(fettle_world_account(world, hung, NULL, &account) == FETTLE_INVALID);
    DONE_C(fettle_world_destroy(world));
    return NULL;
}

static const char* planes_bound_a_motion(void) {
    const fettle_mover_plane planes[] = {{{0, 1}, {0, 0}, 0.5f, 0}, {{-1, 0}, {2, 0}, 1, 0}};
    fettle_mover_plane crooked = planes[0];
    fettle_vec2 result;
    DONE_C(fettle_solve_planes(3, -2, planes, 2, 0.1f, &result));
    CHECK_C(fabsf(result.x - 0.9f) < 1e-6f && fabsf(result.y + 0.4f) < 1e-6f);
    DONE_C(fettle_clip_velocity(3, -2, planes, 1, &result));
    CHECK_C(result.x == 3 && result.y == 0);
    DONE_C(fettle_clip_velocity(3, -2, NULL, 0, &result));
    CHECK_C(result.x == 3 && result.y == -2);
    crooked.normal.x = NAN;
    CHECK_C(fettle_solve_planes(3, -2, &crooked, 1, 0, &result) == FETTLE_INVALID);
    CHECK_C(message_has("planes[0]: expected a normal of length 1"));
    CHECK_C(fettle_clip_velocity(NAN, 0, planes, 2, &result) == FETTLE_INVALID);
    CHECK_C(fettle_clip_velocity(1, 0, NULL, 2, &result) == FETTLE_INVALID);
    return NULL;
}

struct painted {
    fettle_id body, shape;
    uint32_t color;
};

static uint32_t paint(void* user, const fettle_world* world, fettle_id body, fettle_id shape) {
    struct painted* all = user;
    return fettle_body_is_valid(world, body) && shape == all->shape && body == all->body ? 0x123456
                                                                                         : 0;
}

static void keep_color(void* user, fettle_position center, float radius, float angle,
                       uint32_t color) {
    (void)center, (void)radius, (void)angle;
    ((struct painted*)user)->color = color;
}

static const char* a_host_colors_what_is_drawn(void) {
    fettle_world* world = new_world();
    struct painted all = {new_body(world, FETTLE_BODY_DYNAMIC, 0, 0), 0, 0};
    fettle_debug_draw draw;
    all.shape = add(world, all.body, FETTLE_SHAPE_CIRCLE);
    DONE_C(fettle_debug_draw_init(&draw, sizeof draw));
    draw.user = &all;
    draw.circle = keep_color;
    DONE_C(fettle_world_draw(world, &draw));
    CHECK_C(all.color != 0 && all.color != 0x123456);
    draw.color_of = paint;
    DONE_C(fettle_world_draw(world, &draw));
    CHECK_C(all.color == 0x123456);
    DONE_C(fettle_world_destroy(world));
    return NULL;
}

const struct named_c_test accounts_in_c[] = {
    {"an account tells what changed a velocity", an_account_tells_what_changed_a_velocity},
    {"planes bound a motion", planes_bound_a_motion},
    {"a host colors what is drawn", a_host_colors_what_is_drawn},
    {NULL, NULL}};
