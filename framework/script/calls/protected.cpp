#include <cstdio>
#include <optional>

#include <fettle/script/runtime.h>

#include <calls/error_place.h>
#include <calls/errors.h>
#include <calls/protected.h>
#include <limits/limiters.h>
#include <lua/exception_guard.h>
#include <lua/host.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <lua/numeric_locale.h>
#include <lua/runtime_lifetime.h>
#include <sources/sources.h>
#include <values/moved_lists.h>
#include <values/recording.h>

namespace fettle::script {

namespace {

/// The host's function may run scripts, which may raise errors again; the limit prevents a stack
/// overflow.
void report(Machine& machine, ScriptError error) {
    constexpr int deepest = 16;
    if (machine.errors.reports == deepest) {
        std::fprintf(stderr, "an error during %d nested reports of errors: %s\n", deepest,
                     error.message.c_str());
        return;
    }
    struct Depth {
        int& of;
        explicit Depth(int& reports) : of(reports) { ++of; }
        ~Depth() { --of; }
    } depth(machine.errors.reports);
    // A copy, because the call may replace it.
    if (const auto sink = machine.host.on_error) sink(error);
}

}  // namespace

std::string Context::text(Machine& machine) const {
    if (!about) return what;
    const bool alive = machine.tree.alive(about);
    if (property)
        return what + " of " +
               (alive ? machine.tree.path(about, *property) : "(deleted)." + property->name);
    return what + " of " + (alive ? machine.tree.path(about) : "(deleted)");
}

namespace {

/// Reports an error as a note if its cause is an instance that a restore has removed: a handler may
/// refer to an instance that was made after the step to which the game went back. The game
/// continues, and each place in a script is reported once. In a command, the top level and a test,
/// such an error is an ordinary error. Returns whether it was reported.
bool report_gone(Machine& machine, const Context& context, const ScriptError& error) {
    if (machine.lua.gone.empty() || context.what == "chunk" || context.what == "load" ||
        context.what == "fettle_test_turn" || !error.message.ends_with(machine.lua.gone))
        return false;
    const std::string place = error.file + ":" + std::to_string(error.line);
    constexpr std::size_t limit = 100;
    auto& reported = machine.errors.reported_gone;
    if (reported.size() < limit && reported.insert(place).second)
        if (const auto sink = machine.host.on_note)
            sink(error.message + ", when the game went back in time; " + error.context +
                 " ended there, and the game goes on. Ask :alive() first, or keep what belongs to "
                 "the game in the tree, as state(name, value) does");
    return true;
}

/// Sets the writer of the tree while the host calls Lua. The position is computed only if it is
/// needed.
class ScriptCause {
  public:
    explicit ScriptCause(Machine& machine)
        : locate_([&machine] {
              const Interpreter& lua = machine.lua;
              std::string text = position(lua.running ? lua.running : lua.main);
              if (text.size() > 2) text.resize(text.size() - 2);
              if (machine.recording.active) machine.sources.commands.name_plainly(text);
              return text;
          }),
          scope_(machine.tree, machine.recording.writer, &locate_) {}

  private:
    std::function<std::string()> locate_;
    property::Tree::CauseScope scope_;
};

void add_stop(Machine& machine, ScriptError& error) {
    error.message = machine.limiters.budget.reason();
    error.file = machine.limiters.budget.file();
    error.line = machine.limiters.budget.line();
    error.source_line = machine.sources.line(error.file, error.line);
    error.column = 0;
    shorten_source(error);
}

}  // namespace

bool run_protected(Machine& machine, const Context& context, int (*trampoline)(lua_State*),
                   void* body, bool report_error) {
    // The runtime was destroyed: running calls end, but no new call starts.
    if (!machine.life.in_tree) return false;
    const RuntimeLifetime::Use use(machine.life);
    const Watchdog::Call call(machine.limiters.watchdog);
    const NumericLocale numbers;
    std::optional<Budget::Scope> limited;
    if (const auto limits = machine.limiters.budget.of_call())
        limited.emplace(machine.limiters.budget, *limits);
    lua_State* L = machine.lua.main;
    lua_State* outer = machine.lua.running;
    machine.lua.running = L;
    if (machine.limiters.watchdog.outermost()) {
        machine.moved_lists.forget();
        machine.recording.after_snapshot = false;
    }
    machine.errors.caught.reset();
    machine.lua.gone.clear();
    const int top = lua_gettop(L);
    int status = LUA_ERRMEM;
    if (lua_checkstack(L, 4)) {
        lua_pushcfunction(L, describing_handler);
        lua_pushcfunction(L, trampoline);
        lua_pushlightuserdata(L, body);
        const ScriptCause cause(machine);
        status = lua_pcall(L, 1, 0, top + 1);
    }
    machine.lua.running = outer;
    // The script may have caught the error of the budget with pcall.
    const bool stopped = machine.limiters.budget.stopping();
    if (status == LUA_OK && !stopped) {
        lua_settop(L, top);
        return true;
    }
    if (!machine.errors.caught) {
        // Out of memory, or an error while describing an error: only a message exists.
        machine.errors.caught =
            bare_error(machine, status == LUA_OK                 ? machine.limiters.budget.reason()
                                : lua_type(L, -1) == LUA_TSTRING ? error_text(L, -1)
                                : status == LUA_ERRMEM           ? "not enough memory"
                                                       : "an error that cannot be described");
    }
    lua_settop(L, top);
    // Report where the script was stopped, even if it changed the error.
    if (stopped) add_stop(machine, *machine.errors.caught);
    limited.reset();
    machine.errors.thread_error.reset();
    machine.errors.caught->context = context.text(machine);
    if (report_error) {
        ScriptError error = std::move(*machine.errors.caught);
        machine.errors.caught.reset();
        if (report_gone(machine, context, error)) return false;
        report(machine, std::move(error));
    }
    return false;
}

}  // namespace fettle::script
