#include <string_view>

#include <calls/errors.h>
#include <handlers/coroutines.h>
#include <handlers/timers.h>
#include <limits/limiters.h>
#include <lua/exception_guard.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <values/values.h>

namespace fettle::script {

namespace {

// Sets `thread` as the running thread during `go`, and returns the result of `go`.
template <class Go>
int switch_to(lua_State* L, lua_State* thread, Go go) {
    Machine& machine = machine_of(L);
    machine.limiters.budget.enter(thread);
    machine.limiters.budget.check(L);
    lua_State* outer = std::exchange(machine.lua.running, thread);
    const int status = go();
    machine.lua.running = outer;
    return status;
}

// Runs the thread. Returns the status of lua_resume; results or the error object are on the
// thread's stack.
int run_thread(lua_State* L, lua_State* thread, int arguments, int& results) {
    Machine& machine = machine_of(L);
    const int status =
        switch_to(L, thread, [&] { return lua_resume(thread, L, arguments, &results); });
    if (status > LUA_YIELD && lua_status(thread) != status) {
        // lua_resume itself failed, for example because coroutines are nested too deeply.
        const std::string placed = position(L) + string_at(thread, -1);
        lua_pop(thread, 1);
        push_text(thread, placed);
    }
    if (status > LUA_YIELD && machine.limiters.budget.stopping()) {
        // The thread was stopped and its hook may not be called any more, so nothing of it may run
        // again, not even __close.
        push_registry(L, machine.lua.killed);
        lua_pushthread(thread);
        lua_xmove(thread, L, 1);
        lua_pushboolean(L, 1);
        lua_rawset(L, -3);
        lua_pop(L, 1);
    }
    machine.limiters.budget.check(L);
    return status;
}

lua_State* thread_at(lua_State* L, int index, const char* what) {
    lua_State* thread = lua_tothread(L, index);
    if (!thread) refuse_type(L, index, std::string(what) + ": needs a coroutine");
    return thread;
}

// The reason why the thread cannot be resumed, or nullptr.
const char* not_resumable(lua_State* L, lua_State* thread) {
    if (machine_of(L).timers.waiting(thread)) return "cannot resume a coroutine that waits";
    if (thread == L || lua_status(thread) == LUA_OK) {
        lua_Debug frame;
        if (thread == L || lua_getstack(thread, 0, &frame))
            return "cannot resume non-suspended coroutine";
        if (lua_gettop(thread) == 0) return "cannot resume dead coroutine";
        return nullptr;
    }
    return lua_status(thread) == LUA_YIELD ? nullptr : "cannot resume dead coroutine";
}

int create(lua_State* L) {
    check_function(L, 1, "coroutine.create");
    machine_of(L).limiters.budget.charge(L, 100);
    lua_State* thread = lua_newthread(L);
    lua_pushvalue(L, 1);
    lua_xmove(L, thread, 1);
    return 1;
}

int resume(lua_State* L) {
    lua_State* thread = thread_at(L, 1, "coroutine.resume");
    const int arguments = lua_gettop(L) - 1;
    if (const char* why = not_resumable(L, thread)) {
        lua_pushboolean(L, 0);
        lua_pushstring(L, why);
        return 2;
    }
    if (!lua_checkstack(thread, arguments))
        throw Error(ErrorKind::rejected, "coroutine.resume: too many arguments");
    lua_xmove(L, thread, arguments);
    int results = 0;
    const int status = run_thread(L, thread, arguments, results);
    if (status > LUA_YIELD) {
        complete_message(thread, thread, 0);
        lua_pushboolean(L, 0);
        lua_xmove(thread, L, 1);
        return 2;
    }
    lua_pushboolean(L, 1);
    luaL_checkstack(L, results, "too many results to resume");
    lua_xmove(thread, L, results);
    return results + 1;
}

// Upvalue: the thread.
int call_wrapped(lua_State* L) {
    lua_State* thread = lua_tothread(L, lua_upvalueindex(1));
    if (const char* why = not_resumable(L, thread)) throw Error(ErrorKind::rejected, why);
    const int arguments = lua_gettop(L);
    if (!lua_checkstack(thread, arguments))
        throw Error(ErrorKind::rejected, "coroutine: too many arguments");
    lua_xmove(L, thread, arguments);
    const int results = resume_thread(L, thread, arguments);
    luaL_checkstack(L, results, "too many results of a coroutine");
    lua_xmove(thread, L, results);
    return results;
}

int wrap(lua_State* L) {
    create(L);
    lua_pushcclosure(L, guarded<call_wrapped>, 1);
    return 1;
}

/// The coroutine is at 1. Pushes true; or false and the error with which it has ended.
int close_at_1(lua_State* L, const char* what) {
    Machine& machine = machine_of(L);
    lua_State* thread = thread_at(L, 1, what);
    push_registry(L, machine.lua.killed);
    lua_pushvalue(L, 1);
    const bool killed = lua_rawget(L, -2) != LUA_TNIL;
    lua_Debug frame;
    if (thread == L || (lua_status(thread) == LUA_OK && lua_getstack(thread, 0, &frame)))
        throw Error(ErrorKind::rejected, "cannot close a running coroutine");
    machine.timers.end_waiting(thread);
    if (killed) {
        lua_pushboolean(L, 1);
        return 1;
    }
    const int status = switch_to(L, thread, [&] { return lua_resetthread(thread); });
    machine.limiters.budget.check(L);
    if (status == LUA_OK) {
        lua_pushboolean(L, 1);
        return 1;
    }
    lua_pushboolean(L, 0);
    lua_xmove(thread, L, 1);
    return 2;
}

int close(lua_State* L) {
    return close_at_1(L, "coroutine.close");
}

// --- Methods of coroutines, as those of timers

int stop(lua_State* L) {
    return close_at_1(L, "stop") == 1 ? 0 : lua_error(L);
}

int active(lua_State* L) {
    lua_State* const thread = thread_at(L, 1, "active");
    const char* const why = not_resumable(L, thread);
    lua_pushboolean(L, why == nullptr || std::string_view(why).find("dead") == std::string::npos);
    return 1;
}

int thread_index(lua_State* L) {
    return push_method(L, "a coroutine");
}

/// All coroutines share one metatable.
void open_methods(lua_State* L) {
    lua_newthread(L);
    lua_newtable(L);
    add_pure<thread_index>(L, "__index");
    lua_newtable(L);
    add_function<stop>(L, "stop");
    add_pure<active>(L, "active");
    lua_setfield(L, -2, "methods");
    name_metatable(L, "thread");
    lua_setmetatable(L, -2);
    lua_pop(L, 1);
}

}  // namespace

int resume_thread(lua_State* L, lua_State* thread, int arguments) {
    Machine& machine = machine_of(L);
    int results = 0;
    const int status = run_thread(L, thread, arguments, results);
    if (status <= LUA_YIELD) return results;
    complete_message(thread, thread, 0);
    machine.errors.thread_error = describe_error(machine, thread, 0, thread, -1);
    lua_xmove(thread, L, 1);
    // The same text as in the description, so that the outer message handler recognizes the error.
    if (lua_type(L, -1) == LUA_TSTRING) {
        const std::string& message = machine.errors.thread_error->message;
        push_text(L, message);
    }
    return lua_error(L);
}

void open_coroutines(lua_State* L) {
    machine_of(L).errors.raise_unchanged.push_back(guarded<call_wrapped>);
    lua_getfield(L, -1, "coroutine");
    add_pure<create>(L, "create");
    add_pure<resume>(L, "resume");
    add_pure<wrap>(L, "wrap");
    add_pure<close>(L, "close");
    lua_pop(L, 1);
    open_methods(L);
}

}  // namespace fettle::script
