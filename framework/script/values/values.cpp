#include <algorithm>
#include <new>
#include <optional>

#include <fettle/property/spelling.h>

#include <limits/limiters.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <values/description.h>
#include <values/members.h>
#include <values/moved_lists.h>
#include <values/store_type.h>
#include <values/values.h>

namespace fettle::script {

// --- Boxes

namespace {

template <class Box>
Box* new_box(lua_State* L, std::size_t size, int meta, int user_values = 0) {
    void* memory = lua_newuserdatauv(L, size, user_values);
    push_registry(L, meta);
    lua_setmetatable(L, -2);
    return static_cast<Box*>(memory);
}

}  // namespace

void push_vec(lua_State* L, const Vec2& v, int user_values) {
    auto* box = new_box<VecBox>(L, offsetof(VecBox, origin), machine_of(L).boxes.vec, user_values);
    box->tag = Tag::vec;
    box->has_origin = false;
    box->x = v.x;
    box->y = v.y;
}

void push_vec(lua_State* L, const Vec2& v, const Origin& origin) {
    auto* box = new_box<VecBox>(L, sizeof(VecBox), machine_of(L).boxes.vec);
    box->tag = Tag::vec;
    box->has_origin = true;
    box->x = v.x;
    box->y = v.y;
    new (&box->origin) Origin(origin);
}

void push_vec(lua_State* L, const Vec2& v, Handle instance, const Property& property) {
    auto* box = new_box<VecBox>(L, sizeof(VecBox), machine_of(L).boxes.vec);
    box->tag = Tag::vec;
    box->has_origin = true;
    box->x = v.x;
    box->y = v.y;
    box->origin.instance = instance;
    box->origin.property = &property;
    box->origin.depth = 0;  // the other members are read only if depth > 0 or `property` is null
}

void push_color(lua_State* L, property::Color color, int user_values) {
    auto* box =
        new_box<ColorBox>(L, offsetof(ColorBox, origin), machine_of(L).boxes.color, user_values);
    box->tag = Tag::color;
    box->has_origin = false;
    box->color = color;
}

void push_color(lua_State* L, property::Color color, const Origin& origin) {
    auto* box = new_box<ColorBox>(L, sizeof(ColorBox), machine_of(L).boxes.color);
    box->tag = Tag::color;
    box->has_origin = true;
    box->color = color;
    new (&box->origin) Origin(origin);
}

void push_instance(lua_State* L, Handle handle) {
    if (!handle) {
        lua_pushnil(L);
        return;
    }
    Machine& machine = machine_of(L);
    const auto key = static_cast<lua_Integer>(handle.key());
    push_registry(L, machine.boxes.proxies);
    if (lua_rawgeti(L, -1, key) == LUA_TUSERDATA) {
        lua_remove(L, -2);
        return;
    }
    lua_pop(L, 1);
    // A deleted instance gets a proxy, too; errors of its use say how the instance was deleted.
    const Class& of =
        machine.tree.alive(handle) ? machine.tree.class_of(handle) : machine.tree.object_class();
    auto* box = new_box<InstanceBox>(L, sizeof(InstanceBox), machine.boxes.instance);
    box->tag = Tag::instance;
    box->handle = handle;
    box->members = &machine.members.of(of);
    lua_pushvalue(L, -1);
    lua_rawseti(L, -3, key);
    lua_remove(L, -2);
}

bool refresh_class(Machine& machine, const InstanceBox& box) {
    const Class& of = machine.tree.class_of(box.handle);
    if (&of == &box.members->of) return false;
    box.members = &machine.members.of(of);
    return true;
}

void refresh_classes(Machine& machine) {
    lua_State* L = machine.lua.main;
    DispatchTable& unknown = machine.members.of(machine.tree.object_class());
    push_registry(L, machine.boxes.proxies);
    lua_pushnil(L);
    while (lua_next(L, -2) != 0) {
        const auto* box = static_cast<const InstanceBox*>(lua_touserdata(L, -1));
        lua_pop(L, 1);
        if (!machine.tree.alive(box->handle)) continue;
        try {
            refresh_class(machine, *box);
        } catch (const std::bad_alloc&) {
            box->members = &unknown;  // determined when it is used
        }
    }
    lua_pop(L, 1);
}

// --- To Lua

namespace {

void push_scalar(lua_State* L, const Value& value) {
    switch (value.type()) {
        case Type::nil:
            lua_pushnil(L);
            break;
        case Type::boolean:
            lua_pushboolean(L, value.boolean());
            break;
        case Type::integer:
            lua_pushinteger(L, value.integer());
            break;
        case Type::number:
            lua_pushnumber(L, value.number());
            break;
        case Type::text:
            push_text(L, value.text());
            break;
        case Type::reference:
            push_instance(L, value.reference());
            break;
        default:
            lua_pushnil(L);
            break;
    }
}

}  // namespace

void push_value(lua_State* L, const Value& value) {
    switch (value.type()) {
        case Type::vec2:
            push_vec(L, value.vec2());
            break;
        case Type::color:
            push_color(L, value.color());
            break;
        case Type::list: {
            luaL_checkstack(L, 8, "list");
            const List& list = value.list();
            lua_createtable(L, static_cast<int>(list.size()), 0);
            for (std::size_t i = 0; i < list.size(); ++i) {
                push_value(L, list[i]);
                lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
            }
            break;
        }
        default:
            push_scalar(L, value);
    }
}

void push_value(lua_State* L, const Value& value, const Origin& origin) {
    switch (value.type()) {
        case Type::vec2:
            push_vec(L, value.vec2(), origin);
            break;
        case Type::color:
            push_color(L, value.color(), origin);
            break;
        case Type::list: {
            if (origin.depth >= Origin::deepest)
                throw Error(ErrorKind::bad_structure,
                            origin_path(machine_of(L).tree, origin) +
                                ": lists inside lists can be indexed four deep, no deeper");
            auto* box = new_box<ListBox>(L, sizeof(ListBox), machine_of(L).boxes.list);
            box->tag = Tag::list;
            new (&box->origin) Origin(origin);
            box->since = machine_of(L).moved_lists.now();
            break;
        }
        case Type::reference:
            // A reference to a deleted instance reads as nil.
            if (machine_of(L).tree.alive(value.reference()))
                push_instance(L, value.reference());
            else
                lua_pushnil(L);
            break;
        default:
            push_scalar(L, value);
    }
}

// --- From Lua

namespace {

/// By the name of its metatable: "a formula", "a snapshot".
std::string object_noun(lua_State* L, int index) {
    if (!lua_checkstack(L, 3) || luaL_getmetafield(L, index, "__name") == LUA_TNIL)
        return "an object";
    const std::string name = lua_type(L, -1) == LUA_TSTRING ? string_at(L, -1) : "object";
    lua_pop(L, 1);
    return property::with_article(name);
}

}  // namespace

std::string describe_type(lua_State* L, int index) {
    if (const auto* box = instance_at(L, index))
        return property::with_article(box->members->of.name());
    if (vec_at(L, index)) return "a vec";
    if (color_at(L, index)) return "a color";
    if (list_at(L, index)) return "a list";
    if (class_object_at(L, index)) return "a class";
    if (const DescriptionKind* kind = description_kind(L, index)) return kind->noun;
    switch (lua_type(L, index)) {
        case LUA_TNONE:
        case LUA_TNIL:
            return "nil";
        case LUA_TBOOLEAN:
            return "a boolean";
        case LUA_TNUMBER:
            return lua_isinteger(L, index) ? "an integer" : "a number";
        case LUA_TSTRING:
            return "a text";
        case LUA_TTABLE:
            return "a table";
        case LUA_TFUNCTION:
            return "a function";
        case LUA_TTHREAD:
            return "a coroutine";
        default:
            return object_noun(L, index);
    }
}

std::vector<std::string> sorted_keys(lua_State* L, int table, const std::string& what) {
    std::vector<std::string> keys;
    for (lua_pushnil(L); lua_next(L, table) != 0; lua_pop(L, 1)) {
        if (lua_type(L, -2) == LUA_TSTRING) {
            keys.emplace_back(view_at(L, -2));
        } else if (!lua_isinteger(L, -2)) {
            const std::string type = describe_type(L, -2);
            lua_pop(L, 2);
            throw Error(ErrorKind::bad_name, what + ": a name is a text, not " + type);
        }
    }
    std::sort(keys.begin(), keys.end());
    return keys;
}

namespace {

constexpr int deepest_table = 16;
constexpr lua_Unsigned longest_table = 10'000'000;

Value table_to_list(lua_State* L, int index, int depth);

Value to_value_nested(lua_State* L, int index, int depth) {
    switch (lua_type(L, index)) {
        case LUA_TNIL:
        case LUA_TNONE:
            return {};
        case LUA_TBOOLEAN:
            return lua_toboolean(L, index) != 0;
        case LUA_TNUMBER:
            if (lua_isinteger(L, index)) return static_cast<std::int64_t>(lua_tointeger(L, index));
            return static_cast<double>(lua_tonumber(L, index));
        case LUA_TSTRING:
            return view_at(L, index);
        case LUA_TTABLE:
            return table_to_list(L, index, depth);
        case LUA_TUSERDATA:
            switch (*static_cast<const Tag*>(lua_touserdata(L, index))) {
                case Tag::instance:
                    return static_cast<InstanceBox*>(lua_touserdata(L, index))->handle;
                case Tag::vec: {
                    const auto* box = static_cast<VecBox*>(lua_touserdata(L, index));
                    return Vec2(box->x, box->y);
                }
                case Tag::color:
                    return static_cast<ColorBox*>(lua_touserdata(L, index))->color;
                case Tag::list: {
                    const ListBox& box = *static_cast<ListBox*>(lua_touserdata(L, index));
                    auto before = machine_of(L).moved_lists.find(box.origin, box.since);
                    return before ? std::move(*before) : list_value(L, box);
                }
                case Tag::store:
                    return stored_list(L, *store_at(L, index));
                default:
                    break;
            }
            break;
        default:
            break;
    }
    const std::string what = describe_type(L, index);
    if (lua_type(L, index) == LUA_TFUNCTION)
        throw Error(ErrorKind::wrong_type,
                    "a function is not a value of a property; functions belong to classes "
                    "(function Ball:name()) and handlers (ball:on, ball:watch)");
    throw Error(ErrorKind::wrong_type, what + " is not a value of a property");
}

Value table_to_list(lua_State* L, int index, int depth) {
    if (depth >= deepest_table)
        throw Error(ErrorKind::wrong_type, "the table is nested deeper than 16, or holds itself");
    luaL_checkstack(L, 4, "list");
    index = lua_absindex(L, index);
    const lua_Unsigned length = lua_rawlen(L, index);
    if (length > longest_table)
        throw Error(ErrorKind::wrong_type, "the table has more than 10 million elements");
    machine_of(L).limiters.budget.charge(L, length);
    lua_Unsigned keys = 0;
    std::optional<std::string> name;  // the smallest: the order of `lua_next` differs between runs
    for (lua_pushnil(L); lua_next(L, index) != 0; lua_pop(L, 1), ++keys)
        if (lua_type(L, -2) == LUA_TSTRING)
            if (std::string key = string_at(L, -2); !name || key < *name) name = std::move(key);
    if (name) refuse_named_keys(*name);
    if (keys != length) refuse_gaps();
    List list;
    list.reserve(length);
    for (lua_Unsigned i = 1; i <= length; ++i) {
        lua_rawgeti(L, index, static_cast<lua_Integer>(i));
        list.push_back(to_value_nested(L, -1, depth + 1));
        lua_pop(L, 1);
    }
    return list;
}

}  // namespace

void refuse_named_keys(const std::string& name) {
    throw Error(ErrorKind::wrong_type,
                "a table with named keys (" + name +
                    ") is not a value; a vector is vec(x, y), a color color(r, g, b), a list has "
                    "elements 1, 2, 3 ..., and Object { } takes names");
}

void refuse_gaps() {
    throw Error(ErrorKind::wrong_type, "the table has gaps; a list has elements 1, 2, 3 ...");
}

Value to_value(lua_State* L, int index) {
    return to_value_nested(L, index, 0);
}

}  // namespace fettle::script
