#pragma once
// `pen`, what `draw(pen)` draws with.

#include <fettle/property/painter.h>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

struct Pen {
    int reference = 0;                     // in the registry
    property::Painter* painter = nullptr;  // while something is drawn
};

void open_pen(lua_State* L, Machine& machine);

}  // namespace fettle::script
