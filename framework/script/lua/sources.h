#pragma once
// Files of a game, and the texts that were compiled.

#include <filesystem>
#include <string>
#include <unordered_map>
#include <vector>

#include <fettle/property/storage/game_files.h>

#include <lua/lua_api.h>

namespace fettle::script {

struct Sources {
    property::GameFiles& files;
    std::filesystem::path folder;                        // of the game; empty: there is none
    std::unordered_map<std::string, std::string> texts;  // by the name of the chunk

    /// Compiles a text and keeps it for error messages under `name`. A status of Lua; the function
    /// or the message is on top.
    int load(lua_State* L, const std::string& text, const std::string& name);
    /// A line of a chunk, counted from 1; "" when it is not known.
    std::string line(const std::string& file, int line) const;
};

/// Files below the folder whose names end so, relative to it, for nearest spellings: not more than
/// some thousand.
std::vector<std::string> files_below(const std::filesystem::path& folder, const char* extension);

}  // namespace fettle::script
