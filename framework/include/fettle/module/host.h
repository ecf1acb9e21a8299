#pragma once
/* A game without a window for programs in C: a property tree, and modules that plug into it. The
 * program uses the same table of functions as a module: it creates, reads and writes through
 * `fettle_game_host`. examples/bare/bare.c is a complete program. */

#include <fettle/module/abi.h>
#include <fettle/module/export.h>

FETTLE_MODULE_BEGIN

#ifdef __cplusplus
extern "C" {
#endif

typedef struct fettle_game fettle_game;

/* Null if there is not enough memory. The other functions do nothing with a null game, and return
 * null or FETTLE_ERR_FAILED. */
fettle_game* fettle_game_open(void);
void fettle_game_close(fettle_game* game);
/* Valid until the game is closed. `define_class` refuses: only modules define classes. */
const fettle_host* fettle_game_host(fettle_game* game);
/* Plugs in the module in a shared object. After a failure, `last_error` of the host has the reason.
 * The program fettle-trial tries the module out first: it is looked for in the prefix of the
 * installation, and the environment variable FETTLE_TRIAL names another place. */
fettle_status fettle_game_load(fettle_game* game, const char* file);
/* One fixed step: the modules in the order of loading, then a barrier. */
fettle_status fettle_game_step(fettle_game* game, double seconds);

#ifdef __cplusplus
}
#endif

FETTLE_MODULE_END
