#pragma once
// Lua's headers. This library is the only place that includes them.
//
// Not lua.hpp, which declares everything `extern "C"`: Lua's C++ build has names in C++ (Debian
// 13), and where it was given names in C its headers say so themselves (Debian 12).

#include <lauxlib.h>
#include <lua.h>
#include <lualib.h>
