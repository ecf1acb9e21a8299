// Reading and writing of instances by scripts. A name is looked up in this order: declared
// property, method, function of a script's class, child, ad hoc property. The first two are in the
// dispatch table of the class. Numbers and vectors of declared properties are the most frequent, so
// they are tried first; the general path handles all other cases.

#include <fettle/property/path.h>
#include <fettle/property/reserved_names.h>

#include <classes/script_classes.h>
#include <handlers/formulas.h>
#include <lua/exception_guard.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <objects/generic_methods.h>
#include <objects/hints.h>
#include <objects/instance.h>
#include <objects/methods.h>
#include <other_languages/synonyms.h>
#include <reference/language.h>
#include <values/members.h>
#include <values/recording.h>
#include <values/short_text.h>
#include <values/values.h>
#include <writes/declarations.h>
#include <writes/degree_notes.h>
#include <writes/writes.h>

namespace fettle::script {

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

std::string path_of(const property::Tree& tree, Handle instance, std::string_view name) {
    return tree.path(instance) + property::path_suffix(name);
}

namespace {

// --- Names

// Looks up a name and stores the result in the class's dispatch table, if the name can be stored.
const Dispatch& look_up_and_store(lua_State* L, Machine& machine, DispatchTable& members,
                                  const void* key, std::string_view name) {
    // Lua has no unique address for longer names.
    static constexpr std::size_t longest_interned = 40;
    // A limit, since a script may use any number of names.
    static constexpr std::size_t max_dynamic_names = 4096;
    static thread_local Dispatch uncached;
    Dispatch found;
    found.key = key;
    const property::Symbol symbol = property::Symbol::find(name);
    const property::Method* method = nullptr;
    if (symbol) found.property = members.of.property(symbol);
    if (symbol && found.property == nullptr) method = members.of.method(symbol);
    if (method != nullptr)
        found.reference = method_reference(L, machine, *method);
    else if (found.property == nullptr)
        found.reference = generic_reference(L, machine, name);
    if (name.size() > longest_interned ||
        (found.is_dynamic() && ++machine.members.dynamic_names > max_dynamic_names)) {
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

/// The entry of the class for the name at 2, which must be a text.
const Dispatch& look_up(lua_State* L, Machine& machine, const InstanceBox& self) {
    const void* key = lua_topointer(L, 2);
    if (const Dispatch* known = self.members->find(key)) return *known;
    return look_up_and_store(L, machine, *self.members, key, view_at(L, 2));
}

/// The declared property with the name at 2, for the fast path. Returns nullptr if there is none,
/// if the name was not looked up before, or while a console command is recorded.
const Property* known_property(lua_State* L, const InstanceBox& self) {
    if (self.members->recording.active || self.members->recording.declaring) return nullptr;
    const Dispatch* found = self.members->find(lua_topointer(L, 2));
    return found != nullptr ? found->property : nullptr;
}

void require_name(lua_State* L, const property::Tree& tree, Handle instance) {
    if (lua_type(L, 2) != LUA_TSTRING)
        throw Error(ErrorKind::bad_name,
                    tree.path(instance) + ": a name is a text, not " + describe_type(L, 2));
}

[[noreturn]] void unknown_name(Machine& machine, Handle instance, std::string_view name) {
    const auto names = names_of(machine, instance);
    const std::string plain = without_get_or_set(name);
    std::vector<std::string_view> meant = {plain};
    for (const std::string_view word : {name, std::string_view(plain)})
        for (const std::string_view way : property_synonyms(word)) meant.push_back(way);
    std::string hint = hint_at(meant, name, names);
    if (hint.empty())
        if (const std::string child = machine.hints.child_with(instance, name); !child.empty())
            hint = "; " + child;
    if (hint.empty()) hint = machine.hints.of_command(path_of(machine.tree, instance, name));
    if (hint.empty() && machine.recording.active)
        if (const std::string path = machine.hints.path_of_instance(name); !path.empty())
            hint = hint_of(path);
    if (hint.empty())
        hint = "; " + machine.tree.path(instance) + ":has(\"" + std::string(name) +
               "\") asks whether there is one";
    throw Error(ErrorKind::unknown_name,
                path_of(machine.tree, instance, name) + ": no such name" + hint);
}

// --- Reading

/// Reads a number or a vector without creating a Value, if the tree supports it.
bool read_typed(lua_State* L, const property::Tree& tree, Handle instance,
                const Property& property) {
    // `read` would work here, too, but reading a number would take 10 % longer ("Lua: get
    // ball.mass" and "Lua: get ball.angular_velocity" of fettle-bench tree).
    if (property.shortcut.read == Property::Shortcut::Access::number) {
        const property::Row* row = tree.readable(instance);
        if (row == nullptr) return false;
        lua_pushnumber(L, property.binding.number.get(property.binding, *row));
        return true;
    }
    if (double number; property.type == Type::number && tree.read(instance, property, number)) {
        lua_pushnumber(L, number);
        return true;
    }
    if (Vec2 vector; property.type == Type::vec2 && tree.read(instance, property, vector)) {
        push_vec(L, vector, instance, property);
        return true;
    }
    return false;
}

int read_property(lua_State* L, Machine& machine, Handle instance, const Property& property) {
    if (machine.recording.active) machine.recording.last_read = &property;
    Origin origin;
    origin.instance = instance;
    origin.symbol = property.symbol;
    if (property.binding.kind != property::BindingKind::ad_hoc) origin.property = &property;
    const Value* seen = machine.declarations.seen(instance, property.name);
    push_value(L, seen != nullptr ? *seen : machine.tree.get(instance, property), origin);
    return 1;
}

/// The name and class of a deleted instance can still be read.
bool push_remains(lua_State* L, const property::Tree& tree, Handle instance) {
    if (tree.alive(instance) || lua_type(L, 2) != LUA_TSTRING) return false;
    const std::string_view key = view_at(L, 2);
    if (key != "name" && key != "class") return false;
    const auto remains = tree.deleted_info(instance);
    if (remains) push_text(L, key == "name" ? remains->name : remains->of.name());
    return remains.has_value();
}

int read_slowly(lua_State* L, Machine& machine, const InstanceBox& self) {
    const Handle instance = self.handle;
    if (push_remains(L, machine.tree, instance)) return 1;
    const bool named = lua_type(L, 2) == LUA_TSTRING;
    // Methods check for a deleted instance themselves, and `alive` works on one.
    if (named && look_up(L, machine, self).is_function()) {
        push_registry(L, look_up(L, machine, self).reference);
        return 1;
    }
    machine.tree.require(instance);
    if (refresh_class(machine, self)) return read_slowly(L, machine, self);
    if (lua_isinteger(L, 2)) {
        const lua_Integer n = lua_tointeger(L, 2);
        push_instance(
            L, n < 1 ? Handle{} : machine.tree.nth_child(instance, static_cast<std::uint64_t>(n)));
        return 1;
    }
    require_name(L, machine.tree, instance);
    if (const Property* declared = look_up(L, machine, self).property)
        return read_property(L, machine, instance, *declared);
    if (machine.classes.push_function(L, self.members->of, 2)) return 1;
    const std::string_view name = view_at(L, 2);
    if (const Handle child = child_of(machine, instance, name)) {
        push_instance(L, child);
        return 1;
    }
    if (const Property* added = machine.tree.find(instance, name);
        added != nullptr && !machine.declarations.hides(instance, name))
        return read_property(L, machine, instance, *added);
    if (const Value* seen = machine.declarations.seen(instance, name)) {
        push_value(L, *seen);
        return 1;
    }
    unknown_name(machine, instance, name);
}

int instances_equal(lua_State* L) {
    const auto* a = instance_at(L, 1);
    const auto* b = instance_at(L, 2);
    lua_pushboolean(L, a != nullptr && b != nullptr && a->handle == b->handle);
    return 1;
}

// Scripts cannot access this function or `instance_newindex`, so argument 1 is always an instance.
int instance_index(lua_State* L) {
    const auto& self = *static_cast<const InstanceBox*>(lua_touserdata(L, 1));
    const Property* property = known_property(L, self);
    if (property != nullptr && read_typed(L, self.members->tree, self.handle, *property)) return 1;
    return read_slowly(L, machine_of(L), self);
}

// --- Writing

/// Writes a number to a number or a vector to a vector without creating a Value, if the tree
/// supports it.
bool write_typed(lua_State* L, property::Tree& tree, Handle instance, const Property& property) {
    if (property.type == Type::number && lua_type(L, 3) == LUA_TNUMBER) {
        const double value = lua_tonumber(L, 3);
        return !looks_like_degrees(property, value) && tree.write(instance, property, value);
    }
    const VecBox* vec = property.type == Type::vec2 ? vec_at(L, 3) : nullptr;
    return vec != nullptr && tree.write(instance, property, Vec2(vec->x, vec->y));
}

void write_declared(lua_State* L, Machine& machine, Handle instance, const Property& property) {
    if (lua_isnil(L, 3)) return clear_property(machine, instance, property);
    if (is_formula(L, 3)) return define_formula(L, machine, 3, instance, property.name);
    const Value value = to_value(L, 3, [&] { return machine.tree.path(instance, property); });
    machine.classes.explain_integer(property, value);
    machine.classes.require_known_state(instance, property, value);
    assign_property(machine, instance, property, value);
}

int write_slowly(lua_State* L, Machine& machine, const InstanceBox& self) {
    machine.tree.require(self.handle);
    refresh_class(machine, self);
    require_name(L, machine.tree, self.handle);
    if (const Property* declared = look_up(L, machine, self).property)
        write_declared(L, machine, self.handle, *declared);
    else
        write_member(L, machine, self.handle, self.members->of, view_at(L, 2));
    return 0;
}

int instance_newindex(lua_State* L) {
    const auto& self = *static_cast<const InstanceBox*>(lua_touserdata(L, 1));
    const Property* property = self.members->recording.noting() ? nullptr : known_property(L, self);
    if (property != nullptr && write_typed(L, self.members->tree, self.handle, *property)) return 0;
    return write_slowly(L, machine_of(L), self);
}

// --- The other metamethods

int instance_tostring(lua_State* L) {
    const auto* self = instance_at(L, 1);
    if (!self) refuse_type(L, 1, "needs an instance");
    push_text(L, short_text(L, 1));
    return 1;
}

int instance_length(lua_State* L) {
    const Handle self = check_instance(L, 1, "#");
    lua_pushinteger(L, static_cast<lua_Integer>(machine_of(L).tree.child_count(self)));
    return 1;
}

// Iterates over a list made at the start: properties in the order of the class, ad hoc properties,
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
        lua_pop(L, 1);  // it was removed meanwhile
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
        push_text(L, name);
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
    property::reserve_names(machine.tree, generic_names());
    // The table is larger than necessary: Lua looks up `__index` and `__newindex` for each use of
    // an instance, and a full table would need more probes.
    lua_createtable(L, 0, 256);
    add_pure<instance_index>(L, "__index");
    add_pure<instance_newindex>(L, "__newindex");
    add_pure<instance_tostring>(L, "__tostring");
    add_pure<instance_length>(L, "__len");
    add_pure<instance_pairs>(L, "__pairs");
    // After a reload, an instance may have two proxies: one in new code and one in old functions.
    add_pure<instances_equal>(L, "__eq");
    name_metatable(L, "instance");
    machine.boxes.instance = luaL_ref(L, LUA_REGISTRYINDEX);

    push_weak_table(L, "v");
    machine.boxes.proxies = luaL_ref(L, LUA_REGISTRYINDEX);
}

}  // namespace fettle::script
