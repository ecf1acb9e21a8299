#include <new>
#include <utility>

#include <fettle/script/runtime.h>

#include <classes/class_definition.h>
#include <console/find.h>
#include <console/help.h>
#include <handlers/connections.h>
#include <handlers/coroutines.h>
#include <handlers/formulas.h>
#include <handlers/subscriptions.h>
#include <handlers/timers.h>
#include <library/globals.h>
#include <library/library.h>
#include <library/pen.h>
#include <library/scene_changes.h>
#include <library/time_functions.h>
#include <lua/environment.h>
#include <lua/exception_guard.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <objects/class_object.h>
#include <objects/instance.h>
#include <objects/instance_set.h>
#include <runtime/parts.h>
#include <runtime/runtime_part.h>
#include <sandbox/noise.h>
#include <sandbox/random.h>
#include <sandbox/sandbox.h>
#include <values/description.h>
#include <values/members.h>
#include <values/records.h>
#include <values/store_type.h>
#include <values/values.h>

namespace fettle::script {

namespace {

void open_libraries(lua_State* L) {
    const luaL_Reg libraries[] = {
        {LUA_GNAME, luaopen_base},       {LUA_COLIBNAME, luaopen_coroutine},
        {LUA_TABLIBNAME, luaopen_table}, {LUA_STRLIBNAME, luaopen_string},
        {LUA_MATHLIBNAME, luaopen_math}, {LUA_UTF8LIBNAME, luaopen_utf8},
        {LUA_OSLIBNAME, luaopen_os},
    };
    for (const luaL_Reg& library : libraries) {
        luaL_requiref(L, library.name, library.func, 1);
        lua_pop(L, 1);
    }
}

/// Whether an error of Lua runs destructors. It does in Lua's C++ build only; Debian 12 gives the
/// functions of both builds the same names, so a program can be linked with the other one.
bool errors_run_destructors(lua_State* L) {
    bool ran = false;
    lua_pushcfunction(L, [](lua_State* state) {
        struct Mark {
            bool& ran;
            ~Mark() { ran = true; }
        } mark{*static_cast<bool*>(lua_touserdata(state, 1))};
        lua_pushnil(state);
        return lua_error(state);
    });
    lua_pushlightuserdata(L, &ran);
    lua_pcall(L, 1, 0, 0);
    lua_pop(L, 1);
    return ran;
}

int new_table(lua_State* L) {
    lua_newtable(L);
    return luaL_ref(L, LUA_REGISTRYINDEX);
}

/// Makes the environment of games and the console; it becomes the state's globals.
void open_environment(lua_State* L, Machine& machine) {
    open_sandbox(L);
    open_coroutines(L);
    open_random(L);
    open_noise(L);
    open_timers(L);
    open_tweens(L);
    open_watch(L);
    open_query(L);
    open_class_function(L);
    open_require(L);
    open_scenes(L);
    open_scene_changes(L);
    open_formulas(L);
    open_history(L);
    open_tweaks(L);
    open_console_functions(L);
    open_saves(L);
    open_time(L);
    open_stated(L);
    open_help(L);
    open_find(L);
    open_vec(L);
    open_color(L, machine);
    open_list(L, machine);
    open_store(L, machine);
    note_names(L);
    open_globals(L, machine);
    lua_pushvalue(L, -1);
    lua_rawseti(L, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
}

int open_all(lua_State* L) {
    Machine& machine = machine_of(L);
    open_libraries(L);
    machine.members.anchors = new_table(L);
    machine.globals.loaded = new_table(L);
    push_weak_table(L, "k");
    machine.lua.killed = luaL_ref(L, LUA_REGISTRYINDEX);
    machine.globals.last_result = new_table(L);
    define_vec(L, machine);
    open_instance(L, machine);
    open_sets(L, machine);
    open_records(L, machine);
    open_connections(L, machine);
    open_classes(L, machine);
    open_descriptions(L, machine);
    open_pen(L, machine);
    open_environment(L, machine);
    // Games make many short-lived vectors in a small heap. With the default pause of 200 %, most of
    // their cost would be repeated marking of that heap.
    lua_gc(L, LUA_GCINC, collector_pause, 0, 0);
    lua_settop(L, 0);
    return 0;
}

/// Throws if the tree has a runtime, before any part is made.
property::Tree& without_runtime(property::Tree& tree) {
    if (tree.lifetime().expired())
        throw Error(ErrorKind::deleted,
                    "the tree is being destroyed: it cannot get a runtime any more");
    for (const property::SnapshotPart* part : tree.parts())
        if (part->part_name() == RuntimePart::name)
            throw Error(ErrorKind::bad_structure,
                        "the tree has a runtime already: it has one at a time");
    return tree;
}

}  // namespace

Parts::Parts(property::Tree& tree, Options runtime_options)
    : machine{without_runtime(tree),
              options,
              lua,
              life,
              limiters,
              globals,
              sources,
              host,
              recording,
              boxes,
              moved_lists,
              typed_formulas,
              members,
              declarations,
              errors,
              timers,
              tweens,
              connections,
              classes,
              hints,
              unplaced,
              random,
              snapshots,
              pen},
      options(std::move(runtime_options)),
      limiters(machine, options.memory_limit),
      sources(options.files),
      members(tree, recording),
      declarations(tree, recording),
      random(options.seed) {
    life.tree = tree.lifetime();
    lua_State* const L = lua_newstate(Arena::allocate, &limiters.arena);
    if (!L) throw std::bad_alloc();
    lua.alive = std::make_shared<lua_State*>(L);
    lua.main = lua.running = L;
    *static_cast<Machine**>(lua_getextraspace(L)) = &machine;
    limiters.watchdog.limit(options.call_seconds, {});
    limiters.budget.limit_tree();
    tree.add_part(saved);
    limiters.arena.on_refusal = [this](const Arena::Refusal& refusal) {
        return limiters.budget.memory_refused(refusal);
    };
    limiters.budget.passed_limit = [this]() -> std::string {
        const GameLimits& limits = options.limits;
        const auto passed = [](std::size_t count, std::size_t limit, const char* what) {
            return limit > 0 && count > limit
                       ? "there are " + std::to_string(count) + " " + what +
                             ", and this game may have " + std::to_string(limit)
                       : std::string();
        };
        std::string why = passed(machine.tree.size(), limits.instances, "instances");
        if (why.empty()) why = passed(machine.tree.watcher_count(), limits.handlers, "handlers");
        if (why.empty()) why = passed(timers.size(), limits.timers, "timers");
        return why;
    };
    limiters.arena.set_longest_text(options.limits.text);
    limiters.arena.on_large = [this](std::size_t size) {
        limiters.budget.charge_quietly(size / 64);
    };
    if (!errors_run_destructors(L)) {
        end();
        throw Error(
            ErrorKind::rejected,
            "this program is linked with Lua in C, whose errors run no destructors; link it "
            "with Lua in C++ (-llua5.4-c++)");
    }
    lua_pushcfunction(L, guarded<open_all>);
    if (lua_pcall(L, 0, 0, 0) != LUA_OK) {
        const char* message = lua_tostring(L, -1);
        const std::string text = message ? message : "Lua could not be started";
        end();
        throw Error(ErrorKind::rejected, text);
    }
}

Parts::~Parts() {
    end();
}

void Parts::leave() {
    if (std::exchange(life.in_tree, false) && !life.tree.expired()) {
        machine.tree.mark_weight(INT64_MAX, {});
        machine.tree.compile_formulas_with({});
        machine.tree.remove_part(saved);
    }
    connections.clear();
    timers.clear();
}

void Parts::end() {
    leave();
    limiters.arena.set_limit(static_cast<std::size_t>(-1));
    *lua.alive = nullptr;
    lua_close(lua.main);
}

}  // namespace fettle::script
