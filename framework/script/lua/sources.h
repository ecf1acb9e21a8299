#pragma once
// The files of a game, and the texts of compiled chunks.

#include <filesystem>
#include <string>
#include <unordered_map>

#include <fettle/property/storage/game_files.h>

#include <lua/lua_api.h>

namespace fettle::script {

struct Sources {
    property::GameFiles& files;
    std::filesystem::path folder;                        // of the game; empty if there is none
    std::unordered_map<std::string, std::string> texts;  // by name of the chunk

    /// Compiles a text and stores it for error messages under `name`. Returns a status of Lua; the
    /// function or the message is at the top of the stack.
    int load(lua_State* L, const std::string& text, const std::string& name);
    /// A line of a chunk, from 1; "" if unknown.
    std::string line(const std::string& file, int line) const;
};

}  // namespace fettle::script
