/* A hosted game as a program in C11 uses it. */

/* Both interfaces can be included together. */
#include <fettle_physics.h>

#include "game.h"

#include <string.h>

static void count_change(void* user, const fettle_hosted_change* change) {
    (void)change;
    ++*(int*)user;
}

int32_t run_a_game_in_c(double* height, int* changes) {
    fettle_hosted* game = NULL;
    fettle_property_id y = 0;
    fettle_hosted_def def;
    int32_t code = fettle_hosted_def_init(&def, sizeof def);
    *changes = 0;
    if (code == FETTLE_DONE) code = fettle_hosted_create(&def, &game);
    if (code == FETTLE_DONE)
        code = fettle_hosted_run(
            game, "world.ball = Body { Circle {}, position = vec(0, 5), gravity_scale = 1 }",
            "start");
    if (code == FETTLE_DONE) code = fettle_property_at(game, "world.ball.position.y", &y);
    if (code == FETTLE_DONE)
        code = fettle_hosted_watch(game, "world.ball.gravity_scale", count_change, changes, NULL);
    for (int i = 0; code == FETTLE_DONE && i < 30; ++i)
        code = fettle_hosted_frame(game, 1.0 / 60, NULL);
    if (code == FETTLE_DONE) {
        fettle_hosted_value half;
        memset(&half, 0, sizeof half);
        half.type = FETTLE_VALUE_NUMBER;
        half.as.number = 0.5;
        code = fettle_hosted_set(game, "world.ball.gravity_scale", &half);
    }
    for (int i = 0; code == FETTLE_DONE && i < 30; ++i) code = fettle_hosted_step(game);
    if (code == FETTLE_DONE) code = fettle_property_get_number(game, y, height);
    if (code == FETTLE_DONE) code = fettle_hosted_destroy(game);
    return code;
}
