#pragma once

#include <game/run_options.h>

namespace fettle::program {

/// Plays the recording `options.replay`, with or without a window, and checks that the run is the
/// same. Returns the exit status.
int run_replay(RunOptions options);

}  // namespace fettle::program
