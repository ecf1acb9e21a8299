#pragma once
// Instances in scripts: reading and writing of members by name.

#include <string>
#include <vector>

#include <fettle/property/tree.h>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

void open_instance(lua_State* L, Machine& machine);
/// The general path of a write: children, ad hoc properties, and errors for names that cannot be
/// written. The value is at stack index 3.
void write_member(lua_State* L, Machine& machine, property::Handle instance,
                  const property::Class& of, std::string_view name);
/// "world.ball.mass", also for a name that does not exist.
std::string path_of(const property::Tree& tree, property::Handle instance, std::string_view name);
/// All names that the instance has, for suggestions and completion.
std::vector<std::string> names_of(Machine& machine, property::Handle instance);

}  // namespace fettle::script
