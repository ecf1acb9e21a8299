/* Saved games in slots: files in the folder `saves` of the definition. Scripts use the same slots
 * (`save_game`, `load_game`). A state in memory is in past.h. Without such a folder these functions
 * give FETTLE_INVALID. A slot has a name of 1 to 64 letters, digits, spaces, - or _, without a
 * space at its beginning or end. */

#pragma once

#include <fettle/host/basics.h>

FETTLE_HOST_BEGIN

/** A saved game. */
typedef struct fettle_hosted_saved {
    const char* slot;    /* its name */
    const char* problem; /* why this game cannot load it; "" if it can */
    int64_t step;        /* of the game that was saved */
    int64_t time;        /* of the day, s since 1970 */
} fettle_hosted_saved;

/** Saves the game now: the file is written and read back before it replaces an older one. After an
    error, the older one is as it was. The folder is created if there is none. Not in a callback. */
fettle_code fettle_hosted_save(fettle_hosted* game, const char* slot);

/** Goes to the state of a saved game, as fettle_hosted_restore does. FETTLE_INVALID, and nothing
    changes, if there is no such slot, or if the file is damaged or is one of another game. Not in a
    callback. */
fettle_code fettle_hosted_load_save(fettle_hosted* game, const char* slot);

/** Removes the file. FETTLE_INVALID if there is no such slot. */
fettle_code fettle_hosted_delete_save(fettle_hosted* game, const char* slot);

/** All saved games, by name: writes the first `room` of them, and how many there are. `out` may be
    null if `room` is 0. Not in a callback. */
fettle_code fettle_hosted_saves(fettle_hosted* game, fettle_hosted_saved* out, uint32_t room,
                                uint32_t* count);

FETTLE_HOST_END
