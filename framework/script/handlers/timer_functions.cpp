// What scripts call: after, every, wait, and the methods of instances with these names.

#include <fettle/property/spelling.h>
#include <fettle/script/runtime.h>

#include <handlers/connections.h>
#include <handlers/observed.h>
#include <handlers/timers.h>
#include <lua/exception_guard.h>
#include <lua/host.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <values/recording.h>
#include <values/short_text.h>
#include <values/values.h>

namespace fettle::script {

namespace {

// s; a shorter interval would call the function many hundred times in a step.
constexpr double shortest_interval = 1e-4;

/// Whether the timer pauses with the game: not with { pauses = false } at 3.
bool pauses_with_game(lua_State* L, const std::string& what) {
    if (lua_isnoneornil(L, 3)) return true;
    const std::string needs = what + ": needs options such as { pauses = false }";
    if (!lua_istable(L, 3)) refuse_type(L, 3, needs);
    bool pauses = true;
    for (lua_pushnil(L); lua_next(L, 3) != 0; lua_pop(L, 1)) {
        const std::string name = lua_type(L, -2) == LUA_TSTRING ? string_at(L, -2) : "";
        if (name != "pauses")
            throw Error(ErrorKind::unknown_name,
                        what + ": there is no option " + short_text(L, -2) +
                            property::suggestion(name, std::vector<std::string>{"pauses"}));
        if (!lua_isboolean(L, -1)) refuse_type(L, -1, what + ": pauses is true or false");
        pauses = lua_toboolean(L, -1) != 0;
    }
    return pauses;
}

/// The arguments are seconds, a function and options.
int timer(lua_State* L, const char* what, bool repeated, Handle owner = {}) {
    const double seconds = check_seconds(L, what);
    if (repeated && seconds > 0 && seconds < shortest_interval)
        throw Error(ErrorKind::out_of_range,
                    "every: " + property::number_text(seconds) +
                        " s is shorter than 0.0001 s; every(0, ...) is each step");
    check_function(L, 2, what);
    const bool pauses = pauses_with_game(L, what);
    lua_settop(L, 2);
    Timers& timers = machine_of(L).timers;
    const double interval = repeated ? seconds : -1;
    push_timer_connection(L, pauses ? timers.add(L, seconds, interval, owner)
                                    : timers.add_real(L, seconds, interval, owner));
    return 1;
}

int after(lua_State* L) {
    return timer(L, "after", false);
}
int every(lua_State* L) {
    return timer(L, "every", true);
}

/// `wait` in a terminal, whose next command runs later. False, and nothing is done, elsewhere.
bool wait_in_terminal(lua_State* L) {
    const Machine& machine = machine_of(L);
    const auto& function = (*machine.host.console).wait;
    if (!machine.recording.active) return false;
    if (!function) return !machine.options.replay.empty();
    constexpr double longest = 3600;  // s
    Wait wait;
    int seconds = 0;  // the argument that is a time
    if (lua_isnoneornil(L, 1)) {
        wait.until_pause = true;
    } else if (lua_isnumber(L, 1) != 0) {  // `wait 2` gives a text
        seconds = 1;
    } else {
        wait.condition = observe(L, 1, "wait");
        if (!lua_isnoneornil(L, 2)) seconds = 2;
    }
    if (seconds > 0) wait.seconds = lua_tonumber(L, seconds);
    if (seconds > 0 &&
        (lua_isnumber(L, seconds) == 0 || !(wait.seconds >= 0) || wait.seconds > longest))
        throw Error(ErrorKind::out_of_range, "wait: expected a time from 0 to 3600 s");
    return function(std::move(wait));
}

int wait(lua_State* L) {
    if (!lua_isyieldable(L) && wait_in_terminal(L)) return 0;
    const double seconds = lua_gettop(L) == 0 ? 0 : check_seconds(L, "wait");
    if (!lua_isyieldable(L))
        throw Error(ErrorKind::bad_structure,
                    "wait: works inside a coroutine or a function given to after; here, use "
                    "after(seconds, function)");
    machine_of(L).timers.wait(L, seconds);
    return lua_yield(L, 0);
}

/// Takes the instance from the arguments.
Handle take_self(lua_State* L, const char* what) {
    const Handle self = check_instance(L, 1, what);
    lua_remove(L, 1);
    return self;
}

}  // namespace

int after_of_instance(lua_State* L) {
    const Handle self = take_self(L, "after");
    return timer(L, "after", false, self);
}

int every_of_instance(lua_State* L) {
    const Handle self = take_self(L, "every");
    return timer(L, "every", true, self);
}

int run_of_instance(lua_State* L) {
    const Handle self = take_self(L, "run");
    check_function(L, 1, "run");
    lua_settop(L, 1);
    machine_of(L).timers.start(L, self);
    return 1;
}

void open_timers(lua_State* L) {
    add_function<after>(L, "after");
    add_function<every>(L, "every");
    add_function<wait>(L, "wait");
}

}  // namespace fettle::script
