#pragma once

#include <fettle_physics.h>
#include <string.h>

/* Worlds with a few bodies, for tests in C. */

static inline fettle_world* new_world(void) {
    fettle_world* world = NULL;
    return fettle_world_create(NULL, &world) == FETTLE_DONE ? world : NULL;
}

static inline fettle_id new_body(fettle_world* world, int32_t type, float x, float y) {
    fettle_body_def def;
    fettle_id body = 0;
    fettle_body_def_init(&def, sizeof def);
    def.type = type;
    def.position = (fettle_position){x, y};
    fettle_world_create_body(world, &def, &body);
    return body;
}

static inline fettle_id add(fettle_world* world, fettle_id body, int32_t type) {
    fettle_geometry geometry;
    fettle_id shape = 0;
    fettle_geometry_init(&geometry, sizeof geometry, type);
    fettle_body_add(world, body, &geometry, NULL, &shape);
    return shape;
}

static inline int message_has(const char* text) {
    return strstr(fettle_last_error(), text) != NULL;
}

static inline void run(fettle_world* world, int steps) {
    for (int i = 0; i < steps; ++i) fettle_world_step(world, 1.0f / 60);
}
