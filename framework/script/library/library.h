#pragma once
// The functions that the framework adds to Lua's own.

#include <cstddef>
#include <string>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

// Each function adds its names to the table of globals at the top of the stack.
void open_scenes(lua_State* L);
void open_saves(lua_State* L);
void open_stated(lua_State* L);
void open_tweaks(lua_State* L);
void open_history(lua_State* L);
void open_console_functions(lua_State* L);
/// `it = ball` in the console: selects the instance at `index`, or nothing if it is nil.
void assign_it(lua_State* L, int index);
/// Whether the text is the name of a function of the console that lists something when it stands
/// alone, as `pin`, and no variable of the game has that name. Then `lines` become that list.
bool list_by_word(lua_State* L, std::string_view word, std::vector<std::string>& lines);

/// Says that an edit was too large to be undone, and which property changes that; "" if there was
/// none since `before`, which is an earlier value of `property::edits_without_undo`.
std::string lost_undo(const Machine& machine, std::size_t before);

/// Returns true in a replay, and notes that `what` writes nothing. It is not an error, because then
/// the replay would differ from the recorded run.
bool note_replay(Machine& machine, const std::string& what);

}  // namespace fettle::script
