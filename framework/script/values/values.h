#pragma once
// Values of the tree as Lua sees them, and back. Every userdata a script can hold starts with a
// tag, so that a wrong `self` is told apart without a lookup.

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

/// References in Lua's registry: the metatables of the kinds of values, and all instances known.
struct Boxes {
    int vec = 0, color = 0, list = 0, instance = 0, set = 0, class_object = 0;
    int record = 0, connection = 0, snapshot = 0, description = 0;
    int proxies = 0;  // weak table: handle -> userdata
};

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
    description
};

/// A handle as one number, for sets of them.
inline std::uint64_t bits_of(property::Handle handle) {
    return std::uint64_t{handle.generation} << 32 | handle.index;
}

/// Where a value was read: a property, or a place inside a list that is its value. Assigning a
/// component writes back there. Ad-hoc properties come and go, so they are kept by name.
struct Origin {
    static constexpr std::uint32_t deepest = 4;
    property::Handle instance;
    const property::Property* property = nullptr;  // nullptr: look `symbol` up
    property::Symbol symbol;
    std::uint32_t depth = 0;  // how many of `part` hold
    std::uint32_t part[deepest] = {};
};

struct InstanceBox {
    Tag tag;
    property::Handle handle;
    mutable DispatchTable* members;  // of its class, as far as is known: see `refresh_class`
};

struct VecBox {
    Tag tag;
    bool has_origin;
    double x, y;
    Origin origin;  // exists only when has_origin
};

struct ColorBox {
    Tag tag;
    bool has_origin;
    property::Color color;
    Origin origin;  // exists only when has_origin
};

struct ListBox {
    Tag tag;
    Origin origin;
};

struct ClassBox {
    Tag tag;
    const property::Class* of;
};

/// Updates the class of a living instance, which may differ from that of its proxy: in a saved game
/// another instance may use its slot, and the class of a deleted instance was not known. Returns
/// whether it differed.
bool refresh_class(Machine& machine, const InstanceBox& box);
/// Of all there are, after a restore. Throws nothing.
void refresh_classes(Machine& machine);

/// The box at `index` when it is one of that kind, else nullptr.
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

/// The class a class object at `index` stands for, else nullptr.
inline const property::Class* class_object_at(lua_State* L, int index) {
    const auto* box = box_at<ClassBox>(L, index, Tag::class_object);
    return box ? box->of : nullptr;
}

/// The instance at `index`, alive; else an error that names `what`.
property::Handle check_instance(lua_State* L, int index, const char* what);
property::Vec2 check_vec(lua_State* L, int index, const char* what);
property::Color check_color(lua_State* L, int index, const char* what);
/// The text at `index`; else an error: "on: needs the name of an event, not a number".
std::string check_text(lua_State* L, int index, std::string_view needed);
double check_number(lua_State* L, int index, const char* what);
/// The time that is argument 1: finite and not negative.
double check_seconds(lua_State* L, const char* what);
void check_function(lua_State* L, int index, const char* what);
/// The `__index` of a kind of values whose metatable has `methods`: pushes the one whose name is at
/// 2. Throws for any other: "a vec has no lenght (did you mean ...)"; `fields`: names besides.
int push_method(lua_State* L, const std::string& noun, std::vector<std::string> fields = {});
/// Throws Error(wrong_type): what is needed, "not a number".
[[noreturn]] void refuse_type(lua_State* L, int index, std::string_view needed);

void push_vec(lua_State* L, const property::Vec2& v);
void push_vec(lua_State* L, const property::Vec2& v, const Origin& origin);
/// As read from a property: what scripts do most with vectors.
void push_vec(lua_State* L, const property::Vec2& v, property::Handle instance,
              const property::Property& property);
void push_color(lua_State* L, property::Color color);
void push_color(lua_State* L, property::Color color, const Origin& origin);
/// The one proxy of the instance; nil for the null handle.
void push_instance(lua_State* L, property::Handle handle);
/// A value that comes from no property: lists become plain tables.
void push_value(lua_State* L, const property::Value& value);
/// A value read from a property: vectors, colors and lists remember where.
void push_value(lua_State* L, const property::Value& value, const Origin& origin);

/// Throws property::Error(wrong_type) for what cannot be a value (a function, a table with named
/// keys).
property::Value to_value(lua_State* L, int index);
/// The same; its errors begin with what `where()` gives: the path of a property.
template <class Where>
property::Value to_value(lua_State* L, int index, Where where) {
    try {
        return to_value(L, index);
    } catch (const property::Error& error) {
        throw property::Error(error.kind(), where() + ": " + error.what());
    }
}
/// What a value of Lua is called in messages: "a number", "a Body", "a table".
std::string describe_type(lua_State* L, int index);

/// The property an origin names; throws when the instance is deleted or has it no longer.
const property::Property& origin_property(const property::Tree& tree, const Origin& origin);
/// What is there now.
property::Value origin_read(Machine& machine, const Origin& origin);
/// Reads the whole property, replaces that part (or its component) and writes it: one change.
void origin_write(Machine& machine, const Origin& origin, const char* component,
                  const property::Value& value);
/// "world.ball.vertices[2]"
std::string origin_path(const property::Tree& tree, const Origin& origin);

/// The list that a property, or a place in it, has now; and another in its place.
property::Value list_value(lua_State* L, const ListBox& box);
void write_list(lua_State* L, const ListBox& box, const property::List& list);

/// The metatable of vectors, then what makes one.
void define_vec(lua_State* L, Machine& machine);
void open_vec(lua_State* L);
void open_color(lua_State* L, Machine& machine);
void open_list(lua_State* L, Machine& machine);

}  // namespace fettle::script
