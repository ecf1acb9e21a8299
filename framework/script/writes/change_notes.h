#pragma once
// Notes about changes at a moment that the author of a game probably did not mean: while a function
// draws, and after snapshot() in the same function.

#include <string_view>

#include <lua/tree_names.h>

namespace fettle::script {

struct Machine;

/// To be called before a script changes an instance. `name`: of the property, the method or the
/// child; "" for the instance itself. If the instance is part of the simulation and a function is
/// drawing, gives a note, once for each name and class; after snapshot(), once for a game.
void note_change(Machine& machine, Handle instance, std::string_view name);

}  // namespace fettle::script
