#pragma once
// Lua's headers. This library is the only place that includes them.

#include <lua.hpp>
