/* Rigid bodies from plain C: physics as a module that plugs into a game without a window.
 *
 *   bare_c <prefix>/lib/fettle/modules/physics.so
 */

#include <stdio.h>
#include <stdlib.h>

#include <fettle/module/host.h>

static fettle_game* game;
static const fettle_host* host;

static void require(fettle_status status) {
    if (status == FETTLE_OK) return;
    fprintf(stderr, "bare_c: %s\n", host->last_error(host->self));
    exit(1);
}

static fettle_handle make(const char* class_name, fettle_handle parent, const char* name) {
    fettle_handle made;
    require(host->create(host->self, class_name, parent, name, &made));
    return made;
}

static void set(fettle_handle instance, const char* property, fettle_value value) {
    require(host->set(host->self, instance, property, &value));
}

static fettle_value number(double x) {
    return (fettle_value){FETTLE_NUMBER, 0, {.number = x}};
}

static fettle_value vec2(double x, double y) {
    return (fettle_value){FETTLE_VEC2, 0, {.vec2 = {x, y}}};
}

static fettle_value text(const char* t, uint32_t length) {
    return (fettle_value){FETTLE_TEXT, length, {.text = t}};
}

int main(int argc, char** argv) {
    fettle_handle world, ground, box, ball;
    fettle_value position;

    game = fettle_game_open();
    host = fettle_game_host(game);
    require(fettle_game_load(game, argc > 1 ? argv[1] : "physics.so"));
    require(host->find(host->self, "world", &world));

    ground = make("Body", world, "ground");
    set(ground, "type", text("static", 6));
    box = make("Box", ground, NULL);
    set(box, "width", number(40));

    ball = make("Body", world, "ball");
    set(make("Circle", ball, NULL), "restitution", number(0.8));
    set(ball, "position", vec2(0, 8));

    for (int i = 0; i < 60; ++i) {
        require(fettle_game_step(game, 1.0 / 60));
        if (i % 15 != 14) continue;
        require(host->get(host->self, ball, "position", &position));
        printf("%.2f s: %.3f m\n", (i + 1) / 60.0, position.as.vec2[1]);
    }
    position.type = FETTLE_NUMBER;
    if (host->set(host->self, ball, "colour", &position) != FETTLE_OK)
        printf("%s\n", host->last_error(host->self));
    fettle_game_close(game);
    return 0;
}
