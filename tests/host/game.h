#pragma once

#include <fettle_host.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A ball falls for half a second, and another one with half of gravity. Returns the first code that
   is not FETTLE_DONE; `changes` are those that a watcher saw. */
int32_t run_a_game_in_c(double* height, int* changes);

#ifdef __cplusplus
}
#endif
