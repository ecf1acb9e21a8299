#pragma once
// The global `pen`, with which `draw(pen)` draws.

#include <cstddef>

#include <fettle/property/painter.h>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

struct Pen {
    int reference = 0;                     // reference in the registry
    property::Painter* painter = nullptr;  // null except while drawing
    std::size_t base = 0;                  // `pop` may not go below this number of transforms
};

void open_pen(lua_State* L, Machine& machine);

}  // namespace fettle::script
