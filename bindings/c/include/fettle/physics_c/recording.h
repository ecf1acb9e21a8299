/* Recording what happens to a world, for a bug report, and repeating it. */

#pragma once

#include <fettle/physics_c/basics.h>

FETTLE_PHYSICS_C_BEGIN

/** Gets the next part of a recording, to be appended to a file or to memory. The bytes are valid
   for the call. Flush a file after each part: what is cut off cannot be replayed. A function that
   could not keep a part should keep none after it: a recording with a gap is refused as damaged. */
typedef void (*fettle_recording_sink)(void* user, const fettle_world* world, const void* bytes,
                                      size_t size);

/** Records the world: `function` gets its state now, and in every step what was edited since the
    last one, the answers of callbacks, and the hash. A recorded step takes as long as saving the
    world twice. FETTLE_INVALID if the world is recorded already. */
fettle_code fettle_world_start_recording(fettle_world* world, fettle_recording_sink function,
                                         void* user);

/** Ends the recording; does nothing if there is none. */
fettle_code fettle_world_stop_recording(fettle_world* world);

/** Whether the world is recorded. */
fettle_code fettle_world_is_recorded(const fettle_world* world, bool* is_recorded);

/** Repeats a recording. */
typedef struct fettle_replay fettle_replay;

/** A step that was repeated. */
typedef struct fettle_replayed_step {
    uint64_t number;        /* from 0 */
    float dt;               /* s */
    bool same;              /* false: the hashes differ, or a callback was to be called for another
                               contact; the replay ends then */
    bool has_recorded_hash; /* false: the recording ends within this step */
    uint64_t recorded_hash; /* after the step when it was recorded */
    uint64_t hash;          /* after the repeated step */
    const char* calls;      /* the methods of C++ that edited the world before it: as in
                               "Body::set_velocity 12, World::create_body"; valid until the next step
                               of the replay, or until it is destroyed */
} fettle_replayed_step;

/** A replay of a recording, which is copied. FETTLE_INVALID if the bytes are not a recording, were
    made by another version of the library, are damaged, or end within the first part. */
fettle_code fettle_replay_create(const void* bytes, size_t size, fettle_replay** replay);

/** A null pointer is ignored. The pointer is refused afterwards, as that of a world is. */
fettle_code fettle_replay_destroy(fettle_replay* replay);

/** Number of steps in the recording. */
fettle_code fettle_replay_steps(const fettle_replay* replay, uint64_t* steps);

/** Whether the recording ends within a part that was given to the function. The parts before it are
    replayed. */
fettle_code fettle_replay_is_cut_off(const fettle_replay* replay, bool* is_cut_off);

/** Repeats the next step. `repeated` is false, and `step` all zeros, at the end and after a step
   that was not the same. FETTLE_INVALID if damage that the checksums do not notice made the edits
   before the step impossible. */
fettle_code fettle_replay_step(fettle_replay* replay, fettle_replayed_step* step, bool* repeated);

/** A copy of the world after the last repeated step. */
fettle_code fettle_replay_world(const fettle_replay* replay, fettle_world** world);

FETTLE_PHYSICS_C_END
