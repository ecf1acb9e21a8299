#pragma once
// The lines in which the console tells what a command has changed.

#include <fettle/script/runtime.h>

namespace fettle::script {

struct Machine;

/// Adds a line for each change of the recorded command: "world.ball.mass: 2 → 5 kg". Those after
/// the first twenty are folded.
void add_echoes(Machine& machine, Evaluation& evaluation);

}  // namespace fettle::script
