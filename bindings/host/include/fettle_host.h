/* A whole game of Fettle inside another program, in C11: the property tree with physics, Lua, the
 * past, and the console as triangles. fettle/host/basics.h describes what all functions have in
 * common.
 *
 *   fettle_hosted* game;
 *   fettle_property_id height;
 *   double y;
 *   fettle_hosted_create(NULL, &game);
 *   fettle_hosted_run(game, "world.ball = Body { Circle {}, position = vec(0, 5) }", "start");
 *   fettle_property_at(game, "world.ball.position.y", &height);
 *   for (int i = 0; i < 60; ++i) fettle_hosted_frame(game, 1.0 / 60, NULL);
 *   fettle_property_get_number(game, height, &y);
 *   fettle_hosted_destroy(game);
 */

#pragma once

/* In the order of the declarations. */
/* clang-format off */
#include <fettle/host/basics.h>
#include <fettle/host/value.h>
#include <fettle/host/game.h>
#include <fettle/host/class.h>
#include <fettle/host/instance.h>
#include <fettle/host/property.h>
#include <fettle/host/watch.h>
#include <fettle/host/past.h>
#include <fettle/host/saves.h>
#include <fettle/host/input.h>
#include <fettle/host/console.h>
/* clang-format on */
