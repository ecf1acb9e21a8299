#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <calls/function_ref.h>
#include <calls/held_memory.h>
#include <calls/protected.h>
#include <handlers/connections.h>
#include <handlers/coroutines.h>
#include <handlers/timers.h>
#include <limits/limiters.h>
#include <lua/environment.h>
#include <lua/exception_guard.h>
#include <lua/host.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <lua/runtime_lifetime.h>
#include <lua/stack.h>
#include <values/values.h>

namespace fettle::script {

namespace {

/// A timer is called at most this often in a step. The longest step has 10 000 of the shortest
/// intervals; more are due only after a jump of the time, as in a changed saved game.
constexpr double most_calls = 20'000;

/// The time when a repeated timer is due again. The interval starts when it was due, so that
/// intervals do not drift. 0 means every step, and so does an interval that is too short to be
/// added to the time.
double next_due(double due, double interval, double end, double tolerance) {
    const double from = std::max(due, end - most_calls * interval);
    const double next = from + interval;
    if (next > from) return next;
    constexpr double later = std::numeric_limits<double>::infinity();
    return std::max(end + 2 * tolerance, std::nextafter(end + tolerance, later));
}

}  // namespace

void Timers::note(Change change) {
    if (!noting_ || changes_.all) return;
    changes_.list.push_back(std::move(change));
    // The changes were not taken for a long time, or they are larger than the whole queue.
    if (changes_.list.size() > 64 + 2 * queue_.size()) {
        changes_.all = true;
        changes_.list.clear();
    }
}

void Timers::insert(const Key& key, Timer timer) {
    if (timer.function) note({key, timer});
    machine_.tree.add_weight(weight_of_timer);
    due_[key.second] = key.first;
    queue_.emplace(key, std::move(timer));
}

void Timers::erase(Queue::iterator entry) {
    if (entry->second.function) note({entry->first, std::nullopt});
    machine_.tree.add_weight(-weight_of_timer);
    due_.erase(entry->first.second);
    queue_.erase(entry);
}

/// A timer of the function at the top of the stack, which it pops.
Timers::Timer Timers::made(lua_State* L, double interval, Handle owner) {
    const std::size_t holds = noting_ ? held_memory(L, machine_, -1) : 0;
    std::string place = lua_iscfunction(L, -1) != 0 ? position(L) : "";
    if (place.ends_with(": ")) place.resize(place.size() - 2);
    const auto function = std::make_shared<FunctionRef>(L, machine_);
    function->set_given_at(std::move(place));
    function->set_holds(holds);
    return {.interval = interval,
            .function = function,
            .thread = LUA_NOREF,
            .owner = owner,
            .scene = machine_.globals.entering,
            .top = noting_top_};
}

std::uint64_t Timers::add_real(lua_State* L, double seconds, double interval, Handle owner) {
    const std::uint64_t id = next_id_++;
    Timer timer = made(L, interval, owner);
    timer.real = true;
    machine_.tree.add_weight(weight_of_timer);
    real_.insert({id, {seconds, std::move(timer)}});
    if (noting_top_) noted_.push_back({.id = id, .delay = seconds, .interval = interval});
    return id;
}

std::uint64_t Timers::add(lua_State* L, double seconds, double interval, Handle owner) {
    const std::uint64_t id = next_id_++;
    insert({now + seconds, id}, made(L, interval, owner));
    if (noting_top_) noted_.push_back({.id = id, .delay = seconds, .interval = interval});
    return id;
}

void Timers::add_at(lua_State* L, double due, double interval, Handle owner, Handle scene) {
    Timer timer = made(L, interval, owner);
    timer.scene = scene;
    insert({due, next_id_++}, std::move(timer));
}

void Timers::wait(lua_State* L, double seconds) {
    lua_pushthread(L);
    const std::uint64_t id = next_id_++;
    // A coroutine that belongs to neither a timer nor an instance is the scene's whose `enter` made
    // it wait.
    const Lifetime lifetime =
        lifetimes_.try_emplace(L, Lifetime{{}, machine_.globals.entering, id, false, noting_top_})
            .first->second;
    Timer timer{.interval = -1,
                .function = {},
                .thread = luaL_ref(L, LUA_REGISTRYINDEX),
                .owner = lifetime.owner,
                .scene = lifetime.scene,
                .top = lifetime.top,
                .begun = lifetime.begun,
                .real = lifetime.real};
    if (lifetime.real) {
        machine_.tree.add_weight(weight_of_timer);
        real_.insert({id, {seconds, std::move(timer)}});
    } else {
        insert({now + seconds, id}, std::move(timer));
    }
    waiting_[L] = id;
    if (!noting_top_) return;
    lua_pushthread(L);
    noted_.push_back({.thread = luaL_ref(L, LUA_REGISTRYINDEX)});
}

std::vector<Timers::Noted> Timers::end_noting() {
    noting_top_ = false;
    return std::exchange(noted_, {});
}

void Timers::end(const Noted& noted) {
    if (noted.thread == LUA_NOREF) return stop(noted.id);
    lua_State* const L = machine_.lua.main;
    push_registry(L, noted.thread);
    lua_State* const thread = lua_tothread(L, -1);
    lua_pop(L, 1);
    luaL_unref(L, LUA_REGISTRYINDEX, noted.thread);
    end_waiting(thread);
}

void Timers::end_waiting(lua_State* thread) {
    const auto found = waiting_.find(thread);
    if (found == waiting_.end()) return;
    const auto parked = std::ranges::find(parked_, found->second, &Parked::id);
    if (parked != parked_.end()) {
        const Timer timer = parked->timer;
        parked_.erase(parked);
        return forget(timer);
    }
    if (real_.contains(found->second)) return stop(found->second);
    const auto entry = queue_.find(Key{due_.at(found->second), found->second});
    const Timer timer = entry->second;
    erase(entry);
    forget(timer);
}

void Timers::replace(const Noted& old, const Noted& by) {
    const auto due = due_.find(old.id);
    const auto mine = due_.find(by.id);
    if (const auto before = real_.find(old.id); before != real_.end()) {
        const double rest = before->second.rest;
        stop(old.id);
        if (const auto after = real_.find(by.id); after != real_.end()) after->second.rest = rest;
        return;
    }
    if (due == due_.end()) return stop(by.id);
    const double when = due->second;
    stop(old.id);
    if (mine == due_.end()) return;
    const auto entry = queue_.find(Key{mine->second, by.id});
    const Timer timer = entry->second;
    erase(entry);
    insert({when, by.id}, timer);
}

std::vector<Handle> Timers::owners() const {
    std::vector<Handle> all;
    const auto add = [&](const Timer& timer) {
        for (const Handle each : {timer.owner, timer.scene})
            if (each) all.push_back(each);
    };
    for (const auto& [key, timer] : queue_) add(timer);
    for (const Parked& parked : parked_) add(parked.timer);
    for (const auto& [id, each] : real_) add(each.timer);
    return all;
}

void Timers::change_owner(Handle from, Handle to) {
    for (auto& [key, timer] : queue_)
        for (Handle* const each : {&timer.owner, &timer.scene})
            if (*each == from) *each = to;
    for (Parked& parked : parked_)
        for (Handle* const each : {&parked.timer.owner, &parked.timer.scene})
            if (*each == from) *each = to;
    for (auto& [id, each] : real_)
        for (Handle* const belongs_to : {&each.timer.owner, &each.timer.scene})
            if (*belongs_to == from) *belongs_to = to;
    for (auto& [thread, lifetime] : lifetimes_)
        for (Handle* const each : {&lifetime.owner, &lifetime.scene})
            if (*each == from) *each = to;
}

bool Timers::ended(const Timer& timer) const {
    const auto gone = [&](Handle each) { return each && !machine_.tree.alive(each); };
    return gone(timer.owner) || gone(timer.scene);
}

bool Timers::active(std::uint64_t id) const {
    if (const auto each = real_.find(id); each != real_.end()) return !ended(each->second.timer);
    const auto found = due_.find(id);
    return found != due_.end() && !ended(queue_.at(Key{found->second, id}));
}

void Timers::stop(std::uint64_t id) {
    if (const auto found = real_.find(id); found != real_.end()) {
        const Timer timer = found->second.timer;
        real_.erase(found);
        machine_.tree.add_weight(-weight_of_timer);
        return forget(timer);
    }
    const auto found = due_.find(id);
    if (found == due_.end()) return;
    const auto entry = queue_.find(Key{found->second, id});
    const Timer timer = entry->second;
    erase(entry);
    forget(timer);
}

void Timers::clear() {
    for (const auto& [key, timer] : queue_)
        if (!timer.function) luaL_unref(machine_.lua.main, LUA_REGISTRYINDEX, timer.thread);
    if (!machine_.life.tree.expired())
        machine_.tree.add_weight(-weight_of_timer * static_cast<std::int64_t>(size()));
    for (const auto& [id, each] : real_)
        if (!each.timer.function)
            luaL_unref(machine_.lua.main, LUA_REGISTRYINDEX, each.timer.thread);
    real_.clear();
    for (const Parked& parked : parked_)
        luaL_unref(machine_.lua.main, LUA_REGISTRYINDEX, parked.timer.thread);
    parked_.clear();
    ended_.clear();
    retired_.clear();
    queue_.clear();
    due_.clear();
    waiting_.clear();
    lifetimes_.clear();
    changes_ = {.all = noting_, .queue = {}, .list = {}};
}

bool Timers::run() {
    unpark();
    bool ok = true;
    const double end = now;
    // A new timer that is already due waits for the next step; otherwise this loop might never end.
    const std::uint64_t newest = next_id_;
    for (auto entry = queue_.begin();
         entry != queue_.end() && entry->first.first <= end + tolerance;) {
        const auto [due, id] = entry->first;
        if (id >= newest) {
            ++entry;
            continue;
        }
        const Timer timer = entry->second;
        erase(entry);
        if (ended(timer)) {
            forget(timer);
            entry = queue_.begin();
            continue;
        }
        if (timer.interval >= 0) {
            insert({next_due(due, timer.interval, end, tolerance), id}, timer);
        }
        ok &= fire(timer);
        if (machine_.limiters.watchdog.stopped()) break;
        entry = queue_.begin();
    }
    return ok;
}

/// A timer that is due calls its function once, however long the picture took.
bool Timers::advance_real(double seconds) {
    std::vector<std::pair<double, std::uint64_t>> due;
    for (auto& [id, each] : real_) {
        each.rest -= seconds;
        if (each.rest <= tolerance) due.emplace_back(each.rest, id);
    }
    std::ranges::sort(due);
    bool ok = true;
    for (const auto& [rest, id] : due) {
        ok &= run_real(id);
        if (machine_.limiters.watchdog.stopped()) break;
    }
    return ok;
}

bool Timers::run_real(std::uint64_t id) {
    const auto found = real_.find(id);
    if (found == real_.end()) return true;  // another one has stopped it
    const Timer timer = found->second.timer;
    const bool over = ended(timer);
    if (timer.interval >= 0 && !over) {
        found->second.rest = std::max(0.0, found->second.rest + timer.interval);
    } else {
        real_.erase(found);
        machine_.tree.add_weight(-weight_of_timer);
    }
    if (!over) return fire(timer);
    forget(timer);
    return true;
}

int Timers::idle_thread() {
    if (!idle_.empty()) {
        const int reference = idle_.back();
        idle_.pop_back();
        return reference;
    }
    lua_newthread(machine_.lua.main);
    return luaL_ref(machine_.lua.main, LUA_REGISTRYINDEX);
}

/// To be called for a waiting thread that is not continued.
void Timers::forget(const Timer& timer) {
    if (timer.function) return;
    lua_State* L = machine_.lua.main;
    push_registry(L, timer.thread);
    lua_State* thread = lua_tothread(L, -1);
    lua_pop(L, 1);
    waiting_.erase(thread);
    lifetimes_.erase(thread);
    luaL_unref(L, LUA_REGISTRYINDEX, timer.thread);
}

void Timers::resume(lua_State* L, lua_State* thread, int arguments, Lifetime lifetime) {
    lifetimes_[thread] = lifetime;
    const auto forget_lifetime = [&] {
        if (!waiting_.contains(thread)) lifetimes_.erase(thread);
    };
    try {
        resume_thread(L, thread, arguments);
    } catch (...) {
        forget_lifetime();
        throw;
    }
    forget_lifetime();
    if (lua_status(thread) == LUA_YIELD && !waiting_.contains(thread)) note_yield(thread);
}

/// `coroutine.yield()` in a function of a timer: nothing resumes it by itself.
void Timers::note_yield(lua_State* thread) {
    const auto sink = machine_.host.on_note;
    if (std::exchange(noted_yield_, true) || !sink) return;
    sink(position(thread) +
         "after coroutine.yield() only coroutine.resume goes on; wait(0) waits for the next step");
}

void Timers::start(lua_State* L, Handle owner) {
    lua_State* thread = lua_newthread(L);
    lua_insert(L, -2);
    push_instance(L, owner);
    lua_xmove(L, thread, 2);
    resume(L, thread, 1, {owner, machine_.globals.entering, next_id_, false, noting_top_});
}

// Runs a function as a coroutine, so that it can wait.
bool Timers::fire(const Timer& timer) {
    std::string what = timer.function ? "timer" : "coroutine";
    if (timer.function && !timer.function->given_at().empty())
        what += " of " + timer.function->given_at();
    const Context context(what, timer.owner);
    return protected_run(machine_, context, [&](lua_State* L) {
        if (!timer.function) {
            push_registry(L, timer.thread);
            lua_State* thread = lua_tothread(L, -1);
            luaL_unref(L, LUA_REGISTRYINDEX, timer.thread);
            waiting_.erase(thread);
            resume(L, thread, 0, {timer.owner, timer.scene, timer.begun, timer.real, timer.top});
            if (!waiting_.contains(thread) && !timer.real) {
                constexpr std::size_t most_ended = 1000;
                ended_.push_back({timer.begun, now});
                if (ended_.size() > most_ended) ended_.pop_front();
            }
            return;
        }
        const int reference = idle_thread();
        push_registry(L, reference);
        lua_State* thread = lua_tothread(L, -1);
        timer.function->push(L);
        if (timer.owner) push_instance(L, timer.owner);
        const int arguments = timer.owner ? 1 : 0;
        lua_xmove(L, thread, 1 + arguments);
        // A thread that waits or failed is left to the garbage collector; a finished one is reused.
        try {
            resume(L, thread, arguments,
                   {timer.owner, timer.scene, next_id_, timer.real, timer.top});
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

}  // namespace fettle::script
