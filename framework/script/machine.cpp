#include "machine.h"

#include <new>
#include <utility>

#include <fettle/property/error.h>

#include "description.h"
#include "guard.h"
#include "instance.h"
#include "instance_set.h"
#include "methods.h"
#include "sandbox.h"
#include "script_classes.h"
#include "subscriptions.h"

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

int new_table(lua_State* L, const char* mode) {
    lua_newtable(L);
    if (mode) {
        lua_newtable(L);
        lua_pushstring(L, mode);
        lua_setfield(L, -2, "__mode");
        lua_setmetatable(L, -2);
    }
    return luaL_ref(L, LUA_REGISTRYINDEX);
}

int open_all(lua_State* L) {
    Machine& machine = machine_of(L);
    open_libraries(L);
    machine.anchors = new_table(L, nullptr);
    machine.loaded = new_table(L, nullptr);
    machine.killed = new_table(L, "k");
    machine.last_result = new_table(L, nullptr);
    define_vec(L, machine);
    open_instance(L, machine);
    open_sets(L, machine);
    open_records(L, machine);
    open_subscriptions(L, machine);
    open_classes(L, machine);
    open_descriptions(L, machine);
    open_pen(L, machine);
    open_environment(L, machine);
    // Games make many short-lived vectors over a small heap: with the default pause of 200 % most
    // of their cost is marking that heap again and again.
    lua_gc(L, LUA_GCINC, collector_pause, 0, 0);
    lua_settop(L, 0);
    return 0;
}

/// Before anything is made.
property::Tree& without_runtime(property::Tree& tree) {
    for (const property::SnapshotPart* part : tree.parts())
        if (part->part_name() == RuntimePart::name)
            throw property::Error(property::ErrorKind::bad_structure,
                                  "the tree has a runtime already: it has one at a time");
    return tree;
}

}  // namespace

Machine::Machine(property::Tree& property_tree, Options runtime_options)
    : tree(without_runtime(property_tree)),
      tree_life(tree.lifetime()),
      options(std::move(runtime_options)),
      files(options.files != nullptr ? *options.files : files_on_disk),
      arena(options.memory_limit),
      random(options.seed),
      subscriptions(std::make_unique<Subscriptions>(*this)),
      classes(std::make_unique<ScriptClasses>(*this)) {
    main = lua_newstate(Arena::allocate, &arena);
    if (!main) throw std::bad_alloc();
    alive = std::make_shared<lua_State*>(main);
    running = main;
    *static_cast<Machine**>(lua_getextraspace(main)) = this;
    watchdog.limit(options.call_seconds, {});
    tree.add_part(part);
    arena.on_refusal = [this](const Arena::Refusal& refusal) { budget.memory_refused(refusal); };
    arena.on_large = [this](std::size_t size) { budget.charge_quietly(size / 64); };
    lua_pushcfunction(main, guarded<open_all>);
    if (lua_pcall(main, 0, 0, 0) != LUA_OK) {
        const char* message = lua_tostring(main, -1);
        const std::string text = message ? message : "Lua could not be started";
        end();
        throw property::Error(property::ErrorKind::rejected, text);
    }
}

Machine::~Machine() {
    end();
}

void Machine::leave() {
    if (std::exchange(in_tree, false) && !tree_life.expired()) {
        tree.mark_weight(INT64_MAX, {});
        tree.compile_formulas_with({});
        tree.remove_part(part);
    }
    subscriptions->clear();
    timers.clear();
}

void Machine::end() {
    leave();
    subscriptions.reset();
    classes.reset();
    arena.set_limit(static_cast<std::size_t>(-1));
    *alive = nullptr;
    lua_close(main);
}

Limits Machine::command_limits() const {
    const auto memory = command_memory;  // it may put another in its place
    return {.instructions = options.console_budget,
            .memory = memory ? memory() : options.console_memory,
            .raised_by = memory_property};
}

DispatchTable& Machine::dispatch_of(const property::Class& of) {
    if (of.id() >= dispatch.size()) dispatch.resize(of.id() + 1);
    auto& table = dispatch[of.id()];
    if (!table) table = std::make_unique<DispatchTable>(tree, of, !recording.active);
    return *table;
}

void Machine::record(bool whether) {
    if (recording.active == whether) return;
    recording.active = whether;
    for (const auto& table : dispatch)
        if (table) table->open(!whether);
}

}  // namespace fettle::script
