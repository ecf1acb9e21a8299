/* What all functions of a hosted game have in common.
 *
 * Results. As in fettle_physics.h: a function returns FETTLE_DONE, or another code after an error;
 * then fettle_last_error() has the reason, and no out parameter was written. A pointer must not be
 * null unless the function says that it may be. Texts end with a zero, and may have any bytes in
 * front of it.
 *
 * Scripts. A function that runs scripts (`fettle_hosted_frame`, `_step`, `_load`, `_run`, `_call`,
 * `_barrier`) returns FETTLE_FAILED after an error of a script, and fettle_last_error() has the
 * first message, as users of Lua see it: "main.lua:12: world.bal: no such name". What could be done
 * is done nevertheless; the next call goes on.
 *
 * Texts, lists and arrays that a function gives belong to the game, and are valid until the next
 * call that gives any; those that a callback gets are valid until it returns.
 *
 * Callbacks. `user` is the pointer that was given with the function. A callback may use the game,
 * but functions that say "not in a callback" give FETTLE_LOCKED there. It must return: it must not
 * jump out past the library. An exception of a C++ callback is caught and becomes an error of the
 * script or the handler.
 *
 * Threads. One thread uses all games of a process: the one that created the first of them, until
 * all are destroyed. In other threads functions give FETTLE_LOCKED. While scripts run, the library
 * uses the signal SIGURG and a thread of its own, unless `call_seconds` is 0.
 *
 * Foreign function interfaces. The headers in the order of fettle_host.h, after those of
 * fettle_physics.h, without comments, lines that begin with `#` and the words FETTLE_HOST_BEGIN and
 * FETTLE_HOST_END, are what cffi and LuaJIT read. */

#pragma once

#include <fettle/host/export.h>
#include <fettle/physics_c/basics.h>

FETTLE_HOST_BEGIN

/** A hosted game. A pointer to a destroyed one is refused, as long as no more than a thousand games
    have been destroyed since. */
typedef struct fettle_hosted fettle_hosted;

/** Names an instance of the tree; 0 names none. One of a deleted instance is refused. Each game
    counts for itself: the same number may name an instance in another game, too. */
typedef uint64_t fettle_instance;

/** Version of the library, as in "0.1.0". */
const char* fettle_host_version(void);

FETTLE_HOST_END
