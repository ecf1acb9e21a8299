#include <unordered_map>

#include <fettle/property/tree.h>

#include <classes/script_classes.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <runtime/method_timers.h>

namespace fettle::script {

namespace {

/// Methods of a class by the address of their function.
using Methods = std::unordered_map<const void*, std::string>;

Methods methods_of(Machine& machine, const property::Class& of) {
    lua_State* const L = machine.lua.main;
    std::vector<std::string> names;
    machine.classes.add_function_names(of, names);
    Methods names_by_address;
    for (const std::string& name : names) {
        if (!machine.classes.push_function(L, of, name)) continue;
        names_by_address.emplace(lua_topointer(L, -1), name);
        lua_pop(L, 1);
    }
    return names_by_address;
}

}  // namespace

std::vector<MethodTimer> method_timers(Machine& machine, const Timers::Queue& queue,
                                       std::unordered_set<std::uint64_t>& numbers) {
    lua_State* const L = machine.lua.main;
    std::vector<MethodTimer> found;
    if (lua_checkstack(L, 4) == 0) return found;
    std::unordered_map<const property::Class*, Methods> known;
    for (const auto& [key, timer] : queue) {
        if (timer.top || !timer.owner || !machine.tree.alive(timer.owner)) continue;
        if (timer.scene && !machine.tree.alive(timer.scene)) continue;
        const property::Class& of = machine.tree.class_of(timer.owner);
        if (!machine.classes.scripted(of)) continue;
        if (!known.contains(&of)) known.emplace(&of, methods_of(machine, of));
        timer.function->push(L);
        const auto method = known.at(&of).find(lua_topointer(L, -1));
        lua_pop(L, 1);
        if (method == known.at(&of).end()) continue;
        numbers.insert(key.second);
        found.push_back({timer.owner, timer.scene, method->second, key.first, timer.interval});
    }
    return found;
}

void put(const std::vector<MethodTimer>& all, property::ByteWriter& to) {
    to.put(std::uint64_t{all.size()});
    for (const MethodTimer& each : all) {
        to.put(each.owner);
        to.put(each.scene);
        to.put(each.method);
        to.put(each.due);
        to.put(each.interval);
    }
}

std::vector<MethodTimer> method_timers_of(property::ByteReader& from) {
    std::vector<MethodTimer> all;
    constexpr std::size_t least_size = 2 * sizeof(property::Handle) + 2 * sizeof(double);
    for (std::size_t n = from.count(least_size); n > 0; --n) {
        MethodTimer& each = all.emplace_back();
        each.owner = from.get<property::Handle>();
        each.scene = from.get<property::Handle>();
        each.method = from.text();
        each.due = from.get<double>();
        each.interval = from.get<double>();
        from.require(each.due >= 0 && each.due < 1e15 && each.interval < 1e15,
                     "an invalid time of a timer");
    }
    return all;
}

bool begin_again(Machine& machine, const MethodTimer& timer) {
    lua_State* const L = machine.lua.main;
    if (!machine.tree.alive(timer.owner) || lua_checkstack(L, 4) == 0) return false;
    if (!machine.classes.push_function(L, machine.tree.class_of(timer.owner), timer.method))
        return false;
    machine.timers.add_at(L, timer.due, timer.interval, timer.owner, timer.scene);
    return true;
}

}  // namespace fettle::script
