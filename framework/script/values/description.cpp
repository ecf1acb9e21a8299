#include <algorithm>

#include <fettle/property/spelling.h>

#include <lua/exception_guard.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <values/description.h>
#include <values/short_text.h>
#include <values/values.h>

namespace fettle::script {

namespace {

// User value 1: the table.
struct DescriptionBox {
    Tag tag;
    const DescriptionKind* kind;
};

const DescriptionKind list_kind{"a list of descriptions", {}};

const DescriptionKind& self(lua_State* L) {
    if (const DescriptionKind* kind = description_kind(L, 1)) return *kind;
    refuse_type(L, 1, "needs a description");
}

std::vector<std::string> names_in(lua_State* L, int table) {
    table = lua_absindex(L, table);
    std::vector<std::string> names;
    for (lua_pushnil(L); lua_next(L, table) != 0; lua_pop(L, 1))
        if (lua_type(L, -2) == LUA_TSTRING) names.emplace_back(string_at(L, -2));
    std::sort(names.begin(), names.end());
    return names;
}

// Replaces a vector or color at the top of the stack by a copy, because these values can be changed
// in place.
void copy_of_value(lua_State* L) {
    if (const auto* vec = vec_at(L, -1)) {
        push_vec(L, {vec->x, vec->y});
    } else if (const auto* color = color_at(L, -1)) {
        push_color(L, color->color);
    } else {
        return;
    }
    lua_remove(L, -2);
}

int description_index(lua_State* L) {
    const DescriptionKind& kind = self(L);
    push_described(L, 1);
    lua_pushvalue(L, 2);
    if (lua_rawget(L, -2) != LUA_TNIL) {
        copy_of_value(L);
        return 1;
    }
    const bool list = is_description_list(kind);
    if (list ? lua_type(L, 2) != LUA_TSTRING
             : std::find(kind.fields.begin(), kind.fields.end(), key_in_message(L, 2)) !=
                   kind.fields.end())
        return 1;
    const std::vector<std::string> names = list ? names_in(L, -2) : kind.fields;
    throw Error(ErrorKind::unknown_name, std::string(kind.noun) + " has no " +
                                             key_in_message(L, 2) +
                                             property::suggestion(key_in_message(L, 2), names));
}

int description_newindex(lua_State* L) {
    throw Error(ErrorKind::rejected, std::string(self(L).noun) + " cannot be changed");
}

int description_length(lua_State* L) {
    self(L);
    push_described(L, 1);
    lua_pushinteger(L, static_cast<lua_Integer>(lua_rawlen(L, -1)));
    return 1;
}

// Upvalues: position, fields of a record. Iterates over a list by number, and over a record in the
// documented order of its fields.
int next_entry(lua_State* L) {
    const DescriptionKind& kind = self(L);
    for (;;) {
        const lua_Integer position = lua_tointeger(L, lua_upvalueindex(1)) + 1;
        lua_pushinteger(L, position);
        lua_copy(L, -1, lua_upvalueindex(1));
        if (!is_description_list(kind)) {
            if (position > static_cast<lua_Integer>(kind.fields.size())) return 0;
            lua_pop(L, 1);
            lua_pushstring(L, kind.fields[static_cast<std::size_t>(position - 1)].c_str());
        }
        push_described(L, 1);
        lua_pushvalue(L, -2);
        const bool found = lua_rawget(L, -2) != LUA_TNIL;
        lua_remove(L, -2);
        if (found) {
            copy_of_value(L);
            return 2;
        }
        if (is_description_list(kind)) return 0;
        lua_pop(L, 2);
    }
}

int description_pairs(lua_State* L) {
    self(L);
    lua_pushinteger(L, 0);
    lua_pushcclosure(L, guarded<next_entry>, 1);
    lua_pushvalue(L, 1);
    return 2;
}

int description_tostring(lua_State* L) {
    self(L);
    lua_pushstring(L, short_text(L, 1).c_str());
    return 1;
}

void seal(lua_State* L, Machine& machine, const DescriptionKind& kind) {
    auto* box = static_cast<DescriptionBox*>(lua_newuserdatauv(L, sizeof(DescriptionBox), 1));
    *box = {Tag::description, &kind};
    lua_insert(L, -2);
    lua_setiuservalue(L, -2, 1);
    push_registry(L, machine.boxes.description);
    lua_setmetatable(L, -2);
}

}  // namespace

void seal_description(lua_State* L, Machine& machine, const DescriptionKind& kind) {
    seal(L, machine, kind);
}

void seal_list(lua_State* L, Machine& machine) {
    seal(L, machine, list_kind);
}

const DescriptionKind* description_kind(lua_State* L, int index) {
    const auto* box = box_at<DescriptionBox>(L, index, Tag::description);
    return box ? box->kind : nullptr;
}

bool is_description_list(const DescriptionKind& kind) {
    return &kind == &list_kind;
}

bool push_described(lua_State* L, int index) {
    if (!description_kind(L, index)) return false;
    lua_getiuservalue(L, index, 1);
    return true;
}

void open_descriptions(lua_State* L, Machine& machine) {
    lua_newtable(L);
    add_pure<description_index>(L, "__index");
    add_pure<description_newindex>(L, "__newindex");
    add_pure<description_length>(L, "__len");
    add_pure<description_pairs>(L, "__pairs");
    add_pure<description_tostring>(L, "__tostring");
    name_metatable(L, "description");
    machine.boxes.description = luaL_ref(L, LUA_REGISTRYINDEX);
}

}  // namespace fettle::script
