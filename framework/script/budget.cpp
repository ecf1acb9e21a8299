#include "budget.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "machine.h"

namespace fettle::script {

void Budget::begin(std::uint64_t instructions, std::size_t memory) {
    active_ = true;
    stopping_ = false;
    instructions_ = instructions;
    left_ =
        static_cast<std::int64_t>(std::min<std::uint64_t>(instructions, std::uint64_t{1} << 62));
    deadline_ = std::chrono::steady_clock::now() + longest;
    reason_.clear();
    file_.clear();
    line_ = 0;
    Arena& arena = machine_.arena;
    outer_limit_ = arena.limit();
    const std::size_t used = arena.bytes();
    memory_limit_ =
        memory < outer_limit_ && used < outer_limit_ - memory ? used + memory : outer_limit_;
    arena.set_limit(memory_limit_);
    lua_sethook(machine_.main, hook, LUA_MASKCOUNT, interval);
}

void Budget::end() {
    active_ = false;
    stopping_ = false;
    machine_.arena.set_limit(outer_limit_);
    lua_sethook(machine_.main, nullptr, 0, 0);
}

void Budget::hook(lua_State* L, lua_Debug*) {
    Budget& budget = machine_of(L).budget;
    budget.stop_if_interrupted(L);
    if (!budget.active_ && !budget.stopping_) {
        lua_sethook(L, nullptr, 0, 0);  // a coroutine that outlived the command it was made in
        return;
    }
    if (!budget.stopping_) {
        budget.left_ -= interval;
        const bool late = std::chrono::steady_clock::now() > budget.deadline_;
        if (budget.left_ >= 0 && !late) return;
        budget.stop(L, late ? "stopped: it ran for " + std::to_string(longest.count()) + " seconds"
                            : "stopped: it ran past its budget of " +
                                  std::to_string(budget.instructions_) + " instructions");
    }
    lua_sethook(L, hook, LUA_MASKCOUNT, 1);
    budget.raise_stop(L);
}

void Budget::stop(lua_State* L, const std::string& why) {
    if (stopping_) return;
    stopping_ = true;
    lua_Debug frame;
    for (int level = 0; lua_getstack(L, level, &frame); ++level) {
        lua_getinfo(L, "Sl", &frame);
        if (frame.currentline <= 0) continue;
        file_ = frame.short_src;
        line_ = frame.currentline;
        break;
    }
    reason_ = (line_ > 0 ? file_ + ":" + std::to_string(line_) + ": " : std::string()) + why;
}

void Budget::interrupt() noexcept {
    interrupted_ = 1;
    if (machine_.running != nullptr) lua_sethook(machine_.running, hook, LUA_MASKCOUNT, 1);
}

void Budget::stop_if_interrupted(lua_State* L) {
    if (interrupted_ != 0) stop(L, "stopped: the run is to end");
}

void Budget::go_on() {
    interrupted_ = 0;
    if (active_) return;
    stopping_ = false;
    lua_sethook(machine_.main, nullptr, 0, 0);
}

void Budget::arm() {
    lua_sethook(machine_.running, hook, LUA_MASKCOUNT, 1);
}

void Budget::raise_stop(lua_State* L) {
    lua_pushlstring(L, reason_.data(), reason_.size());
    lua_error(L);
    std::terminate();  // not reached
}

void Budget::charge(lua_State* L, std::uint64_t instructions) {
    if (!active_ && interrupted_ == 0) return;
    stop_if_interrupted(L);
    charge_quietly(instructions);
    check(L);
}

void Budget::charge_quietly(std::uint64_t instructions) {
    if (!active_ || stopping_) return;
    left_ -=
        static_cast<std::int64_t>(std::min<std::uint64_t>(instructions, std::uint64_t{1} << 61));
    if (left_ >= 0) return;
    stop(machine_.running,
         "stopped: it ran past its budget of " + std::to_string(instructions_) + " instructions");
    arm();
}

std::string Budget::out_of_memory(const Arena::Refusal& refusal) const {
    return "not enough memory: " + std::to_string(refusal.size) +
           " bytes more were asked for, and " +
           (refusal.by_system ? std::string("the system has none to give")
                              : "the scripts of a game may use " +
                                    std::to_string(machine_.arena.limit() >> 20) + " MB");
}

void Budget::memory_refused(const Arena::Refusal& refusal) {
    if (stopping_) return;
    if (!active_) {
        // Lua's own error says neither where nor why, and calls no handler that could find out.
        refused_ = {.what = refusal};
        lua_Debug frame;
        for (int level = 0; lua_getstack(machine_.running, level, &frame); ++level) {
            lua_getinfo(machine_.running, "Sl", &frame);
            if (frame.currentline <= 0) continue;
            std::copy(std::begin(frame.short_src), std::end(frame.short_src), refused_.file);
            refused_.line = frame.currentline;
            break;
        }
        return;
    }
    if (!refusal.final) return;
    stop(machine_.running, "stopped: it needs more memory than a command may use (" +
                               std::to_string(refusal.size) + " bytes more, limit " +
                               std::to_string(memory_limit_ >> 20) + " MB)");
    arm();
}

std::string Budget::take_refusal() {
    const Refused refused = std::exchange(refused_, {});
    if (refused.what.size == 0) return {};
    const std::string place =
        refused.line > 0 ? std::string(refused.file) + ":" + std::to_string(refused.line) + ": "
                         : "";
    return place + out_of_memory(refused.what);
}

void Budget::enter(lua_State* thread) {
    if (!active_ && interrupted_ == 0) return;
    charge_quietly(500);
    lua_sethook(thread, hook, LUA_MASKCOUNT, stopping_ || interrupted_ != 0 ? 1 : interval);
}

void Budget::check(lua_State* L) {
    if (stopping_) raise_stop(L);
}

}  // namespace fettle::script
