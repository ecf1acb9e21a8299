#pragma once
// Functions of the host that scripts can call by a global name.

#include <string>

#include <lua/host.h>

namespace fettle::script {

struct Machine;

/// Sets the global `name`, also over one of the game.
void add_host_function(Machine& machine, const std::string& name, HostFunction function);

}  // namespace fettle::script
