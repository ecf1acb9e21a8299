#pragma once
// go_to_scene("level_2", { transition = "fade", seconds = 0.5, args = { ... } }): `game.scene` is
// replaced.

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

/// Adds `go_to_scene` to the table of globals at the top of the stack, and the class Transition to
/// the tree.
void open_scene_changes(lua_State* L);
/// A frame, `seconds` of real time after the last one: a transition goes on, also in a paused game.
void advance_transition(Machine& machine, double seconds);

}  // namespace fettle::script
