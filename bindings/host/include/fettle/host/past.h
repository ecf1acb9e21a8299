/* Snapshots, and going back in time. The past of the last minute is kept, unless
 * `time.rewind_limit` says otherwise. After these functions, the watchers of what is different are
 * called at the next barrier. None of them may be called in a callback. */

#pragma once

#include <fettle/host/basics.h>

FETTLE_HOST_BEGIN

/** The whole state of the tree and of physics as bytes with a version and a checksum. Variables of
   Lua and timers are not in it. The bytes are valid until the next snapshot of the game. */
fettle_code fettle_hosted_snapshot(fettle_hosted* game, const void** bytes, size_t* size);

/** FETTLE_INVALID, and nothing changes, if a byte was changed, removed or added, or if it has
    classes that this game does not have. Parts that do not fit (a property that has another type
   now) are reported to the function for problems (game.h). */
fettle_code fettle_hosted_restore(fettle_hosted* game, const void* bytes, size_t size);

/** Goes back by this simulation time from now, at most to the oldest step that is kept. A negative
    time goes forward again, at most to the newest one. */
fettle_code fettle_hosted_rewind(fettle_hosted* game, double seconds);

/** Goes to a step that is kept. Later ones are kept until a step is made from there. */
fettle_code fettle_hosted_go_to(fettle_hosted* game, int64_t step);

/** The current step, and the first and the last one that fettle_hosted_go_to takes; both are the
    current one if none is kept. Each may be null. */
fettle_code fettle_hosted_steps(fettle_hosted* game, int64_t* step, int64_t* oldest,
                                int64_t* newest);

FETTLE_HOST_END
