// Lists that are the value of a property. Reading an element reads the property; writing one is a
// change of the whole list, which is copied only if something else holds it; writing one past the
// end appends.

#include <algorithm>
#include <optional>
#include <utility>

#include <lua/exception_guard.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <values/moved_lists.h>
#include <values/short_text.h>
#include <values/values.h>
#include <writes/writes.h>

namespace fettle::script {

Value list_value(lua_State* L, const ListBox& box, bool* moved) {
    std::optional<Value> before;
    if (box.origin.depth > 0) before = machine_of(L).moved_lists.find(box.origin, box.since);
    if (moved != nullptr) *moved = before.has_value();
    Value value = before ? std::move(*before) : origin_read(machine_of(L), box.origin);
    if (!value.is(Type::list))
        throw Error(ErrorKind::wrong_type,
                    origin_path(machine_of(L).tree, box.origin) + ": is not a list any more");
    return value;
}

namespace {

void require_not_replaced(Machine& machine, const ListBox& box) {
    if (box.origin.depth > 0 && machine.moved_lists.find(box.origin, box.since))
        throw Error(ErrorKind::deleted,
                    origin_path(machine.tree, box.origin) +
                        ": this list was replaced or moved after it was read; read it again");
}

}  // namespace

void write_list(lua_State* L, const ListBox& box, const List& list) {
    Machine& machine = machine_of(L);
    require_not_replaced(machine, box);
    if (box.origin.depth == 0)
        write_property(machine, box.origin.instance, origin_property(machine.tree, box.origin),
                       list);
    else
        origin_write(machine, box.origin, nullptr, list);
}

bool change_element(lua_State* L, const ListBox& box, Value& before, std::size_t index,
                    const Value& element) {
    // A list that was in this place, or was, may still be in a variable (see MovedLists).
    const List& list = before.list();
    if (index <= list.size() && list[index - 1].is(Type::list)) return false;
    before = Value();  // nothing but the property holds the list now, so it need not be copied
    if (write_element(machine_of(L), box.origin, index, element)) return true;
    before = list_value(L, box);
    return false;
}

namespace {

ListBox& list_self(lua_State* L) {
    auto* box = list_at(L, 1);
    if (!box) refuse_type(L, 1, "needs a list");
    return *box;
}

Origin element_of(const ListBox& box, std::size_t index) {
    Origin origin = box.origin;
    if (origin.depth < Origin::deepest)
        origin.part[origin.depth++] = static_cast<std::uint32_t>(index);
    return origin;
}

// Pushes element `index`, with its origin unless it is nested too deep or its list is `moved`.
void push_element(lua_State* L, const ListBox& box, const Value& element, std::size_t index,
                  bool moved) {
    if (moved || (box.origin.depth >= Origin::deepest && !element.is(Type::list)))
        push_value(L, element);
    else
        push_value(L, element, element_of(box, index));
}

int list_index(lua_State* L) {
    const ListBox& box = list_self(L);
    int whole_number = 0;
    const lua_Integer index = lua_tointegerx(L, 2, &whole_number);
    if (lua_type(L, 2) != LUA_TNUMBER || !whole_number)
        throw Error(ErrorKind::unknown_name, origin_path(machine_of(L).tree, box.origin) +
                                                 ": a list has elements 1, 2, 3 ..., not " +
                                                 key_in_message(L, 2));
    bool moved = false;
    const Value value = list_value(L, box, &moved);
    const List& list = value.list();
    if (index < 1 || static_cast<std::size_t>(index) > list.size()) {
        lua_pushnil(L);
        return 1;
    }
    push_element(L, box, list[static_cast<std::size_t>(index - 1)], static_cast<std::size_t>(index),
                 moved);
    return 1;
}

int list_newindex(lua_State* L) {
    const ListBox& box = list_self(L);
    Machine& machine = machine_of(L);
    int whole_number = 0;
    const lua_Integer index = lua_tointegerx(L, 2, &whole_number);
    require_not_replaced(machine, box);
    Value value = list_value(L, box);
    const auto size = static_cast<lua_Integer>(value.list().size());
    const auto name = [&] { return origin_path(machine.tree, box.origin); };
    if (lua_type(L, 2) == LUA_TSTRING)
        throw Error(ErrorKind::wrong_type,
                    name() + ": is a list with elements 1, 2, 3 ..., and has no element " +
                        key_in_message(L, 2) +
                        "; values with names are properties of an instance: Object { sword = 1 }");
    if (!whole_number || index < 1 || index > size + 1)
        throw Error(ErrorKind::out_of_range,
                    name() + "[" + key_in_message(L, 2) + "]: " +
                        (size == 0 ? "the list is empty; 1 appends"
                                   : "the list has elements 1 to " + std::to_string(size) + "; " +
                                         std::to_string(size + 1) + " appends"));
    const bool removes = lua_isnil(L, 3);
    if (removes && index != size)  // removing any other element would leave a gap
        throw Error(ErrorKind::out_of_range,
                    origin_path(machine.tree, box.origin) + "[" + std::to_string(index) +
                        "]: only the last element can be removed so; use table.remove");
    const auto place = static_cast<std::size_t>(index - 1);
    if (change_element(L, box, value, place + 1, to_value(L, 3))) return 0;
    if (!removes && box.origin.depth < Origin::deepest) {
        origin_write(machine, element_of(box, place + 1), nullptr, to_value(L, 3));
    } else {
        List changed = value.list();
        changed.resize(std::max(changed.size(), place + 1));
        if (removes)
            changed.pop_back();
        else
            changed[place] = to_value(L, 3);
        write_list(L, box, changed);
    }
    if (index <= size) machine.moved_lists.note(box.origin, place + 1, place + 1, value);
    return 0;
}

int list_length(lua_State* L) {
    const ListBox& box = list_self(L);
    lua_pushinteger(L, static_cast<lua_Integer>(list_value(L, box).list().size()));
    return 1;
}

int list_equal(lua_State* L) {
    const auto *a = list_at(L, 1), *b = list_at(L, 2);
    lua_pushboolean(L, a && b && list_value(L, *a) == list_value(L, *b));
    return 1;
}

int list_tostring(lua_State* L) {
    push_text(L, machine_of(L).tree.text(list_value(L, list_self(L))));
    return 1;
}

// Iterates over a copy of the elements made at the start. Upvalues: table with the copy, position.
int next_element(lua_State* L) {
    const lua_Integer index = lua_tointeger(L, lua_upvalueindex(2)) + 1;
    lua_pushinteger(L, index);
    lua_copy(L, -1, lua_upvalueindex(2));
    if (lua_rawgeti(L, lua_upvalueindex(1), index) == LUA_TNIL) return 1;
    return 2;
}

int list_pairs(lua_State* L) {
    const ListBox& box = list_self(L);
    bool moved = false;
    const Value value = list_value(L, box, &moved);
    lua_createtable(L, static_cast<int>(value.list().size()), 0);
    for (std::size_t i = 0; i < value.list().size(); ++i) {
        push_element(L, box, value.list()[i], i + 1, moved);
        lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
    }
    lua_pushinteger(L, 0);
    lua_pushcclosure(L, guarded<next_element>, 2);
    return 1;
}

}  // namespace

void open_list(lua_State* L, Machine& machine) {
    lua_newtable(L);
    add_pure<list_index>(L, "__index");
    add_pure<list_newindex>(L, "__newindex");
    add_pure<list_length>(L, "__len");
    add_pure<list_equal>(L, "__eq");
    add_pure<list_tostring>(L, "__tostring");
    add_pure<list_pairs>(L, "__pairs");
    name_metatable(L, "list");
    machine.boxes.list = luaL_ref(L, LUA_REGISTRYINDEX);
}

}  // namespace fettle::script
