#pragma once
// The store of the game, `store`: tables of values that outlive a run. In Lua a table of the store
// is a userdata that names it; reading and writing go to the store itself.

#include <string>

#include <fettle/property/storage/store.h>

#include <values/values.h>

namespace fettle::script {

struct StoreBox {
    Tag tag;
    property::Store::Table table;
    // The content of the table, which stays readable after the table was removed from the store:
    // sorting a list, for example, overwrites an element while a Lua variable still refers to the
    // old one.
    std::shared_ptr<const property::Store::Content>* content;
};

inline StoreBox* store_at(lua_State* L, int index) {
    return box_at<StoreBox>(L, index, Tag::store);
}

/// If the vector or color at 1 was read from the store, gives it the value that is there now, and
/// returns true. Then `write_stored` puts it back, and `stored_path` names its place.
bool refresh_stored(lua_State* L);
void write_stored(lua_State* L);
std::string stored_path(lua_State* L);

/// The entries of a table of the store on one line: `{best = 3, levels = {1, 2}}`.
std::string stored_text(Machine& machine, const StoreBox& box);

/// A list in the store as the value of a property, with its lists. Throws for a table with names.
property::Value stored_list(lua_State* L, const StoreBox& box);

/// Makes the metatable, and adds `store` to the table of globals at the top of the stack.
void open_store(lua_State* L, Machine& machine);

}  // namespace fettle::script
