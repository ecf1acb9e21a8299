/* Games: their life, their scripts, their frames. */

#pragma once

#include <fettle/host/value.h>

FETTLE_HOST_BEGIN

/** A game. fettle_hosted_def_init writes the defaults. */
typedef struct fettle_hosted_def {
    uint32_t size;
    bool console;        /* true: there is a console (console.h) */
    uint64_t seed;       /* 0; of the random numbers of scripts */
    uint64_t lua_memory; /* 512 MiB, in bytes; 16 MiB to 64 TiB: what Lua may use */
    double call_seconds; /* 10; a call into scripts that takes longer is stopped; 0: no limit */
    const char* assets;  /* null; folder for files that the folder of the game does not have */
    const char* history_file; /* null: commands are not kept; file for the commands of all runs */
    const char* name;  /* null: "game"; stored in saved games; those of another name are refused */
    const char* saves; /* null: it cannot be saved in slots; folder for them (saves.h) */
    const char* store_file; /* null: scripts have no `store`; file of what outlives a run */
    /* Null: edits are not kept. Otherwise the path of a game, as for fettle_hosted_load: edits in
       the console are written to a journal beside it, `keep("world.ball.*")` writes them into its
       files, and games that are created later begin with them. */
    const char* tweaks_of;
} fettle_hosted_def;

/** Writes the defaults and `size`. FETTLE_INVALID unless `size` is the size of the structure. */
fettle_code fettle_hosted_def_init(fettle_hosted_def* def, size_t size);

/** A new game with an empty world (`world`) and with `time`, `view`, `input` and `audio`, which
    makes no sound by itself. A null def stands for the defaults. */
fettle_code fettle_hosted_create(const fettle_hosted_def* def, fettle_hosted** game);

/** Writes what its store has not written yet, and destroys the game. Null is allowed and does
    nothing. Not in a callback. */
fettle_code fettle_hosted_destroy(fettle_hosted* game);

/** Gets the lines that scripts print. Null: no function gets them. */
typedef void (*fettle_print_callback)(void* user, const char* line);
fettle_code fettle_hosted_on_print(fettle_hosted* game, fettle_print_callback print, void* user);

/** An error of a script, or of a handler or a formula of the tree. Texts are "" when unknown. */
typedef struct fettle_hosted_problem {
    const char* message;     /* "main.lua:12: world.bal: no such name (did you mean \"ball\"?)" */
    const char* file;        /* "main.lua" */
    const char* source_line; /* its text */
    const char* traceback;   /* one line for each frame */
    const char* context;     /* "update", "timer", "watcher of world.ball.mass" */
    int32_t line;            /* from 1; 0 when unknown */
} fettle_hosted_problem;

/** Gets all errors when they happen, also errors of files when a script saves or when the store is
 * written; the game goes on after those. Null: no function gets them. */
typedef void (*fettle_problem_callback)(void* user, const fettle_hosted_problem* problem);
fettle_code fettle_hosted_on_problem(fettle_hosted* game, fettle_problem_callback problem,
                                     void* user);

/** Runs main.lua of a folder, or one .lua file, as `fettle run` does. Not in a callback. */
fettle_code fettle_hosted_load(fettle_hosted* game, const char* path);

/** Runs the top level of the loaded game again, because its files have changed: the tree stays, and
    only what differs is applied. After an error everything is as it was. Not in a callback. */
fettle_code fettle_hosted_reload(fettle_hosted* game);

/** Runs a text in Lua as part of the game. `name` is in its errors; null: "host". */
fettle_code fettle_hosted_run(fettle_hosted* game, const char* lua, const char* name);

/** Calls a global function of the game, if there is one of that name. `arguments` may be null if
    `count` is 0. */
fettle_code fettle_hosted_call(fettle_hosted* game, const char* function,
                               const fettle_hosted_value* arguments, uint32_t count);

/** Runs a command as if it was typed into the console: an expression gives its value, an assignment
    can be undone. `result` may be null. `output` may be null; otherwise it gets the lines that the
    console shows. FETTLE_FAILED after an error; what the command changed before it stays. */
fettle_code fettle_hosted_evaluate(fettle_hosted* game, const char* command,
                                   fettle_hosted_value* result, const char** output);

/** A function that scripts can call as the global `name`; it replaces any global of that name.
    It gives its result (nil, unless it writes it), or returns another code than FETTLE_DONE with
    the reason in `result`, a text; then the call is an error of the script. */
typedef fettle_code (*fettle_function_callback)(void* user, const fettle_hosted_value* arguments,
                                                uint32_t count, fettle_hosted_value* result);
fettle_code fettle_hosted_add_function(fettle_hosted* game, const char* name,
                                       fettle_function_callback function, void* user);

/** One frame, `seconds` (0 to 3600) of real time after the last one: input and `update(dt)` of the
    game, then the fixed steps that are due, at most `time.max_steps`. `steps` may be null;
   otherwise it gets their number, also after an error of a script. Not in a callback. */
fettle_code fettle_hosted_frame(fettle_hosted* game, double seconds, uint32_t* steps);

/** One frame with one fixed step, whatever time has passed. Not in a callback. */
fettle_code fettle_hosted_step(fettle_hosted* game);

/** Delivers changes and events to their handlers; each frame and step does. Not in a callback. */
fettle_code fettle_hosted_barrier(fettle_hosted* game);

/** Hash of all data that influence later steps. */
fettle_code fettle_hosted_hash(fettle_hosted* game, uint64_t* hash);

FETTLE_HOST_END
