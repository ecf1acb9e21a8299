#pragma once
// Includes Lua's headers. No other file includes them.
//
// lua.hpp is not used, because it declares everything `extern "C"`. Lua's C++ build has C++ names
// on Debian 13; on Debian 12 it has C names, and its headers declare them so.

#include <lauxlib.h>
#include <lua.h>
#include <lualib.h>
