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
#include <lua/environment.h>
#include <lua/guard.h>
#include <lua/interpreter.h>
#include <lua/life.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <lua/watchdog.h>
#include <values/values.h>

namespace fettle::script {

namespace {

// s; sums of steps have rounding errors, so timers that are due this soon after a step's end count
// as due.
constexpr double tolerance = 1e-9;
// s; a shorter interval would call the function many hundred times in a step.
constexpr double shortest_interval = 1e-4;
/// A timer is called at most this often in a step. The longest step has 10 000 of the shortest
/// intervals; more are due only after a jump of the time, as in a changed saved game.
constexpr double most_calls = 20'000;
constexpr std::int64_t weight_of_timer = 300;  // bytes, estimated

/// The time when a repeated timer is due again. The interval starts when it was due, so that
/// intervals do not drift. 0 means every step, and so does an interval that is too short to be
/// added to the time.
double next_due(double due, double interval, double end) {
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

std::uint64_t Timers::add(lua_State* L, double due, double interval, Handle owner) {
    const std::uint64_t id = next_id_++;
    const std::size_t holds = noting_ ? held_memory(L, machine_, -1) : 0;
    std::string place = lua_iscfunction(L, -1) != 0 ? position(L) : "";
    if (place.ends_with(": ")) place.resize(place.size() - 2);
    const auto function = std::make_shared<FunctionRef>(L, machine_);
    function->set_given_at(std::move(place));
    function->set_holds(holds);
    insert({due, id}, {.interval = interval,
                       .function = function,
                       .thread = LUA_NOREF,
                       .owner = owner,
                       .scene = machine_.globals.entering,
                       .top = noting_top_});
    if (noting_top_) noted_.push_back({.id = id, .delay = due - now, .interval = interval});
    return id;
}

void Timers::wait(lua_State* L, double due) {
    lua_pushthread(L);
    const std::uint64_t id = next_id_++;
    // A coroutine that is no timer's and no instance's is the scene's whose `enter` made it wait.
    const Lifetime lifetime =
        lifetimes_.try_emplace(L, Lifetime{{}, machine_.globals.entering, id}).first->second;
    insert({due, id}, {.interval = -1,
                       .function = {},
                       .thread = luaL_ref(L, LUA_REGISTRYINDEX),
                       .owner = lifetime.owner,
                       .scene = lifetime.scene,
                       .begun = lifetime.begun});
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
    const auto found = waiting_.find(thread);
    if (found == waiting_.end()) return;
    const auto parked = std::ranges::find(parked_, found->second, &Parked::id);
    if (parked != parked_.end()) {
        const Timer timer = parked->timer;
        parked_.erase(parked);
        return forget(timer);
    }
    const auto entry = queue_.find(Key{due_.at(found->second), found->second});
    const Timer timer = entry->second;
    erase(entry);
    forget(timer);
}

void Timers::take_place(const Noted& old, const Noted& by) {
    const auto due = due_.find(old.id);
    const auto mine = due_.find(by.id);
    if (due == due_.end()) return stop(by.id);
    const double when = due->second;
    stop(old.id);
    if (mine == due_.end()) return;
    const auto entry = queue_.find(Key{mine->second, by.id});
    const Timer timer = entry->second;
    erase(entry);
    insert({when, by.id}, timer);
}

void Timers::give_owner(Handle from, Handle to) {
    for (auto& [key, timer] : queue_)
        for (Handle* const each : {&timer.owner, &timer.scene})
            if (*each == from) *each = to;
    for (Parked& parked : parked_)
        for (Handle* const each : {&parked.timer.owner, &parked.timer.scene})
            if (*each == from) *each = to;
    for (auto& [thread, lifetime] : lifetimes_)
        for (Handle* const each : {&lifetime.owner, &lifetime.scene})
            if (*each == from) *each = to;
}

bool Timers::ended(const Timer& timer) const {
    const auto gone = [&](Handle each) { return each && !machine_.tree.alive(each); };
    return gone(timer.owner) || gone(timer.scene);
}

bool Timers::active(std::uint64_t id) const {
    const auto found = due_.find(id);
    return found != due_.end() && !ended(queue_.at(Key{found->second, id}));
}

void Timers::stop(std::uint64_t id) {
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
        machine_.tree.add_weight(-weight_of_timer *
                                 static_cast<std::int64_t>(queue_.size() + parked_.size()));
    for (const Parked& parked : parked_)
        luaL_unref(machine_.lua.main, LUA_REGISTRYINDEX, parked.timer.thread);
    parked_.clear();
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
            insert({next_due(due, timer.interval, end), id}, timer);
        }
        ok &= fire(timer);
        if (machine_.watchdog.stopped()) break;
        entry = queue_.begin();
    }
    return ok;
}

// --- Snapshots

Timers::Queue Timers::image() const {
    Queue functions;
    for (const auto& [key, timer] : queue_)
        if (timer.function) functions.emplace_hint(functions.end(), key, timer);
    return functions;
}

void Timers::restore(const Queue& image, double to, std::uint64_t next) {
    park();
    // What a reload began later than the moment stands for what it replaced: it goes on for the
    // rest of its time.
    Queue after_reload;
    for (const auto& [key, timer] : queue_)
        if (timer.top && key.second >= next && !ended(timer))
            after_reload.emplace(Key{key.first - now + to, key.second}, timer);
    queue_ = image;
    std::erase_if(queue_, [&](const auto& each) { return retired_.contains(each.first.second); });
    queue_.merge(after_reload);
    due_.clear();
    for (const auto& [key, timer] : queue_) due_.emplace(key.second, key.first);
    changes_ = {.all = noting_, .queue = {}, .list = {}};
    now = parked_until_ = to;
    parked_from_ = next;
}

void Timers::restore_from_file(double to) {
    Queue image;
    for (const auto& [key, timer] : queue_)
        if (timer.function && timer.top && !ended(timer))
            image.emplace(Key{key.first - now + to, key.second}, timer);
    restore(image, to, next_id_);
}

void Timers::park() {
    for (auto entry = queue_.begin(); entry != queue_.end();) {
        const auto here = entry++;
        if (here->second.function) continue;
        parked_.push_back({here->first.first - now, here->first.second, here->second});
        queue_.erase(here);
    }
}

void Timers::unpark() {
    for (Parked& parked : std::exchange(parked_, {})) {
        if (parked.timer.begun < parked_from_) {
            const Key key{parked_until_ + parked.rest, parked.id};
            due_[key.second] = key.first;
            queue_.emplace(key, std::move(parked.timer));
        } else {
            machine_.tree.add_weight(-weight_of_timer);
            forget(parked.timer);
        }
    }
}

namespace {
// Size of a map node with an estimate of the allocator's overhead.
constexpr std::size_t timer_size = sizeof(Timers::Queue::value_type) + 48;
}  // namespace

std::size_t Timers::bytes_of(const Queue& image) {
    return image.size() * timer_size;
}

std::size_t Timers::bytes_of(const Changes& changes) {
    std::size_t sum = bytes_of(changes.queue) + changes.list.capacity() * sizeof(Change);
    for (const Change& change : changes.list)
        if (change.added) sum += change.added->function->holds();
    return sum;
}

Timers::Changes Timers::take_changes() {
    Changes taken = std::exchange(changes_, {});
    if (taken.all || !noting_) {
        taken.all = true;
        taken.queue = image();
    }
    noting_ = true;
    taken.next = next_id_;
    return taken;
}

void Timers::redo(const Changes& changes, double to) {
    if (changes.all) return restore(changes.queue, to, changes.next);
    now = parked_until_ = to;
    parked_from_ = changes.next;
    for (const Change& change : changes.list) {
        if (!change.added) {
            if (const auto entry = queue_.find(change.key); entry != queue_.end()) erase(entry);
            continue;
        }
        if (retired_.contains(change.key.second)) continue;
        // One of a reload went on from an earlier moment, where it did not belong yet.
        if (const auto early = due_.find(change.key.second); early != due_.end())
            erase(queue_.find(Key{early->second, early->first}));
        insert(change.key, *change.added);
    }
}

int Timers::take_thread() {
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
}

void Timers::start(lua_State* L, Handle owner) {
    lua_State* thread = lua_newthread(L);
    lua_insert(L, -2);
    push_instance(L, owner);
    lua_xmove(L, thread, 2);
    resume(L, thread, 1, {owner, machine_.globals.entering, next_id_});
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
            resume(L, thread, 0, {timer.owner, timer.scene, timer.begun});
            return;
        }
        const int reference = take_thread();
        push_registry(L, reference);
        lua_State* thread = lua_tothread(L, -1);
        timer.function->push(L);
        if (timer.owner) push_instance(L, timer.owner);
        const int arguments = timer.owner ? 1 : 0;
        lua_xmove(L, thread, 1 + arguments);
        // A thread that waits or failed is left to the garbage collector; a finished one is reused.
        try {
            resume(L, thread, arguments, {timer.owner, timer.scene, next_id_});
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

/// The arguments are seconds and a function.
int timer(lua_State* L, const char* what, bool repeated, Handle owner = {}) {
    const double seconds = check_seconds(L, what);
    if (repeated && seconds > 0 && seconds < shortest_interval)
        throw Error(ErrorKind::out_of_range,
                    "every: " + property::number_text(seconds) +
                        " s is shorter than 0.0001 s; every(0, ...) is each step");
    check_function(L, 2, what);
    lua_settop(L, 2);
    Machine& machine = machine_of(L);
    push_timer_connection(
        L, machine.timers.add(L, machine.timers.now + seconds, repeated ? seconds : -1, owner));
    return 1;
}

int after(lua_State* L) {
    return timer(L, "after", false);
}
int every(lua_State* L) {
    return timer(L, "every", true);
}

int wait(lua_State* L) {
    const double seconds = lua_gettop(L) == 0 ? 0 : check_seconds(L, "wait");
    if (!lua_isyieldable(L))
        throw Error(ErrorKind::bad_structure,
                    "wait: works inside a coroutine or a function given to after; here, use "
                    "after(seconds, function)");
    Machine& machine = machine_of(L);
    machine.timers.wait(L, machine.timers.now + seconds);
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
