#pragma once
// Descriptions: read-only records and lists for scripts. They describe the properties, methods and
// events of classes.

#include <string>
#include <vector>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

/// The name of a kind of descriptions, and its fields. A list of descriptions has no fields; its
/// elements have numbers and names.
struct DescriptionKind {
    const char* noun;  // "a description of a property"
    std::vector<std::string> fields;
};

/// Makes the table at the top of the stack a description of this kind; `kind` must outlive it.
void seal_description(lua_State* L, Machine& machine, const DescriptionKind& kind);
/// The same for a list: it has elements 1 .. n, and each again under its name.
void seal_list(lua_State* L, Machine& machine);
/// Pushes the table inside the description at `index`. Pushes nothing and returns false if there is
/// none.
bool push_described(lua_State* L, int index);
/// The kind of the description at `index`; nullptr if there is none.
const DescriptionKind* description_kind(lua_State* L, int index);
bool is_description_list(const DescriptionKind& kind);

void open_descriptions(lua_State* L, Machine& machine);

}  // namespace fettle::script
