#pragma once
// Notes about functions that change the game while they draw it.

#include <string_view>

#include <lua/tree_names.h>

namespace fettle::script {

struct Machine;

/// To be called before a script changes an instance. `name`: of the property, the method or the
/// child; "" for the instance itself. If a function is drawing and the instance is part of the
/// simulation, gives a note, once for each name and class.
void note_drawn_change(Machine& machine, Handle instance, std::string_view name);

}  // namespace fettle::script
