#include <algorithm>
#include <unordered_set>

#include <classes/unplaced_instances.h>
#include <handlers/timers.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <values/values.h>

namespace fettle::script {

namespace {

bool has_proxy(lua_State* L, const Machine& machine, Handle handle) {
    push_registry(L, machine.boxes.proxies);
    lua_rawgeti(L, -1, static_cast<lua_Integer>(handle.key()));
    const bool found = !lua_isnil(L, -1);
    lua_pop(L, 2);
    return found;
}

bool held_by_script(lua_State* L, const Machine& machine, Handle top) {
    bool held = false;
    machine.tree.each_below(top, [&](Handle handle) { held |= has_proxy(L, machine, handle); });
    return held;
}

void collect_references(const Value& value, std::vector<Handle>& found) {
    if (value.is(Type::reference)) {
        found.push_back(value.reference());
    } else if (value.is(Type::list)) {
        for (const Value& element : value.list()) collect_references(element, found);
    }
}

void references_below(const property::Tree& tree, Handle top, std::vector<Handle>& found) {
    tree.each_below(top, [&](Handle handle) {
        for (const Property* property : tree.properties(handle))
            if (property->type == Type::reference || property->any_type ||
                (property->type == Type::list &&
                 (property->element == Type::reference || property->element == Type::nil)))
                // Not `get`: a formula in error refers to what its last value refers to.
                collect_references(tree.peek(handle, *property), found);
    });
}

Handle top_of(const property::Tree& tree, Handle handle) {
    for (Handle up = tree.parent(handle); up; up = tree.parent(up)) handle = up;
    return handle;
}

}  // namespace

UnplacedInstances::Changes UnplacedInstances::take_changes() {
    const std::size_t from = removed ? 0 : std::min(taken, handles.size());
    Changes since{.all = removed,
                  .handles = {handles.begin() + static_cast<std::ptrdiff_t>(from), handles.end()},
                  .limit = limit};
    taken = handles.size();
    removed = false;
    return since;
}

void UnplacedInstances::redo(const Changes& changes) {
    if (changes.all) handles.clear();
    handles.insert(handles.end(), changes.handles.begin(), changes.handles.end());
    limit = changes.limit;
}

void UnplacedInstances::restore(std::vector<property::Handle> those, std::size_t its_limit) {
    handles = std::move(those);
    limit = its_limit;
    taken = handles.size();
    removed = false;
}

std::vector<Handle> dropped_instances(Machine& machine) {
    lua_State* L = machine.lua.main;
    lua_gc(L, LUA_GCCOLLECT);
    // Instances that the tree or a script refers to stay, those that have a timer, and those that
    // they refer to.
    std::vector<Handle> reachable = {machine.tree.root()};
    std::unordered_set<std::uint64_t> rest;
    for (const Handle handle : machine.unplaced.handles) {
        if (!machine.tree.alive(handle) || machine.tree.parent(handle)) continue;
        if (held_by_script(L, machine, handle))
            reachable.push_back(handle);
        else
            rest.insert(handle.key());
    }
    for (const Handle owner : machine.timers.owners())
        if (machine.tree.alive(owner))
            if (const Handle top = top_of(machine.tree, owner); rest.erase(top.key()) > 0)
                reachable.push_back(top);
    while (!rest.empty() && !reachable.empty()) {
        const Handle top = reachable.back();
        reachable.pop_back();
        std::vector<Handle> references;
        references_below(machine.tree, top, references);
        for (const Handle handle : references) {
            if (!machine.tree.alive(handle)) continue;
            const Handle other = top_of(machine.tree, handle);
            if (rest.erase(other.key()) > 0) reachable.push_back(other);
        }
    }
    std::vector<Handle> dropped;
    for (const Handle handle : machine.unplaced.handles)
        if (rest.erase(handle.key()) > 0) dropped.push_back(handle);
    return dropped;
}

void collect_unplaced(Machine& machine) {
    auto& unplaced = machine.unplaced.handles;
    auto& limit = machine.unplaced.limit;
    if (unplaced.size() < limit) return;
    machine.unplaced.removed = true;
    std::erase_if(unplaced, [&](Handle handle) {
        return !machine.tree.alive(handle) || machine.tree.parent(handle);
    });
    if (unplaced.size() >= limit) {
        for (const Handle handle : dropped_instances(machine))
            if (machine.tree.alive(handle)) machine.tree.destroy(handle);
        std::erase_if(unplaced, [&](Handle handle) { return !machine.tree.alive(handle); });
    }
    limit = std::max<std::size_t>(64, 2 * unplaced.size());
}

}  // namespace fettle::script
