#include <unordered_map>
#include <utility>

#include <classes/class_definition.h>
#include <classes/own_events.h>
#include <classes/reflection.h>
#include <classes/unplaced_instances.h>
#include <handlers/formulas.h>
#include <handlers/subscriptions.h>
#include <handlers/timers.h>
#include <lua/exception_guard.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <motion/tweens.h>
#include <objects/generic_methods.h>
#include <objects/instance_set.h>
#include <other_languages/foreign_classes.h>
#include <values/members.h>
#include <values/values.h>
#include <writes/declarations.h>
#include <writes/writes.h>

namespace fettle::script {

namespace {

// The class at `index`, given as an object or by name; nullptr for nil or none.
const Class* class_at(lua_State* L, const property::Tree& tree, int index, const char* what) {
    if (lua_isnoneornil(L, index)) return nullptr;
    if (const Class* found = class_object_at(L, index)) return found;
    if (lua_type(L, index) == LUA_TSTRING) return &class_called(tree, string_at(L, index));
    refuse_type(L, index, std::string(what) + ": needs a class or its name");
}

std::string text_at(lua_State* L, int index, const char* what) {
    return check_text(L, index, std::string(what) + ": needs a text");
}

/// Parents before their children, as the top level of the game sees them.
std::vector<Handle> below(const Machine& machine, Handle top, const Class* of) {
    std::vector<Handle> found;
    const auto add = [&](Handle handle) {
        if (!of || machine.tree.class_of(handle).is_a(*of)) found.push_back(handle);
    };
    if (!machine.declarations.reloading()) {
        machine.tree.each_below(top, [&](Handle handle) {
            if (handle != top) add(handle);
        });
        return found;
    }
    const auto add_below = [&](const auto& self, Handle parent) -> void {
        for (const Handle child : machine.declarations.children(parent)) {
            add(child);
            self(self, child);
        }
    };
    add_below(add_below, top);
    return found;
}

int delete_instance(lua_State* L) {
    const Handle self = check_instance(L, 1, "delete");
    Machine& machine = machine_of(L);
    if (self == machine.tree.root())
        throw Error(ErrorKind::bad_structure, "game: cannot be deleted");
    destroy(machine, self);
    return 0;
}

int has(lua_State* L) {
    const Handle self = check_instance(L, 1, "has");
    Machine& machine = machine_of(L);
    const std::string name = text_at(L, 2, "has");
    const Declarations& declarations = machine.declarations;
    lua_pushboolean(L,
                    (machine.tree.find(self, name) != nullptr && !declarations.hides(self, name)) ||
                        child_of(machine, self, name) || declarations.seen(self, name) != nullptr);
    return 1;
}

const Property& property_at(lua_State* L, Machine& machine, Handle self, const char* what) {
    return machine.tree.property(self, text_at(L, 2, what));
}

int problem(lua_State* L) {
    const Handle self = check_instance(L, 1, "problem");
    Machine& machine = machine_of(L);
    const std::string text = machine.tree.problem(self, property_at(L, machine, self, "problem"));
    if (text.empty())
        lua_pushnil(L);
    else
        push_text(L, text);
    return 1;
}

int formula_of(lua_State* L) {
    const Handle self = check_instance(L, 1, "formula");
    if (lua_gettop(L) > 2)
        throw Error(ErrorKind::wrong_type,
                    "formula: takes only the name of a property, whose formula it returns; to give "
                    "it one, assign formula(function() return ... end) to the property");
    Machine& machine = machine_of(L);
    push_formula_function(L, machine.tree, self, property_at(L, machine, self, "formula"));
    return 1;
}

int alive(lua_State* L) {
    const auto* box = instance_at(L, 1);
    if (!box) check_instance(L, 1, "alive");
    lua_pushboolean(L, machine_of(L).tree.alive(box->handle));
    return 1;
}

// A deleted instance still has its class, because an event may contain it.
int is_a(lua_State* L) {
    Machine& machine = machine_of(L);
    const auto* box = instance_at(L, 1);
    const auto remains = box ? machine.tree.deleted_info(box->handle) : std::nullopt;
    const Class& is = remains ? remains->of : machine.tree.class_of(check_instance(L, 1, "is_a"));
    const Class* of = class_at(L, machine.tree, 2, "is_a");
    if (!of) throw Error(ErrorKind::wrong_type, "is_a: needs a class or its name");
    lua_pushboolean(L, is.is_a(*of));
    return 1;
}

int add(lua_State* L) {
    const Handle self = check_instance(L, 1, "add");
    if (instance_at(L, 2) == nullptr && instance_at(L, 3) != nullptr)
        refuse_type(L, 2, "add: needs an instance, and its name after it");
    const Handle child = check_instance(L, 2, "add");
    Machine& machine = machine_of(L);
    if (machine.tree.parent(child) || child == machine.tree.root())
        throw Error(ErrorKind::bad_structure,
                    machine.tree.path(child) + ": has its place already; use :move(parent)");
    place(machine, child, self, lua_isnoneornil(L, 3) ? std::string() : text_at(L, 3, "add"));
    lua_settop(L, 2);
    return 1;
}

int move_instance(lua_State* L) {
    const Handle self = check_instance(L, 1, "move");
    Machine& machine = machine_of(L);
    const Handle parent = lua_isnoneornil(L, 2) ? Handle{} : check_instance(L, 2, "move");
    if (self == machine.tree.root()) throw Error(ErrorKind::bad_structure, "game: cannot be moved");
    lua_settop(L, 3);
    if (machine.declarations.reloading()) {
        if (parent && !machine.declarations.defers(self))
            place(machine, self, parent, lua_isnil(L, 3) ? std::string() : text_at(L, 3, "move"));
        lua_settop(L, 1);
        return 1;
    }
    machine.tree.move(self, parent, lua_isnoneornil(L, 3) ? std::string() : text_at(L, 3, "move"));
    if (!parent) machine.unplaced.handles.push_back(self);
    lua_settop(L, 1);
    return 1;
}

int children(lua_State* L) {
    const Handle self = check_instance(L, 1, "children");
    Machine& machine = machine_of(L);
    const Class* of = class_at(L, machine.tree, 2, "children");
    std::vector<Handle> found = machine.declarations.children(self);
    if (of) std::erase_if(found, [&](Handle h) { return !machine.tree.class_of(h).is_a(*of); });
    push_set(L, found);
    return 1;
}

int all(lua_State* L) {
    const Handle self = check_instance(L, 1, "all");
    Machine& machine = machine_of(L);
    push_set(L, below(machine, self, class_at(L, machine.tree, 2, "all")));
    return 1;
}

int find_below(lua_State* L) {
    const Handle self = check_instance(L, 1, "find");
    Machine& machine = machine_of(L);
    lua_settop(L, 3);
    const bool filtered = !lua_isnil(L, 3);
    if (filtered) check_function(L, 3, "find");
    const std::vector<Handle> all_found =
        below(machine, self, class_at(L, machine.tree, 2, "find"));
    std::vector<Handle> found;
    for (const Handle handle : all_found) {
        if (filtered) {
            if (!machine.tree.alive(handle)) continue;
            lua_pushvalue(L, 3);
            push_instance(L, handle);
            lua_call(L, 1, 1);
            const bool wanted = lua_toboolean(L, -1) != 0;
            lua_pop(L, 1);
            if (!wanted) continue;
        }
        found.push_back(handle);
    }
    push_set(L, found);
    return 1;
}

int each(lua_State* L) {
    const Handle self = check_instance(L, 1, "each");
    Machine& machine = machine_of(L);
    const int function = lua_gettop(L);
    check_function(L, function, "each");
    const Class* of = function > 2 ? class_at(L, machine.tree, 2, "each") : nullptr;
    for (const Handle handle : below(machine, self, of)) {
        if (!machine.tree.alive(handle)) continue;
        lua_pushvalue(L, function);
        push_instance(L, handle);
        lua_call(L, 1, 0);
    }
    return 0;
}

// --- Copies

struct Copies {
    std::vector<std::pair<Handle, Handle>> in_order;
    std::unordered_map<std::uint64_t, Handle> of;

    void add(Handle from, Handle to) {
        in_order.emplace_back(from, to);
        of.emplace(from.key(), to);
    }
};

void require_creatable(const property::Tree& tree, Handle original) {
    const Class& of = tree.class_of(original);
    if (of.creatable()) return;
    throw Error(ErrorKind::bad_structure,
                tree.path(original) + ": cannot be cloned; " + why_not_creatable(tree, of));
}

Handle copy_of(property::Tree& tree, Handle original, Handle parent) {
    const Class& of = tree.class_of(original);
    const std::string name = tree.name(original);
    // A child that the copy's class has created itself (the statistics of a world) is used as the
    // copy.
    const Handle own = tree.child(parent, name);
    if (own && &tree.class_of(own) == &of) return own;
    require_creatable(tree, original);
    return tree.create(of, parent, name);
}

// Copies parents first and siblings in order; without recursion, so the depth is not limited.
void copy_below(property::Tree& tree, Handle top, Handle copy, Copies& copies) {
    std::vector<std::pair<Handle, Handle>> open;  // instances to copy, each with its new parent
    const auto below = [&](Handle original, Handle made) {
        copies.add(original, made);
        const std::vector<Handle> children = tree.children(original);
        for (auto child = children.rbegin(); child != children.rend(); ++child)
            open.emplace_back(*child, made);
    };
    below(top, copy);
    while (!open.empty()) {
        const auto [original, parent] = open.back();
        open.pop_back();
        below(original, copy_of(tree, original, parent));
    }
}

// References to copied instances become references to the copies; references to deleted instances
// become nil.
Value redirected(const property::Tree& tree, const Value& value, const Copies& copies) {
    if (value.is(Type::reference)) {
        if (!tree.alive(value.reference())) return Handle{};
        const auto copy = copies.of.find(value.reference().key());
        return copy == copies.of.end() ? value : Value(copy->second);
    }
    if (value.is(Type::list)) {
        List list;
        for (const Value& element : value.list()) list.push_back(redirected(tree, element, copies));
        return list;
    }
    return value;
}

/// Pairs of original and copy: children before their parents, siblings in order.
std::vector<std::pair<Handle, Handle>> children_first(const property::Tree& tree,
                                                      const Copies& copies) {
    std::vector<std::pair<Handle, Handle>> list, open;
    const auto close = [&] {
        list.push_back(open.back());
        open.pop_back();
    };
    for (const auto& pair : copies.in_order) {
        while (!open.empty() && open.back().second != tree.parent(pair.second)) close();
        open.push_back(pair);
    }
    while (!open.empty()) close();
    return list;
}

// A parent gets its values after its children, because moving the center of mass of a body changes
// its velocity.
void copy_values(property::Tree& tree, const Copies& copies) {
    for (const auto& [from, to] : children_first(tree, copies)) {
        for (const Property* property : tree.properties(from)) {
            if (property->read_only || !tree.overridden(from, *property)) continue;
            // Copies the value of a formula; if the formula has an error, its last valid value.
            (void)tree.problem(from, *property);
            const Value value = redirected(tree, tree.peek(from, *property), copies);
            if (property->binding.kind == property::BindingKind::ad_hoc)
                tree.set_or_add(to, property->name, value);
            else
                tree.set(to, *property, value);
        }
    }
}

int clone(lua_State* L) {
    const Handle self = check_instance(L, 1, "clone");
    Machine& machine = machine_of(L);
    require_creatable(machine.tree, self);
    const Handle made = machine.tree.create(machine.tree.class_of(self));
    try {
        Copies copies;
        copy_below(machine.tree, self, made, copies);
        copy_values(machine.tree, copies);
    } catch (...) {
        machine.tree.destroy(made);
        throw;
    }
    machine.unplaced.handles.push_back(made);
    machine.declarations.made_with_values(made);
    push_instance(L, made);
    return 1;
}

struct GenericMethod {
    const char* name;
    lua_CFunction function;
};

const GenericMethod methods[] = {
    {"add", guarded<effect<add>>},
    {"after", guarded<effect<after_of_instance>>},
    {"alive", guarded<alive>},
    {"all", guarded<all>},
    {"children", guarded<children>},
    {"clone", guarded<effect<clone>>},
    {"delete", guarded<effect<delete_instance>>},
    {"describe", guarded<describe_instance>},
    {"each", guarded<each>},
    {"every", guarded<effect<every_of_instance>>},
    {"find", guarded<find_below>},
    {"formula", guarded<formula_of>},
    {"has", guarded<has>},
    {"is_a", guarded<is_a>},
    {"move", guarded<effect<move_instance>>},
    {"on", guarded<effect<subscribe_event>>},
    {"problem", guarded<problem>},
    {"run", guarded<effect<run_of_instance>>},
    {"send", guarded<effect<send_event>>},
    {"tween", guarded<effect<tween_function>>},
    {"watch", guarded<effect<subscribe_property>>},
};

}  // namespace

int generic_reference(lua_State* L, Machine& machine, std::string_view name) {
    auto& known = machine.members.generic;
    if (known.empty()) {
        for (const GenericMethod& method : methods) {
            note_name(L, method.function, method.name);
            lua_pushcfunction(L, method.function);
            known.emplace(method.name, luaL_ref(L, LUA_REGISTRYINDEX));
        }
    }
    const auto found = known.find(std::string(name));
    return found == known.end() ? LUA_NOREF : found->second;
}

std::string_view generic_name(lua_State* L, int index) {
    const lua_CFunction function = lua_tocfunction(L, index);
    for (const GenericMethod& method : methods)
        if (method.function == function) return method.name;
    return {};
}

}  // namespace fettle::script
