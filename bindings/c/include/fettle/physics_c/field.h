/* Fields of force: wind, drag, liquids, attractors. A field acts only on awake bodies; setting one
 * wakes all. Errors are those of basics.h. */

#pragma once

#include <fettle/physics_c/definitions.h>

FETTLE_PHYSICS_C_BEGIN

/** Whether the id is that of a live field of this world; false for null and for any other value. */
bool fettle_field_is_valid(const fettle_world* world, fettle_id field);

/** Destroys the field. */
fettle_code fettle_field_destroy(fettle_world* world, fettle_id field);

/** All settings; def->size must be set (fettle_field_def_init). Members that its type does not use
    have the defaults of the type. */
fettle_code fettle_field_definition(const fettle_world* world, fettle_id field,
                                    fettle_field_def* def);

/** All settings at once, also of another type. Refuses what definitions.h does. */
fettle_code fettle_field_set(fettle_world* world, fettle_id field, const fettle_field_def* def);

FETTLE_PHYSICS_C_END
