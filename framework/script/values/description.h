#pragma once
// Descriptions: read-only records and lists for scripts. They contain the properties, methods and
// events of classes, and no script can change them.

#include <string>
#include <vector>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

/// What a kind of description is called, and which fields it has. A list of descriptions has none:
/// its elements are reached by number and by their names.
struct DescriptionKind {
    const char* noun;  // "a description of a property"
    std::vector<std::string> fields;
};

/// The table on top becomes a description of that kind; `kind` must live on.
void seal_description(lua_State* L, Machine& machine, const DescriptionKind& kind);
/// The same for a list: elements 1 .. n, and each once more under its name.
void seal_list(lua_State* L, Machine& machine);
/// Pushes the table inside the description at `index`; nothing when it is none.
bool push_described(lua_State* L, int index);
/// The kind of the description at `index`, nullptr when it is none.
const DescriptionKind* description_kind(lua_State* L, int index);
bool is_description_list(const DescriptionKind& kind);

void open_descriptions(lua_State* L, Machine& machine);

}  // namespace fettle::script
