/* Fettle's rigid bodies in C11. fettle/physics_c/basics.h describes what all functions have in
 * common.
 *
 *   fettle_world* world;
 *   fettle_id ball;
 *   fettle_geometry circle;
 *   fettle_world_create(NULL, &world);
 *   fettle_world_create_body(world, NULL, &ball);
 *   fettle_geometry_init(&circle, sizeof circle, FETTLE_SHAPE_CIRCLE);
 *   fettle_body_add(world, ball, &circle, NULL, NULL);
 *   for (int i = 0; i < 60; ++i) fettle_world_step(world, 1.0f / 60);
 *   fettle_world_destroy(world);
 */

#pragma once

/* In the order of the declarations. */
/* clang-format off */
#include <fettle/physics_c/position.h>
#include <fettle/physics_c/basics.h>
#include <fettle/physics_c/definitions.h>
#include <fettle/physics_c/joint_definitions.h>
#include <fettle/physics_c/contact.h>
#include <fettle/physics_c/world.h>
#include <fettle/physics_c/world_settings.h>
#include <fettle/physics_c/body.h>
#include <fettle/physics_c/shape.h>
#include <fettle/physics_c/joint.h>
#include <fettle/physics_c/holding_joints.h>
#include <fettle/physics_c/sliding_joints.h>
#include <fettle/physics_c/coupling_joints.h>
#include <fettle/physics_c/field.h>
#include <fettle/physics_c/events.h>
#include <fettle/physics_c/account.h>
#include <fettle/physics_c/callbacks.h>
#include <fettle/physics_c/query.h>
#include <fettle/physics_c/geometry.h>
#include <fettle/physics_c/mover.h>
#include <fettle/physics_c/columns.h>
#include <fettle/physics_c/drawing.h>
#include <fettle/physics_c/recording.h>
#include <fettle/physics_c/hooks.h>
/* clang-format on */
