#include <fettle_physics.h>

#include "in_c.h"

/* Points of the world, which have double precision with FETTLE_PHYSICS_DOUBLE. */

/* 10 000 km from the origin, where floats are a meter apart. */
static const char* a_point_of_the_world_has_its_precision(void) {
    const bool precise = sizeof(fettle_coordinate) == sizeof(double);
    const fettle_coordinate far = precise ? 1e7f : 1000, at = far + (fettle_coordinate)0.25;
    fettle_world* world = NULL;
    fettle_body_def def;
    fettle_geometry geometry;
    fettle_id ground, ball;
    fettle_position place;
    fettle_columns columns;
    fettle_ray_hit hit;
    bool found = false;
    DONE_C(fettle_world_create(NULL, &world));
    DONE_C(fettle_body_def_init(&def, sizeof def));
    def.type = FETTLE_BODY_STATIC;
    def.position.x = far;
    def.position.y = (fettle_coordinate)-0.5;
    DONE_C(fettle_world_create_body(world, &def, &ground));
    def.type = FETTLE_BODY_DYNAMIC;
    def.position.y = 1;
    DONE_C(fettle_world_create_body(world, &def, &ball));
    DONE_C(fettle_geometry_init(&geometry, sizeof geometry, FETTLE_SHAPE_BOX));
    DONE_C(fettle_body_add(world, ground, &geometry, NULL, NULL));
    DONE_C(fettle_geometry_init(&geometry, sizeof geometry, FETTLE_SHAPE_CIRCLE));
    DONE_C(fettle_body_add(world, ball, &geometry, NULL, NULL));
    DONE_C(fettle_body_set_position(world, ball, at, 1));
    for (int i = 0; i < 60; ++i) DONE_C(fettle_world_step(world, 1.0f / 60));
    DONE_C(fettle_body_position(world, ball, &place));
    CHECK_C(place.x - at < 0.001 && at - place.x < 0.001 && place.y > 0.49 && place.y < 0.51);
    DONE_C(fettle_world_columns(world, &columns));
    CHECK_C(columns.states[fettle_slot(ball)].position.x == place.x);
    DONE_C(fettle_world_cast_ray(world, at, 9, at, 0, NULL, &found, &hit));
    CHECK_C(found && hit.point.x - at < 0.001 && at - hit.point.x < 0.001 && hit.point.y > 0.99);
    DONE_C(fettle_world_destroy(world));
    return NULL;
}

const struct named_c_test positions_in_c[] = {
    {"a point of the world has its precision", a_point_of_the_world_has_its_precision},
    {NULL, NULL}};
