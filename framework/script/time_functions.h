#pragma once
// `snapshot restore rewind`: time as scripts and the console travel it.

#include "lua_api.h"

namespace fettle::script {

/// Into the table of globals on top.
void open_time(lua_State* L);

}  // namespace fettle::script
