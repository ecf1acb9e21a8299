/* For libraries on top of this one, which share its fettle_last_error. */

#pragma once

#include <fettle/physics_c/export.h>

FETTLE_PHYSICS_C_BEGIN

/** From now on fettle_last_error of this thread gives "FUNCTION: MESSAGE", cut at 1023 bytes. Null
    counts as an empty text. */
void fettle_keep_error(const char* function, const char* message);

FETTLE_PHYSICS_C_END
