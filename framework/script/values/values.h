#pragma once
// Converts values of the tree to Lua values and back. Every userdata that a script can hold starts
// with a tag, so that a wrong `self` is detected without a lookup.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <fettle/property/class.h>
#include <fettle/property/symbol.h>
#include <fettle/property/value.h>

#include <lua/lua_api.h>
#include <values/members.h>

namespace fettle::script {

class DispatchTable;
struct Machine;

/// References in Lua's registry: the metatables of the kinds of values, and a table of all known
/// instances.
struct Boxes {
    int vec = 0, color = 0, list = 0, instance = 0, set = 0, class_object = 0;
    int record = 0, connection = 0, snapshot = 0, description = 0, store = 0;
    int proxies = 0;  // weak table from handles to userdata
    // How many more writes of a component look for the variable that holds the vector (see
    // `note_connected`). The number is limited, because a search takes as long as some writes.
    int checked_writes = most_checked_writes;
    static constexpr int most_checked_writes = 4096;
};

/// The first member of every userdata; what has no tag could be taken for another type.
enum class Tag : std::uint32_t {
    instance = 0x46544c01,
    vec,
    color,
    list,
    class_object,
    connection,
    pen,
    formula,
    snapshot,
    description,
    store,
    unfinished_class  // the result of class("Name")
};

/// The place from which a value was read: a property, or an element of a list in it. Assigning a
/// component writes there. An ad hoc property may be removed, so it is stored by name.
struct Origin {
    static constexpr std::uint32_t deepest = 4;
    property::Handle instance;
    const property::Property* property = nullptr;  // nullptr: find it by `symbol`
    property::Symbol symbol;
    std::uint32_t depth = 0;  // number of valid elements of `part`
    std::uint32_t part[deepest] = {};
};

struct InstanceBox {
    Tag tag;
    property::Handle handle;
    mutable DispatchTable* members;  // of its class, as last seen: see `refresh_class`
};

struct VecBox {
    Tag tag;
    bool has_origin;
    double x, y;
    Origin origin;  // exists only if has_origin
};

struct ColorBox {
    Tag tag;
    bool has_origin;
    property::Color color;
    Origin origin;  // exists only if has_origin
};

struct ListBox {
    Tag tag;
    Origin origin;
    std::uint64_t since;  // when it was read: see MovedLists
};

struct ClassBox {
    Tag tag;
    const property::Class* of;
};

/// Updates the class of a living instance, which may differ from that of its proxy: after loading a
/// saved game, another instance may use its slot, and the class of a deleted instance was unknown.
/// Returns whether the class differed.
bool refresh_class(Machine& machine, const InstanceBox& box);
/// Updates all proxies after a restore. Does not throw.
void refresh_classes(Machine& machine);

/// The box at `index` if it has this tag, else nullptr.
template <class Box>
Box* box_at(lua_State* L, int index, Tag tag) {
    auto* box = static_cast<Box*>(lua_touserdata(L, index));
    return box && lua_type(L, index) == LUA_TUSERDATA && box->tag == tag ? box : nullptr;
}
inline InstanceBox* instance_at(lua_State* L, int index) {
    return box_at<InstanceBox>(L, index, Tag::instance);
}
inline VecBox* vec_at(lua_State* L, int index) {
    return box_at<VecBox>(L, index, Tag::vec);
}
inline ColorBox* color_at(lua_State* L, int index) {
    return box_at<ColorBox>(L, index, Tag::color);
}
inline ListBox* list_at(lua_State* L, int index) {
    return box_at<ListBox>(L, index, Tag::list);
}

/// The class of the class object at `index`, else nullptr.
inline const property::Class* class_object_at(lua_State* L, int index) {
    const auto* box = box_at<ClassBox>(L, index, Tag::class_object);
    return box ? box->of : nullptr;
}

/// The living instance at `index`; otherwise raises an error that names `what`.
property::Handle check_instance(lua_State* L, int index, const char* what);
property::Vec2 check_vec(lua_State* L, int index, const char* what);
property::Color check_color(lua_State* L, int index, const char* what);
/// The text at `index`; otherwise raises an error: "on: needs the name of an event, not a number".
std::string check_text(lua_State* L, int index, std::string_view needed);
double check_number(lua_State* L, int index, const char* what);
/// Argument 1 as a time: finite and not negative.
double check_seconds(lua_State* L, const char* what);
void check_function(lua_State* L, int index, const char* what);
/// The `__index` of types whose metatable has `methods`: pushes the method with the name at 2.
/// Otherwise raises an error: "a vec has no lenght (did you mean ...)". `fields`: other valid
/// names.
int push_method(lua_State* L, const std::string& noun, std::vector<std::string> fields = {});
/// Throws Error(wrong_type) with what is needed and the actual type: "..., not a number".
[[noreturn]] void refuse_type(lua_State* L, int index, std::string_view needed);
/// The same for an argument of a method: "add: needs an instance, not nil". If it was called with a
/// dot, the message says how it is called.
[[noreturn]] void refuse_argument(lua_State* L, int index, const std::string& method,
                                  std::string_view needed);

/// `user_values`: how many values of Lua it can carry (see `push_stored`).
void push_vec(lua_State* L, const property::Vec2& v, int user_values = 0);
void push_vec(lua_State* L, const property::Vec2& v, const Origin& origin);
/// A vector read from a property: the most frequent case.
void push_vec(lua_State* L, const property::Vec2& v, property::Handle instance,
              const property::Property& property);
void push_color(lua_State* L, property::Color color, int user_values = 0);
void push_color(lua_State* L, property::Color color, const Origin& origin);
/// Pushes the proxy of the instance; each has exactly one. Pushes nil for the null handle.
void push_instance(lua_State* L, property::Handle handle);
/// Pushes a value without an origin: lists become plain tables.
void push_value(lua_State* L, const property::Value& value);
/// Pushes a value read from a property: vectors, colors and lists keep their origin.
void push_value(lua_State* L, const property::Value& value, const Origin& origin);

/// Throws property::Error(wrong_type) for a Lua value that is not a value of the tree (a function,
/// a table with named keys).
property::Value to_value(lua_State* L, int index);
/// What `to_value` throws for a table that is not a list.
[[noreturn]] void refuse_named_keys(const std::string& name);
[[noreturn]] void refuse_gaps();
/// The same; errors begin with the result of `where()`, the path of a property.
template <class Where>
property::Value to_value(lua_State* L, int index, Where where) {
    try {
        return to_value(L, index);
    } catch (const property::Error& error) {
        throw property::Error(error.kind(), where() + ": " + error.what());
    }
}
/// The name of a Lua value's type in messages: "a number", "a Body", "a table".
std::string describe_type(lua_State* L, int index);
/// The text keys of a table, sorted. Throws for a key that is neither text nor a whole number;
/// `what` names the table.
std::vector<std::string> sorted_keys(lua_State* L, int table, const std::string& what);

/// The property of an origin; throws if the instance was deleted or does not have it any more.
const property::Property& origin_property(const property::Tree& tree, const Origin& origin);
/// The current value at the origin.
property::Value origin_read(Machine& machine, const Origin& origin);
/// Replaces the element, or a component of it, in the whole property and writes the property: one
/// change.
void origin_write(Machine& machine, const Origin& origin, const char* component,
                  const property::Value& value);
/// "world.ball.vertices[2]"
std::string origin_path(const property::Tree& tree, const Origin& origin);

/// Reads and writes the list in a property or in an element of it. `moved`: it is not there any
/// more, and cannot be written.
property::Value list_value(lua_State* L, const ListBox& box, bool* moved = nullptr);
void write_list(lua_State* L, const ListBox& box, const property::List& list);
/// Writes one element, from 1, or removes the last one (nil), without a copy of the others. False
/// if that is not possible. `before`: the list, which is released.
bool change_element(lua_State* L, const ListBox& box, property::Value& before, std::size_t index,
                    const property::Value& element);

/// `define_vec` makes the metatable of vectors, `open_vec` their constructor.
void define_vec(lua_State* L, Machine& machine);
void open_vec(lua_State* L);
void open_color(lua_State* L, Machine& machine);
void open_list(lua_State* L, Machine& machine);

}  // namespace fettle::script
