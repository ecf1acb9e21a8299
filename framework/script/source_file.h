#pragma once
// Files of a game.

#include <filesystem>
#include <string>

#include "lua_api.h"

namespace fettle::script {

struct Machine;

/// Throws property::FileError when the file cannot be read, or is none of the game's.
std::string read_source(Machine& machine, const std::filesystem::path& path);
/// Compiles text, keeping it for error messages under `name`. A status of Lua; the function or the
/// message is on top.
int load_source(lua_State* L, Machine& machine, const std::string& text, const std::string& name);

}  // namespace fettle::script
