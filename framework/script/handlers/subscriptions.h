#pragma once
// Functions of a script that the tree calls at barriers: `watch`, `on` and their connections.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <unordered_map>

#include <fettle/property/question.h>
#include <fettle/property/tree.h>

#include <handlers/connections.h>
#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

// Methods of instances and classes: `watch` and `on`.
int subscribe_property(lua_State* L);
int subscribe_event(lua_State* L);

/// Pushes the record that is the argument of an event handler.
void push_occurrence(lua_State* L, const property::Occurrence& occurrence);
/// Reads the answers of a handler to a question from the record at the top of the Lua stack.
void read_answers(lua_State* L, property::Question& question);
/// True if the instance was created or deleted by the restore of a snapshot. Handlers are not
/// called then: they would change the restored state, for example by an explosion for each enemy
/// that does not exist yet.
bool caused_by_restore(const property::Existence& existence);
void push_existence(lua_State* L, const property::Existence& existence);
/// The handler at the top of the Lua stack, for an event of an instance, or of all instances of a
/// class.
Subscription event_subscription(lua_State* L, Machine& machine, const property::Class& of,
                                const std::string& name, bool whole_class);

/// Adds `watch` to the table of globals at the top of the Lua stack.
void open_watch(lua_State* L);

}  // namespace fettle::script
