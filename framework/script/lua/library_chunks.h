#pragma once
// Chunks of Lua that are part of the framework.

#include <string>

#include <lua/lua_api.h>

namespace fettle::script {

/// The name of a chunk of Lua that is part of the framework: errors in it are reported at the
/// script's line that called it.
inline std::string library_chunk(const std::string& name) {
    return "[" + name + "]";
}

/// Needs the field `source` (lua_getinfo with "S").
inline bool is_library(const lua_Debug& frame) {
    return frame.source[0] == '@' && frame.source[1] == '[';
}

}  // namespace fettle::script
