#pragma once
// Descriptions of classes for scripts: `classes`, `Body.properties`, `Body.methods`, `Body.events`,
// `ball:describe()`.
//   for _, p in ipairs(Body.properties) do print(p.name, p.type, p.unit) end

#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/tree.h>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

/// Pushes the list of all classes, in order of definition.
void push_classes(lua_State* L, Machine& machine);
/// Names of the fields that describe a class.
const std::vector<std::string>& class_fields();
/// Pushes one of these fields; returns false for any other name.
bool push_class_field(lua_State* L, Machine& machine, const property::Class& of,
                      std::string_view name);
/// `:describe()` lists the properties of an instance, including ad hoc properties;
/// `:describe(name)` describes one property, method or event.
int describe_instance(lua_State* L);

}  // namespace fettle::script
