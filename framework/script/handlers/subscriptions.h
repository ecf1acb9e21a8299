#pragma once
// Functions of a script that the tree calls at barriers: `watch` and `on`, and the connections that
// end them.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <unordered_map>

#include <fettle/property/question.h>
#include <fettle/property/tree.h>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

// Methods of instances and classes.
int subscribe_property(lua_State* L);
int subscribe_event(lua_State* L);

/// Pushes the record handlers of events get.
void push_occurrence(lua_State* L, const property::Occurrence& occurrence);
/// What a handler left in the record, which is on top of the stack, of an event that asks.
void take_answer(lua_State* L, property::Question& question);
void push_existence(lua_State* L, const property::Existence& existence);
/// A handler for `on` over a whole class.
property::Connection connect_event(lua_State* L, Machine& machine, property::Handle instance,
                                   const property::Class& of, const std::string& name,
                                   bool whole_class);

/// `watch` among the globals on top.
void open_watch(lua_State* L);

}  // namespace fettle::script
