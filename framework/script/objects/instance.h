#pragma once
// What a script can do with an instance: read and write what it has by name.

#include <string>
#include <vector>

#include <fettle/property/tree.h>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

void open_instance(lua_State* L, Machine& machine);
/// The slow half of a write: children, ad-hoc properties, what must not be written. The value is at
/// stack index 3.
void write_member(lua_State* L, Machine& machine, property::Handle instance,
                  const property::Class& of, std::string_view name);
/// "world.ball.mass", whether there is such a name or not.
std::string path_of(const property::Tree& tree, property::Handle instance, std::string_view name);
/// Every name that stands for something on the instance, for nearest spellings and completion.
std::vector<std::string> names_of(Machine& machine, property::Handle instance);

}  // namespace fettle::script
