/* Functions of the host that the library calls for all worlds of the process.
 *
 * Memory has no hook: the library takes it from the C++ library, which takes it from malloc. A
 * program that is linked with another malloc replaces it for the library, too. */

#pragma once

#include <fettle/physics_c/basics.h>

FETTLE_PHYSICS_C_BEGIN

/** How much a line of the log matters. */
enum fettle_log_level {
    FETTLE_LOG_NOTE = 0,    /* done in another way than was asked for, with the same results */
    FETTLE_LOG_WARNING = 1, /* an argument of no meaning was ignored */
    FETTLE_LOG_ERROR = 2    /* something was lost */
};

/** `level`: one of fettle_log_level; `text`: one line, which lives for the call. Several threads
   may call it at once. It must not edit the world and must not jump out. */
typedef void (*fettle_log_function)(void* user, int32_t level, const char* text);

/** Sets the log of the process: the function gets problems that no result code reports. A null
    function: none, as at first. */
fettle_code fettle_set_log(fettle_log_function function, void* user);

/** `what`: the first fault of a world, as of fettle_world_validate; it lives for the call. */
typedef void (*fettle_failure_function)(void* user, const char* what);

/** While there is such a function, each world is checked after each step, which takes several times
    as long as the step, and the function gets the first fault. A null function: none, as at first.
 */
fettle_code fettle_set_failure_function(fettle_failure_function function, void* user);

FETTLE_PHYSICS_C_END
