#pragma once
// Events that classes of scripts declare: `events = { "died", hit = { by = "", damage = 0 } }`, and
// `foe:send("hit", { by = "an arrow" })`.

#include <string>
#include <vector>

#include <classes/script_classes.h>

struct lua_State;

namespace fettle::script {

/// Whether the table at `index` declares events: names, and tables by names. An empty table and one
/// with other values are the default of a property called `events`.
bool declares_events(lua_State* L, int index);

/// The events in the table at the top of the stack.
std::vector<ScriptClasses::OwnEvent> events_at_top(lua_State* L, const std::string& class_name);

/// The property from `name = value` in a class or in an event; the value is at the top of the
/// stack.
property::Property declared_property(lua_State* L, const std::string& owner,
                                     const std::string& name);

/// How the events of the first definition of a class differ from those of the second; "" if they do
/// not.
std::string difference(const std::vector<ScriptClasses::OwnEvent>& first,
                       const std::vector<ScriptClasses::OwnEvent>& second);

/// `obj:send(event, data)`
int send_event(lua_State* L);

}  // namespace fettle::script
