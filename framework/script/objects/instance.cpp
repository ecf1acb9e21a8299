// Reading and writing an instance from a script. The order in which a name is looked up: declared
// property, method, function of a script's class, child, ad-hoc property. The first two are found
// in one probe of the class's dispatch table; this is the hot path of every game.

#include <algorithm>
#include <cmath>

#include <fettle/property/path.h>
#include <fettle/property/spelling.h>

#include <handlers/formulas.h>
#include <lua/guard.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <objects/generic_methods.h>
#include <objects/instance.h>
#include <objects/methods.h>
#include <objects/script_classes.h>
#include <reference/language.h>
#include <text/synonyms.h>
#include <values/members.h>
#include <values/recording.h>
#include <values/values.h>
#include <values/writes.h>

namespace fettle::script {

using property::Put;
using property::Row;
using property::Symbol;

std::vector<std::string> names_of(Machine& machine, Handle instance) {
    std::vector<std::string> names = machine.tree.class_of(instance).member_names();
    for (const Property* p : machine.tree.ad_hoc(instance)) names.push_back(p->name);
    for (Handle child = machine.tree.first_child(instance); child;
         child = machine.tree.next_sibling(child))
        names.push_back(machine.tree.name(child));
    machine.classes.add_function_names(machine.tree.class_of(instance), names);
    for (const std::string& name : generic_names()) names.push_back(name);
    return names;
}

namespace {

// --- Reading

[[noreturn]] void unknown_name(Machine& machine, Handle instance, std::string_view name) {
    const auto names = names_of(machine, instance);
    std::string hint = property::suggestion(name, names);
    if (hint.empty())
        for (const std::string_view way : property_synonyms(name))
            if (hint.empty() &&
                std::find(names.begin(), names.end(), way.substr(0, way.find(' '))) != names.end())
                hint = " (did you mean \"" + std::string(way.substr(0, way.find(' '))) + "\"?)";
    throw Error(ErrorKind::unknown_name, machine.tree.path(instance) + property::path_suffix(name) +
                                             ": no such name" + hint);
}

[[gnu::noinline]] void push_other(lua_State* L, const Value& value, Handle instance,
                                  const Property& property) {
    const bool ad_hoc = property.binding.kind == property::BindingKind::ad_hoc;
    Origin origin;
    origin.instance = instance;
    if (ad_hoc)
        origin.symbol = property.symbol;
    else
        origin.property = &property;
    push_value(L, value, origin);
}

void push_property(lua_State* L, Machine& machine, Handle instance, const Property& property) {
    const Value value = machine.tree.get(instance, property);
    switch (value.type()) {
        case Type::number:
            lua_pushnumber(L, value.number());
            return;
        case Type::integer:
            lua_pushinteger(L, value.integer());
            return;
        case Type::boolean:
            lua_pushboolean(L, value.boolean());
            return;
        default:
            break;
    }
    push_other(L, value, instance, property);
}

// Which way a declared property is read and written.
Member member_for(const Property& property) {
    using Way = Property::Shortcut::Way;
    switch (property.shortcut.read) {
        case Way::none:
            return Member::property;
        case Way::number:
            return Member::number;
        case Way::stored_number:
            return Member::kept_number;
        default:
            return Member::vec2;
    }
}

bool is_number(Member member) {
    return member == Member::number || member == Member::kept_number;
}

// Names found once are remembered for the class; how they are remembered is what they are.
const Dispatch& learn(lua_State* L, Machine& machine, DispatchTable& members, const void* key,
                      std::string_view name) {
    static constexpr std::size_t longest_interned = 40;  // longer names of Lua have no one address
    static constexpr std::size_t most_dynamic_names = 4096;  // a script may make up names forever
    static thread_local Dispatch uncached;
    Dispatch found;
    found.key = key;
    const Class& of = members.of;
    const Symbol symbol = Symbol::find(name);
    if (const Property* property = symbol ? of.property(symbol) : nullptr) {
        found.member = member_for(*property);
        found.property = property;
    } else if (const property::Method* method = symbol ? of.method(symbol) : nullptr) {
        found.member = Member::function;
        found.reference = method_reference(L, machine, *method);
    } else if (const int generic = generic_reference(L, machine, name); generic != LUA_NOREF) {
        found.member = Member::function;
        found.reference = generic;
    } else {
        found.member = Member::dynamic;
    }
    if (name.size() > longest_interned ||
        (found.member == Member::dynamic && ++machine.members.dynamic_names > most_dynamic_names)) {
        uncached = found;
        return uncached;
    }
    push_registry(L, machine.members.anchors);
    lua_pushvalue(L, 2);
    lua_pushboolean(L, 1);
    lua_rawset(L, -3);
    lua_pop(L, 1);
    return members.add(found);
}

const Dispatch& look_up(lua_State* L, Machine& machine, DispatchTable& members) {
    const void* key = lua_topointer(L, 2);
    if (const Dispatch* known = members.find(key)) return *known;
    std::size_t length = 0;
    const char* name = lua_tolstring(L, 2, &length);
    return learn(L, machine, members, key, {name, length});
}

/// What was deleted still tells what it was called and of which class it was.
bool push_remains(lua_State* L, Machine& machine, Handle instance) {
    if (machine.tree.alive(instance) || lua_type(L, 2) != LUA_TSTRING) return false;
    const std::string_view key = lua_tostring(L, 2);
    if (key != "name" && key != "class") return false;
    const auto remains = machine.tree.remains(instance);
    if (!remains) return false;
    lua_pushstring(L, key == "name" ? remains->name.c_str() : remains->of.name().c_str());
    return true;
}

[[gnu::noinline]] int read_slowly(lua_State* L, Machine& machine, const InstanceBox& self) {
    const Handle instance = self.handle;
    if (push_remains(L, machine, instance)) return 1;
    if (lua_type(L, 2) == LUA_TSTRING) {
        // A method tells itself what a deleted instance cannot do; `alive` can be asked.
        const Dispatch& found = look_up(L, machine, *self.members);
        if (found.member == Member::function) {
            push_registry(L, found.reference);
            return 1;
        }
    }
    machine.tree.require(instance);
    if (refresh_class(machine, self)) return read_slowly(L, machine, self);
    if (lua_isinteger(L, 2)) {
        const lua_Integer n = lua_tointeger(L, 2);
        push_instance(
            L, n < 1 ? Handle{} : machine.tree.nth_child(instance, static_cast<std::uint64_t>(n)));
        return 1;
    }
    if (lua_type(L, 2) != LUA_TSTRING)
        throw Error(ErrorKind::bad_name,
                    machine.tree.path(instance) + ": a name is a text, not " + describe_type(L, 2));
    const Dispatch& found = look_up(L, machine, *self.members);
    std::size_t length = 0;
    const char* key = lua_tolstring(L, 2, &length);
    const std::string_view name(key, length);
    if (found.is_property()) {
        if (machine.recording.active) machine.recording.last_read = found.property;
        push_property(L, machine, instance, *found.property);
        return 1;
    }
    if (machine.classes.push_function(L, self.members->of)) return 1;
    if (const Handle child = machine.tree.child(instance, name)) {
        push_instance(L, child);
        return 1;
    }
    if (const Property* property = machine.tree.find(instance, name)) {
        if (machine.recording.active) machine.recording.last_read = property;
        push_property(L, machine, instance, *property);
        return 1;
    }
    unknown_name(machine, instance, name);
}

[[noreturn, gnu::noinline]] void no_self(lua_State* L) {
    throw Error(ErrorKind::wrong_type, "needs an instance, not " + describe_type(L, 1));
}

/// A declared property that is none of the common, or another member.
[[gnu::noinline]] int read_at_length(lua_State* L, const InstanceBox& self) {
    Machine& machine = machine_of(L);
    const Dispatch* known = self.members->find(lua_topointer(L, 2));
    if (known == nullptr || !known->is_property() || machine.recording.active ||
        !machine.tree.alive(self.handle))
        return read_slowly(L, machine, self);
    push_property(L, machine, self.handle, *known->property);
    return 1;
}

/// A vector or a number, if it can be read without a Value in between.
int read_typed(lua_State* L, const InstanceBox& self, Member member, const Property* property) {
    const property::Tree& tree = self.members->tree;
    if (Vec2 vector; member == Member::vec2 && tree.read(self.handle, *property, vector)) {
        push_vec(L, vector, self.handle, *property);
        return 1;
    }
    if (double number; is_number(member) && tree.read(self.handle, *property, number)) {
        lua_pushnumber(L, number);
        return 1;
    }
    return read_at_length(L, self);
}

/// Of a name that does not stand where it is looked for first, or nowhere yet.
int read_displaced(lua_State* L, const InstanceBox& self) {
    const Dispatch* known = self.members->find(lua_topointer(L, 2));
    if (known == nullptr || machine_of(L).recording.active) return read_at_length(L, self);
    return read_typed(L, self, known->member, known->property);
}

/// What a short way goes on to, in a function of its own that catches exceptions: one that catches
/// none can end with a jump to it.
template <auto function, class... Given>
[[gnu::noinline]] int go_on(lua_State* L, const InstanceBox& self, Given... given) {
    return guard(L, [&] { return function(L, self, given...); });
}

// Kept short, as `instance_newindex` is: what is not a number goes elsewhere. Scripts cannot get at
// either function, so Lua calls them with an instance. While a console command is being noted down,
// no name stands where it is looked for first.
int instance_index(lua_State* L) {
    const auto* self = static_cast<const InstanceBox*>(lua_touserdata(L, 1));
    const void* key = lua_topointer(L, 2);
    const DispatchTable& members = *self->members;
    const Dispatch& found = members.at(key);
    if (found.key != key) [[unlikely]]
        return go_on<read_displaced>(L, *self);
    if (found.member != Member::number)
        return go_on<read_typed>(L, *self, found.member, found.property);
    const Row* row = members.tree.readable(self->handle);
    if (row == nullptr) [[unlikely]]
        return go_on<read_at_length>(L, *self);
    const property::Binding& binding = found.property->binding;
    lua_pushnumber(L, guard(L, [&] { return binding.number.get(binding, *row); }));
    return 1;
}

// --- Writing

// Integers up to this are the same number as a float: 2^24.
constexpr lua_Integer exact_in_float = 16'777'216;

// A number, boolean or vec straight from the stack; false for anything that needs thought. Each
// value is made where it is handed over: a copy of one just made stalls on its half-written bytes.
bool write_simple(lua_State* L, Machine& machine, Handle instance, const Property& property) {
    switch (lua_type(L, 3)) {
        case LUA_TNUMBER:
            if (lua_isinteger(L, 3)) {
                const lua_Integer whole = lua_tointeger(L, 3);
                if (property.type == Type::number && whole >= -exact_in_float &&
                    whole <= exact_in_float) {
                    machine.tree.set(instance, property, Value(static_cast<double>(whole)));
                    return true;
                }
                machine.tree.set(instance, property,
                                 Value(static_cast<std::int64_t>(lua_tointeger(L, 3))));
            } else {
                if (property.type == Type::integer) return false;  // may need an explanation
                machine.tree.set(instance, property,
                                 Value(static_cast<double>(lua_tonumber(L, 3))));
            }
            return true;
        case LUA_TBOOLEAN:
            machine.tree.set(instance, property, Value(lua_toboolean(L, 3) != 0));
            return true;
        case LUA_TUSERDATA: {
            const auto* box = static_cast<const VecBox*>(lua_touserdata(L, 3));
            if (box->tag != Tag::vec) return false;
            machine.tree.set(instance, property, Value(Vec2(box->x, box->y)));
            return true;
        }
        default:
            return false;
    }
}

void write_declared(lua_State* L, Machine& machine, Handle instance, const Property& property) {
    if (lua_isnil(L, 3)) {
        clear_property(machine, instance, property);
        return;
    }
    if (is_formula(L, 3)) {
        define_formula(L, machine, 3, instance, property.name);
        return;
    }
    Value value;
    try {
        value = to_value(L, 3);
    } catch (const Error& error) {
        throw Error(error.kind(), machine.tree.path(instance, property) + ": " + error.what());
    }
    machine.classes.explain_integer(property, value);
    write_property(machine, instance, property, value);
}

[[gnu::noinline]] int write_slowly(lua_State* L, Machine& machine, const InstanceBox& self) {
    const Handle instance = self.handle;
    machine.tree.require(instance);
    refresh_class(machine, self);
    if (lua_type(L, 2) != LUA_TSTRING)
        throw Error(ErrorKind::bad_name,
                    machine.tree.path(instance) + ": a name is a text, not " + describe_type(L, 2));
    const Dispatch& found = look_up(L, machine, *self.members);
    std::size_t length = 0;
    const char* key = lua_tolstring(L, 2, &length);
    const std::string_view name(key, length);
    if (found.is_property())
        write_declared(L, machine, instance, *found.property);
    else
        write_member(L, machine, instance, self.members->of, name);
    return 0;
}

/// A declared property whose value is none of the common, or another member.
[[gnu::noinline]] int write_at_length(lua_State* L, const InstanceBox& self) {
    Machine& machine = machine_of(L);
    const Dispatch* known = self.members->find(lua_topointer(L, 2));
    if (known != nullptr && known->is_property() && !machine.recording.active &&
        write_simple(L, machine, self.handle, *known->property))
        return 0;
    return write_slowly(L, machine, self);
}

/// Not a number to a property of numbers, or of a name that does not stand where it is looked for
/// first.
int write_typed(lua_State* L, const InstanceBox& self) {
    property::Tree& tree = self.members->tree;
    const Dispatch* known = self.members->find(lua_topointer(L, 2));
    if (known != nullptr && known->member == Member::vec2) {
        const auto* box = static_cast<const VecBox*>(lua_touserdata(L, 3));
        if (box != nullptr && box->tag == Tag::vec &&
            tree.write(self.handle, *known->property, Vec2(box->x, box->y)))
            return 0;
    } else if (known != nullptr && is_number(known->member) && lua_type(L, 3) == LUA_TNUMBER) {
        if (tree.write(self.handle, *known->property, static_cast<double>(lua_tonumber(L, 3))))
            return 0;
    }
    return write_at_length(L, self);
}

int end_write(lua_State* L, const InstanceBox& self, const Property* property, Put begun) {
    const auto number = static_cast<double>(lua_tonumber(L, 3));
    const bool written = self.members->tree.end_write(begun, self.handle, *property, number);
    return written ? 0 : write_at_length(L, self);
}

// Kept short: what is not a number written to a number goes elsewhere, and what is no number can
// never be written this way. The value comes last, so that it need not be kept over a call.
int instance_newindex(lua_State* L) {
    const auto* self = static_cast<const InstanceBox*>(lua_touserdata(L, 1));
    const void* key = lua_topointer(L, 2);
    const Dispatch& found = self->members->at(key);
    if (found.key != key) [[unlikely]]
        return go_on<write_typed>(L, *self);
    const Property& property = *found.property;
    if (lua_type(L, 3) != LUA_TNUMBER) [[unlikely]]
        return go_on<write_typed>(L, *self);
    const auto number = static_cast<double>(lua_tonumber(L, 3));
    const Put begun = self->members->tree.begin_write(self->handle, property, number);
    if (begun != Put::done) [[unlikely]]
        return go_on<end_write>(L, *self, &property, begun);
    return 0;
}

// --- The other metamethods

int instance_tostring(lua_State* L) {
    const auto* self = instance_at(L, 1);
    if (!self) no_self(L);
    Machine& machine = machine_of(L);
    std::string text;
    try {
        machine.tree.require(self->handle);
        text = machine.tree.path(self->handle);
    } catch (const Error& error) {
        text = std::string("(") + error.what() + ")";
    }
    lua_pushlstring(L, text.data(), text.size());
    return 1;
}

int instance_length(lua_State* L) {
    const Handle self = check_instance(L, 1, "#");
    lua_pushinteger(L, static_cast<lua_Integer>(machine_of(L).tree.child_count(self)));
    return 1;
}

// Iteration visits a list made at its start: properties in the order of the class, ad-hoc ones,
// then children.
int next_member(lua_State* L) {
    Machine& machine = machine_of(L);
    const Handle self = check_instance(L, lua_upvalueindex(3), "pairs");
    for (;;) {
        const lua_Integer index = lua_tointeger(L, lua_upvalueindex(2)) + 1;
        lua_pushinteger(L, index);
        lua_replace(L, lua_upvalueindex(2));
        if (lua_rawgeti(L, lua_upvalueindex(1), index) == LUA_TNIL) return 1;
        const std::string name = string_at(L, -1);
        if (machine.tree.find(self, name) || machine.tree.child(self, name)) break;
        lua_pop(L, 1);  // gone since
    }
    lua_pushvalue(L, -1);
    lua_gettable(L, lua_upvalueindex(3));
    return 2;
}

int instance_pairs(lua_State* L) {
    const Handle self = check_instance(L, 1, "pairs");
    Machine& machine = machine_of(L);
    lua_newtable(L);
    lua_Integer n = 0;
    const auto add = [&](const std::string& name) {
        lua_pushlstring(L, name.data(), name.size());
        lua_rawseti(L, -2, ++n);
    };
    for (const Property* property : machine.tree.properties(self)) add(property->name);
    for (Handle child = machine.tree.first_child(self); child;
         child = machine.tree.next_sibling(child))
        add(machine.tree.name(child));
    lua_pushinteger(L, 0);
    lua_pushvalue(L, 1);
    lua_pushcclosure(L, guarded<next_member>, 3);
    return 1;
}

}  // namespace

void open_instance(lua_State* L, Machine& machine) {
    // Roomier than it need be: Lua looks `__index` and `__newindex` up at each use of an instance,
    // and in a full table they may stand behind others.
    lua_createtable(L, 0, 256);
    lua_pushcfunction(L, instance_index);  // no closure: Lua gets to plain functions first
    lua_setfield(L, -2, "__index");
    lua_pushcfunction(L, instance_newindex);
    lua_setfield(L, -2, "__newindex");
    add_pure<instance_tostring>(L, "__tostring");
    add_pure<instance_length>(L, "__len");
    add_pure<instance_pairs>(L, "__pairs");
    name_metatable(L, "instance");
    machine.boxes.instance = luaL_ref(L, LUA_REGISTRYINDEX);

    lua_newtable(L);
    lua_newtable(L);
    lua_pushstring(L, "v");
    lua_setfield(L, -2, "__mode");
    lua_setmetatable(L, -2);
    machine.boxes.proxies = luaL_ref(L, LUA_REGISTRYINDEX);
}

}  // namespace fettle::script
