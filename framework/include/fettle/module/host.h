#pragma once
/* A game without a window for programs in C: a property tree, and modules that plug into it. The
 * functions that a module is given are the program's too: it creates, reads and writes through
 * `fettle_game_host`. examples/bare/bare.c is a whole program. */

#include <fettle/module/abi.h>
#include <fettle/module/export.h>

FETTLE_MODULE_BEGIN

#ifdef __cplusplus
extern "C" {
#endif

typedef struct fettle_game fettle_game;

/* Null when there is no memory for it. */
fettle_game* fettle_game_open(void);
void fettle_game_close(fettle_game* game);
/* Good until the game is closed. `define_class` refuses: a program has no classes, modules have. */
const fettle_host* fettle_game_host(fettle_game* game);
/* Plugs in the module in a shared object. Why it cannot is told by the host's `last_error`. */
fettle_status fettle_game_load(fettle_game* game, const char* file);
/* One fixed step: the modules in the order they were loaded in, then a barrier. */
fettle_status fettle_game_step(fettle_game* game, double seconds);

#ifdef __cplusplus
}
#endif

FETTLE_MODULE_END
