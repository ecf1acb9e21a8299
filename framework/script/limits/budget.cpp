#include <algorithm>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <utility>

#include <fettle/script/runtime.h>

#include <limits/budget.h>
#include <limits/limiters.h>
#include <lua/exception_guard.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <lua/runtime_lifetime.h>
#include <lua/stack.h>

namespace fettle::script {

namespace {

// Bytes; the tree reports its growth in portions of this size.
constexpr std::int64_t growth_slice = 256 * 1024;

std::size_t added(std::size_t now, std::size_t before) {
    return now - std::min(now, before);
}

std::string megabytes(std::size_t bytes) {
    return std::to_string((bytes + (std::size_t{1} << 19)) >> 20) + " MB";
}

// Whether Lua requests memory for a larger stack of `L`. Since version 5.4.5, the frames then have
// offsets in place of addresses, and lua_getinfo, which uses them as addresses, ends the program.
// No function of Lua returns this, but the first member of a frame is the position of its function,
// and every offset is smaller than the largest stack (a million slots of 16 bytes).
bool stack_grows(lua_State* L) {
    constexpr std::uintptr_t largest_stack = std::uintptr_t{1} << 25;
    lua_Debug frame;
    if (!lua_getstack(L, 0, &frame)) return false;
    std::uintptr_t function;
    std::memcpy(&function, frame.i_ci, sizeof function);
    return function < largest_stack;
}

}  // namespace

Budget::Budget(Machine& machine) : machine_(machine), first_weight_(machine.tree.weight()) {}

std::optional<Limits> Budget::of_call() const {
    const GameLimits& limits = machine_.options.limits;
    if (now_.active || !machine_.life.has_tree() ||
        (limits.instructions == 0 && limits.memory == 0))
        return std::nullopt;
    const std::size_t whole = limits.memory == 0 ? machine_.options.memory_limit : limits.memory;
    const std::int64_t grown = machine_.tree.weight() - first_weight_;
    const std::size_t used = machine_.limiters.arena.bytes() +
                             static_cast<std::size_t>(std::max<std::int64_t>(0, grown));
    return Limits{.instructions = limits.instructions,
                  .memory = whole - std::min(whole, used),
                  .whole = whole,
                  .subject = "the scripts of a game",
                  .seconds = machine_.limiters.watchdog.limited()
                                 ? machine_.limiters.watchdog.limit_seconds()
                                 : Limits{}.seconds};
}

Budget::Scope::Scope(Budget& budget, const Limits& limits)
    : budget_(budget), outer_(std::exchange(budget.now_, {})) {
    Machine& machine = budget.machine_;
    Account& now = budget.now_;
    now.active = true;
    now.counting = limits.instructions > 0;
    now.instructions = limits.instructions;
    now.left = static_cast<std::int64_t>(
        std::min<std::uint64_t>(limits.instructions, std::uint64_t{1} << 62));
    now.seconds = limits.seconds;
    now.deadline = std::chrono::steady_clock::now() +
                   std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                       std::chrono::duration<double>(std::min(limits.seconds, 1e6)));
    now.outer_limit = machine.limiters.arena.limit();
    now.memory = std::min(limits.memory, now.outer_limit);
    now.whole = limits.whole;
    now.subject = limits.subject;
    now.raised_by = limits.raised_by;
    now.lua_before = machine.limiters.arena.bytes();
    now.weight_before = machine.tree.weight();
    now.instances_before = machine.tree.size();
    now.watchers_before = machine.tree.watcher_count();
    machine.limiters.arena.set_limit(std::min(now.outer_limit, now.lua_before + now.memory));
    // Many calls that let the tree grow a little are noticed as one that lets it grow much.
    if (machine.life.has_tree())
        budget.mark_at(std::min(budget.mark_, machine.tree.weight() + growth_slice));
    if (now.counting) lua_sethook(machine.lua.main, hook, LUA_MASKCOUNT, interval);
}

Budget::Scope::~Scope() {
    Machine& machine = budget_.machine_;
    machine.limiters.arena.set_limit(budget_.now_.outer_limit);
    budget_.now_ = std::move(outer_);
    if (budget_.now_.active)
        budget_.mark_next();
    else
        budget_.limit_tree();
    if (budget_.interrupted()) {
        arm(machine.lua.main);
        return;
    }
    lua_sethook(machine.lua.main, budget_.now_.counting ? hook : nullptr,
                budget_.now_.counting ? LUA_MASKCOUNT : 0, budget_.now_.counting ? interval : 0);
}

void Budget::hook(lua_State* L, lua_Debug*) {
    Machine& machine = machine_of(L);
    Budget& budget = machine.limiters.budget;
    Account& now = budget.now_;
    budget.stop_if_interrupted(L);
    budget.refuse_grown_stack(L);
    if (!now.counting && !now.stopping) {
        // A coroutine that outlives its command, or a call that takes long.
        lua_sethook(L, nullptr, 0, 0);
        guard(L, [&] { machine.limiters.watchdog.check_if_due(L); });
        if (!now.stopping) return;
    }
    if (!now.stopping) {
        // Otherwise a nested budget stopped its script and left the hook at every instruction, or
        // the watchdog reads the time, since functions of the host may take long.
        if (lua_gethookcount(L) == interval)
            now.left -= interval;
        else
            lua_sethook(L, hook, LUA_MASKCOUNT, interval);
        const bool late = std::chrono::steady_clock::now() > now.deadline;
        if (now.left >= 0 && !late) return;
        budget.stop(L, late ? budget.too_late()
                            : "stopped: it ran past its budget of " +
                                  std::to_string(now.instructions) + " instructions");
    }
    lua_sethook(L, hook, LUA_MASKCOUNT, 1);
    budget.raise_stop(L);
}

void Budget::stop(lua_State* L, const std::string& why) {
    if (now_.stopping) return;
    now_.stopping = true;
    lua_Debug frame;
    for (int level = 0; lua_getstack(L, level, &frame); ++level) {
        lua_getinfo(L, "Sl", &frame);
        if (frame.currentline <= 0) continue;
        now_.file = frame.short_src;
        now_.line = frame.currentline;
        break;
    }
    now_.reason =
        (now_.line > 0 ? now_.file + ":" + std::to_string(now_.line) + ": " : std::string()) + why;
    arm(machine_.lua.running);
}

void Budget::call_ended() {
    if (!now_.stopping || now_.active || interrupted()) return;
    now_ = {};
    lua_sethook(machine_.lua.main, nullptr, 0, 0);
}

void Budget::interrupt() noexcept {
    interrupted_ = 1;
    if (machine_.lua.running != nullptr) arm(machine_.lua.running);
}

void Budget::go_on() {
    interrupted_ = 0;
    if (now_.active) return;
    now_ = {};
    lua_sethook(machine_.lua.main, nullptr, 0, 0);
}

void Budget::arm(lua_State* running) noexcept {
    lua_sethook(running, hook, LUA_MASKCOUNT, 1);
}

void Budget::raise_stop(lua_State* L) {
    push_text(L, now_.reason);
    lua_error(L);
    std::terminate();  // not reached
}

void Budget::charge(lua_State* L, std::uint64_t instructions) {
    stop_if_interrupted(L);
    if (!now_.counting && !now_.stopping) {
        machine_.limiters.watchdog.check_if_due(L);
        check(L);
        return;
    }
    charge_quietly(instructions);
    check(L);
}

void Budget::charge_by_the_clock(lua_State* L, std::uint64_t instructions) {
    if (now_.counting && !now_.stopping && std::chrono::steady_clock::now() > now_.deadline)
        stop(L, too_late());
    charge(L, instructions);
}

std::string Budget::too_late() const {
    return "stopped: it ran for " + property::number_text(now_.seconds) + " seconds";
}

void Budget::charge_quietly(std::uint64_t instructions) {
    if (!now_.counting || now_.stopping) return;
    now_.left -=
        static_cast<std::int64_t>(std::min<std::uint64_t>(instructions, std::uint64_t{1} << 61));
    // While the stack grows, the place cannot be read; the hook stops the script a little later.
    if (now_.left >= 0 || stack_grows(machine_.lua.running)) return;
    stop(machine_.lua.running, "stopped: it ran past its budget of " +
                                   std::to_string(now_.instructions) + " instructions");
}

// --- Memory

std::string Budget::out_of_memory(const Refused& refused) {
    if (refused.what.text)
        return "a text would have " + std::to_string(refused.what.size) +
               " bytes, and the texts of this game may have " + megabytes(refused.limit);
    return "not enough memory: " + std::to_string(refused.what.size) +
           " bytes more were asked for, and " +
           (refused.what.by_system ? std::string("the system has none to give")
                                   : refused.subject + std::string(" may use ") +
                                         std::to_string(refused.limit >> 20) + " MB");
}

/// Describes a refusal without allocating memory.
Budget::Refused Budget::describe(const Arena::Refusal& refusal) const {
    const bool whole = machine_.limiters.arena.limit() >= machine_.options.memory_limit;
    Refused refused = {.what = refusal,
                       .limit = refusal.text ? machine_.limiters.arena.longest_text()
                                : whole      ? machine_.options.memory_limit
                                             : now_.memory,
                       .subject = whole ? "the scripts of a game" : now_.subject};
    lua_Debug frame;
    for (int level = 0; lua_getstack(machine_.lua.running, level, &frame); ++level) {
        lua_getinfo(machine_.lua.running, "Sl", &frame);
        if (frame.currentline <= 0) continue;
        std::copy(std::begin(frame.short_src), std::end(frame.short_src), refused.file);
        refused.line = frame.currentline;
        break;
    }
    return refused;
}

// Lua's own error contains neither place nor reason and calls no message handler. If the limit is
// not that of the whole game, the script is stopped for good: otherwise it could catch the error
// forever.
bool Budget::memory_refused(const Arena::Refusal& refusal) {
    if (now_.stopping) return true;
    if (stack_grows(machine_.lua.running)) {
        if (refusal.by_system) return true;
        grown_stack_ = refusal;
        arm(machine_.lua.running);
        return false;
    }
    refused_ = describe(refusal);
    const bool own_limit = machine_.limiters.arena.limit() < machine_.options.memory_limit;
    if (!now_.active || !refusal.final || !(own_limit || now_.counting)) return true;
    stop(machine_.lua.running, refusal.by_system || refusal.text
                                   ? "stopped: " + out_of_memory(refused_)
                                   : too_much_memory());
    now_.memory_exceeded = true;
    return true;
}

// A stack can exceed the limit by 16 MB until here. Lua did not collect for it, so this function
// does.
void Budget::refuse_grown_stack(lua_State* L) {
    Arena::Refusal refusal = std::exchange(grown_stack_, {});
    if (refusal.size == 0 || now_.stopping) return;
    lua_gc(L, LUA_GCCOLLECT);
    if (machine_.limiters.arena.bytes() <= machine_.limiters.arena.limit()) return;
    refusal.final = true;
    memory_refused(refusal);
    if (now_.stopping) return;
    push_text(L, take_refusal());
    lua_error(L);
}

std::string Budget::take_refusal() {
    const Refused refused = std::exchange(refused_, {});
    if (refused.what.size == 0) return {};
    const std::string place =
        refused.line > 0 ? std::string(refused.file) + ":" + std::to_string(refused.line) + ": "
                         : "";
    return place + out_of_memory(refused);
}

// Memory of instances and watchers is subtracted from Lua's limit, so that both have one common
// limit.
void Budget::notice_growth() {
    if (!now_.active || now_.stopping) return;
    Arena& arena = machine_.limiters.arena;
    const auto grown = static_cast<std::size_t>(
        std::max<std::int64_t>(0, machine_.tree.weight() - now_.weight_before));
    if (grown + added(arena.bytes(), now_.lua_before) > now_.memory) {
        stop(machine_.lua.running, too_much_memory());
        now_.memory_exceeded = true;
        return;
    }
    if (passed_limit)
        if (const std::string why = passed_limit(); !why.empty()) {
            stop(machine_.lua.running, "stopped: " + why);
            now_.memory_exceeded = true;
            return;
        }
    arena.set_limit(std::min(now_.outer_limit, now_.lua_before + now_.memory - grown));
    mark_next();
}

// Without an account for each call, which would make all calls slower. What the host adds is no
// script's fault, so it stops the next script that adds something.
void Budget::limit_tree() {
    if (!machine_.life.has_tree()) return;
    const std::size_t limit = machine_.options.limits.tree;
    if (limit == 0) {
        machine_.tree.mark_weight(INT64_MAX, {});
        return;
    }
    const std::int64_t most =
        first_weight_ + static_cast<std::int64_t>(std::min(limit, std::size_t{INT64_MAX / 2}));
    const std::int64_t next = std::max(most, machine_.tree.weight() + growth_slice);
    machine_.tree.mark_weight(next, [this] {
        limit_tree();
        lua_Debug frame;
        lua_State* const running = machine_.lua.running;
        if (now_.stopping || lua_getstack(running, 0, &frame) == 0) return;
        const GameLimits& limits = machine_.options.limits;
        stop(running,
             "stopped: it needs more memory than the scripts of a game may add to it, " +
                 megabytes(limits.tree) + "; " + instances_and_memory() +
                 (limits.tree_setting.empty() ? ""
                                              : " (" + limits.tree_setting + " raises the limit)"));
        now_.memory_exceeded = true;
    });
}

std::string Budget::instances_and_memory() const {
    const property::Tree& tree = machine_.tree;
    const std::int64_t grown = std::max<std::int64_t>(0, tree.weight() - first_weight_);
    return std::to_string(tree.size()) + " instances and what belongs to them have " +
           megabytes(static_cast<std::size_t>(grown));
}

void Budget::mark_next() {
    if (machine_.life.has_tree()) mark_at(machine_.tree.weight() + growth_slice);
}

void Budget::mark_at(std::int64_t weight) {
    mark_ = weight;
    machine_.tree.mark_weight(weight, [this] { notice_growth(); });
}

std::string Budget::too_much_memory() const {
    std::string text = "stopped: it needs more memory than " + std::string(now_.subject) +
                       " may use, " + megabytes(now_.whole != 0 ? now_.whole : now_.memory);
    if (!machine_.life.has_tree()) return text;
    const property::Tree& tree = machine_.tree;
    if (now_.whole != 0)
        return text + "; Lua has " + megabytes(machine_.limiters.arena.bytes()) + ", and " +
               instances_and_memory();
    std::string made;
    const auto report_count = [&made](std::size_t count, const char* what) {
        if (count > 0) made += (made.empty() ? "" : ", ") + std::to_string(count) + " " + what;
    };
    report_count(added(tree.size(), now_.instances_before), "instances");
    report_count(added(tree.watcher_count(), now_.watchers_before), "watchers");
    const std::int64_t grown = tree.weight() - now_.weight_before;
    if (grown > 0)
        made += (made.empty() ? "" : ", ") + megabytes(static_cast<std::size_t>(grown)) +
                " in the tree";
    made += (made.empty() ? "" : ", ") +
            megabytes(added(machine_.limiters.arena.bytes(), now_.lua_before)) + " of Lua";
    text += "; it made " + made;
    if (!now_.raised_by.empty()) text += " (" + now_.raised_by + " raises the limit)";
    return text;
}

// --- Coroutines

void Budget::enter(lua_State* thread) {
    if (!now_.counting && !now_.stopping && !interrupted()) return;
    charge_quietly(500);
    lua_sethook(thread, hook, LUA_MASKCOUNT, now_.stopping || interrupted() ? 1 : interval);
}

void Budget::check(lua_State* L) {
    if (now_.stopping) raise_stop(L);
}

}  // namespace fettle::script
