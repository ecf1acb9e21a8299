#include <algorithm>
#include <deque>
#include <map>
#include <unordered_map>
#include <utility>

#include <calls/errors.h>
#include <classes/script_classes.h>
#include <handlers/function_source.h>
#include <lua/environment.h>
#include <lua/host.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <motion/tweens.h>
#include <reload/merge.h>
#include <reload/reload.h>
#include <sources/sources.h>
#include <writes/declarations.h>

namespace fettle::script {

namespace {

/// Pushes a table with the same entries as the table at the top of the stack.
void push_copy(lua_State* L) {
    const int from = lua_gettop(L);
    lua_newtable(L);
    for (lua_pushnil(L); lua_next(L, from) != 0;) {
        lua_pushvalue(L, -2);
        lua_insert(L, -2);
        lua_rawset(L, from + 1);
    }
}

/// A reference to a copy of the globals.
int copy_of_globals(Machine& machine) {
    lua_State* const L = machine.lua.main;
    push_registry(L, machine.globals.table);
    push_copy(L);
    const int copy = luaL_ref(L, LUA_REGISTRYINDEX);
    lua_pop(L, 1);
    return copy;
}

/// The text of the game's `start`; "" if it has none.
std::string text_of_start(Machine& machine) {
    lua_State* const L = machine.lua.main;
    push_registry(L, machine.globals.table);
    push_text(L, "start");
    lua_rawget(L, -2);
    std::string text;
    if (lua_isfunction(L, -1)) text = function_source(L, machine, lua_gettop(L)).text;
    lua_pop(L, 2);
    return text;
}

void set_global(lua_State* L, int table, const std::string& name) {
    push_text(L, name);
    lua_insert(L, -2);
    lua_rawset(L, table);
}

/// Deletes detached instances that were made by code that failed.
void destroy_made(Machine& machine, const Declarations::All& all) {
    for (const Declarations::Declared& each : all)
        if (each.made && machine.tree.alive(each.instance) &&
            !machine.tree.is_below(each.instance, machine.tree.root()))
            machine.tree.destroy(each.instance);
}

}  // namespace

/// The state that a failed reload restores.
struct TopLevel::Kept {
    int globals = LUA_NOREF;
    int loaded = LUA_NOREF;
    std::vector<std::string> assigned;
    decltype(Environment::stated) stated;
    std::unordered_map<std::string, std::string> texts;
    Random::State random{};
    std::vector<Handle> tweens;
};

void TopLevel::begin_noting() {
    machine_.connections.begin_noting();
    machine_.timers.begin_noting();
}

TopLevel::Noted TopLevel::end_noting() {
    return {machine_.connections.end_noting(), machine_.timers.end_noting()};
}

/// Notes the globals that differ from those in the table with this reference, which ends.
void TopLevel::note_globals(int before) {
    lua_State* const L = machine_.lua.main;
    names_.clear();
    push_registry(L, before);
    push_registry(L, machine_.globals.table);
    const int old = lua_gettop(L) - 1, now = lua_gettop(L);
    for (lua_pushnil(L); lua_next(L, now) != 0; lua_pop(L, 1)) {
        if (lua_type(L, -2) != LUA_TSTRING) continue;
        lua_pushvalue(L, -2);
        lua_rawget(L, old);
        if (lua_rawequal(L, -1, -2) == 0) names_.emplace_back(string_at(L, -3));
        lua_pop(L, 1);
    }
    lua_pop(L, 2);
    luaL_unref(L, LUA_REGISTRYINDEX, before);
}

bool TopLevel::load(const std::function<bool()>& run) {
    noted_ = {};
    random_ = machine_.random.state();
    const int before = copy_of_globals(machine_);
    begin_noting();
    machine_.declarations.begin(false);
    const bool ok = run();
    machine_.declarations.keep(machine_.declarations.end());
    noted_ = end_noting();
    note_globals(before);
    return ok;
}

void TopLevel::move_into(Kept& kept) {
    lua_State* const L = machine_.lua.main;
    kept.globals = copy_of_globals(machine_);
    push_registry(L, machine_.globals.table);
    const int table = lua_gettop(L);
    for (const std::string& name : names_) {
        lua_pushnil(L);
        set_global(L, table, name);
    }
    lua_pop(L, 1);
    push_registry(L, machine_.globals.loaded);
    kept.loaded = luaL_ref(L, LUA_REGISTRYINDEX);
    lua_newtable(L);
    lua_rawseti(L, LUA_REGISTRYINDEX, machine_.globals.loaded);
    kept.assigned = machine_.globals.assigned;
    kept.stated = std::exchange(machine_.globals.stated, {});
    kept.texts = machine_.sources.texts;
    kept.random = machine_.random.state();
    kept.tweens = machine_.tweens.all();
}

/// `made`: what the failed code connected and started.
void TopLevel::restore(const Kept& kept, const Noted& made) {
    for (const Connections::Noted& each : made.connections) machine_.connections.stop(each.id);
    for (const Timers::Noted& each : made.timers) machine_.timers.end(each);
    lua_State* const L = machine_.lua.main;
    push_registry(L, machine_.globals.table);
    const int table = lua_gettop(L);
    std::vector<std::string> now;
    for (lua_pushnil(L); lua_next(L, table) != 0; lua_pop(L, 1))
        if (lua_type(L, -2) == LUA_TSTRING) now.emplace_back(string_at(L, -2));
    for (const std::string& name : now) {
        lua_pushnil(L);
        set_global(L, table, name);
    }
    push_registry(L, kept.globals);
    for (lua_pushnil(L); lua_next(L, table + 1) != 0;) {
        lua_pushvalue(L, -2);
        lua_insert(L, -2);
        lua_rawset(L, table);
    }
    lua_pop(L, 2);
    push_registry(L, kept.loaded);
    lua_rawseti(L, LUA_REGISTRYINDEX, machine_.globals.loaded);
    machine_.globals.assigned = kept.assigned;
    machine_.globals.stated = kept.stated;
    machine_.sources.texts = kept.texts;
}

Reloaded TopLevel::reload(const std::function<bool()>& run) {
    lua_State* const L = machine_.lua.main;
    const std::string start = text_of_start(machine_);
    Kept kept;
    move_into(kept);
    const int before = copy_of_globals(machine_);
    begin_noting();
    machine_.classes.begin_reload();
    machine_.declarations.begin(true);
    machine_.random.restore(random_);
    Reloaded result;
    result.done = run();
    machine_.random.restore(kept.random);
    const Noted made = end_noting();
    // A tween of the top level runs once.
    for (const Handle tween : machine_.tweens.all())
        if (std::ranges::find(kept.tweens, tween) == kept.tweens.end() &&
            machine_.tree.alive(tween))
            machine_.tree.destroy(tween);
    if (result.done) {
        take(made, result);
        note_globals(before);
        if (const std::string now = text_of_start(machine_);
            !start.empty() && !now.empty() && now != start)
            result.notes.emplace_back(
                "start() has changed: it is called when a game begins, so its new values are seen "
                "in the next run");
    } else {
        result.error = std::exchange(machine_.errors.caught, {});
        destroy_made(machine_, machine_.declarations.end());
        machine_.classes.end_reload(false);
        restore(kept, made);
        luaL_unref(L, LUA_REGISTRYINDEX, before);
    }
    luaL_unref(L, LUA_REGISTRYINDEX, kept.globals);
    luaL_unref(L, LUA_REGISTRYINDEX, kept.loaded);
    return result;
}

/// Applies what the new code has declared, in place of what the old code did.
void TopLevel::take(Noted made, Reloaded& result) {
    const std::vector<ScriptClasses::NewDefault> defaults = machine_.classes.new_defaults();
    Merge merge(machine_, machine_.declarations.end(), result.notes);
    merge.run(defaults);
    for (const Connections::Noted& each : noted_.connections) machine_.connections.retire(each.id);
    for (const Connections::Noted& each : made.connections) {
        const Handle now = merge.result_of(each.instance);
        if (now == each.instance) continue;
        if (machine_.tree.alive(now))
            machine_.connections.reconnect(each, now);
        else
            machine_.connections.stop(each.id);
    }
    replace_timers(made.timers);
    merge.finish();
    if (merge.has_changed()) reloaded_at_ = machine_.tree.step();
    machine_.classes.end_reload(true);
    for (auto& lost : {machine_.classes.lost_states(), machine_.classes.lost_classes()})
        result.notes.insert(result.notes.end(), lost.begin(), lost.end());
    noted_ = std::move(made);
}

void TopLevel::note_return(std::uint64_t step) {
    if (!reloaded_at_ || step >= *reloaded_at_) return;
    const std::string from = std::to_string(step), reload = std::to_string(*reloaded_at_);
    reloaded_at_.reset();
    // A copy, because the call may replace it.
    if (const auto sink = machine_.host.on_note)
        sink("the game goes on from step " + from + " with the values that it had there: those " +
             "that its files have changed in step " + reload + " are the old ones; restart() " +
             "begins with the new ones");
}

/// A timer that the old code started in the same way is due when that one would be.
void TopLevel::replace_timers(const std::vector<Timers::Noted>& made) {
    std::vector<Timers::Noted> old = std::exchange(noted_.timers, {});
    // By their times, and in the order of the file where several have the same.
    std::map<std::pair<double, double>, std::deque<Timers::Noted*>> waiting;
    for (Timers::Noted& each : old) {
        if (each.thread != LUA_NOREF) continue;
        machine_.timers.retire(each);
        waiting[{each.delay, each.interval}].push_back(&each);
    }
    for (const Timers::Noted& each : made) {
        if (each.thread != LUA_NOREF) continue;
        auto& same = waiting[{each.delay, each.interval}];
        if (same.empty()) continue;
        machine_.timers.replace(*same.front(), each);
        same.front()->id = 0;
        same.pop_front();
    }
    for (const Timers::Noted& each : old)
        if (each.id != 0 || each.thread != LUA_NOREF) machine_.timers.end(each);
}

}  // namespace fettle::script
