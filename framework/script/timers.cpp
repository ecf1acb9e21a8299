#include "timers.h"

#include <cmath>

#include <fettle/property/error.h>

#include "coroutines.h"
#include "errors.h"
#include "guard.h"
#include "machine.h"
#include "protected.h"
#include "subscriptions.h"

namespace fettle::script {

using property::Error;
using property::ErrorKind;

namespace {

// Sums of steps are not exact; what is due within this of a step's end is due in it. Seconds.
constexpr double tolerance = 1e-9;
// A shorter interval would fire many hundred times a step.
constexpr double shortest_interval = 1e-4;

}  // namespace

std::uint64_t Timers::add(lua_State* L, double due, double interval) {
    const std::uint64_t id = next_id_++;
    Timer timer;
    timer.interval = interval;
    timer.reference = luaL_ref(L, LUA_REGISTRYINDEX);
    queue_.emplace(Key{due, id}, timer);
    due_.emplace(id, due);
    return id;
}

void Timers::wait(lua_State* L, double due) {
    lua_pushthread(L);
    const std::uint64_t id = add(L, due, -1);
    queue_.find(Key{due, id})->second.thread = true;
    waiting_[L] = id;
}

void Timers::stop(std::uint64_t id) {
    const auto found = due_.find(id);
    if (found == due_.end()) return;
    const auto entry = queue_.find(Key{found->second, id});
    luaL_unref(machine_.main, LUA_REGISTRYINDEX, entry->second.reference);
    queue_.erase(entry);
    due_.erase(found);
}

void Timers::clear() {
    for (const auto& [key, timer] : queue_)
        luaL_unref(machine_.main, LUA_REGISTRYINDEX, timer.reference);
    queue_.clear();
    due_.clear();
    waiting_.clear();
}

bool Timers::run(double now) {
    bool ok = true;
    // What is added meanwhile and due at once waits for the next step, or it could go on forever.
    const std::uint64_t newest = next_id_;
    for (auto entry = queue_.begin();
         entry != queue_.end() && entry->first.first <= now + tolerance;) {
        const auto [due, id] = entry->first;
        if (id >= newest) {
            ++entry;
            continue;
        }
        const Timer timer = entry->second;
        queue_.erase(entry);
        due_.erase(id);
        if (timer.interval >= 0) {
            // From the moment it was due, so that intervals do not drift; 0 is every step.
            const double next = timer.interval > 0 ? due + timer.interval : now + 2 * tolerance;
            queue_.emplace(Key{next, id}, timer);
            due_.emplace(id, next);
        }
        ok &= fire(timer);
        entry = queue_.begin();
    }
    return ok;
}

int Timers::take_thread() {
    if (!idle_.empty()) {
        const int reference = idle_.back();
        idle_.pop_back();
        return reference;
    }
    lua_newthread(machine_.main);
    return luaL_ref(machine_.main, LUA_REGISTRYINDEX);
}

// Functions run as coroutines, so that they can wait.
bool Timers::fire(const Timer& timer) {
    return protected_run(machine_, timer.thread ? "coroutine" : "timer", [&](lua_State* L) {
        if (timer.thread) {
            push_registry(L, timer.reference);
            lua_State* thread = lua_tothread(L, -1);
            luaL_unref(L, LUA_REGISTRYINDEX, timer.reference);
            waiting_.erase(thread);
            resume_thread(L, thread, 0);
            return;
        }
        const int reference = take_thread();
        push_registry(L, reference);
        lua_State* thread = lua_tothread(L, -1);
        push_registry(L, timer.reference);
        if (timer.interval < 0) luaL_unref(L, LUA_REGISTRYINDEX, timer.reference);
        lua_xmove(L, thread, 1);
        // A thread that waits or failed is left to the collector; one that finished is used again.
        try {
            resume_thread(L, thread, 0);
        } catch (...) {
            luaL_unref(L, LUA_REGISTRYINDEX, reference);
            throw;
        }
        if (lua_status(thread) == LUA_OK) {
            lua_settop(thread, 0);
            idle_.push_back(reference);
        } else {
            luaL_unref(L, LUA_REGISTRYINDEX, reference);
        }
    });
}

namespace {

double seconds_at(lua_State* L, const char* what) {
    const double seconds = check_number(L, 1, what);
    if (!(seconds >= 0) || std::isinf(seconds))
        throw Error(ErrorKind::out_of_range, std::string(what) + ": " +
                                                 property::number_text(seconds) +
                                                 " s; a time is finite and not negative");
    return seconds;
}

int timer(lua_State* L, const char* what, bool repeated) {
    const double seconds = seconds_at(L, what);
    if (repeated && seconds > 0 && seconds < shortest_interval)
        throw Error(ErrorKind::out_of_range,
                    "every: " + property::number_text(seconds) +
                        " s is shorter than 0.0001 s; every(0, ...) is each step");
    if (lua_type(L, 2) != LUA_TFUNCTION)
        throw Error(ErrorKind::wrong_type,
                    std::string(what) + ": needs a function, not " + describe_type(L, 2));
    lua_settop(L, 2);
    Machine& machine = machine_of(L);
    push_timer_connection(L, machine.timers.add(L, machine.now + seconds, repeated ? seconds : -1));
    return 1;
}

int after(lua_State* L) {
    return timer(L, "after", false);
}
int every(lua_State* L) {
    return timer(L, "every", true);
}

int wait(lua_State* L) {
    const double seconds = lua_gettop(L) == 0 ? 0 : seconds_at(L, "wait");
    if (!lua_isyieldable(L))
        throw Error(ErrorKind::bad_structure,
                    "wait: works inside a coroutine or a function given to after; here, use "
                    "after(seconds, function)");
    Machine& machine = machine_of(L);
    machine.timers.wait(L, machine.now + seconds);
    return lua_yield(L, 0);
}

}  // namespace

void open_timers(lua_State* L) {
    add_function<after>(L, "after");
    add_function<every>(L, "every");
    add_function<wait>(L, "wait");
}

}  // namespace fettle::script
