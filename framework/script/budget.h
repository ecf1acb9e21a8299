#pragma once
// What one console command may use: Lua instructions and memory. A command that runs over is
// stopped for good: the error is raised again at every instruction until no script is left running,
// so neither pcall nor an error handler nor a coroutine keeps it. A run that is to end stops its
// scripts in the same way, whatever they are.

#include <chrono>
#include <csignal>
#include <cstdint>
#include <string>

#include "arena.h"
#include "lua_api.h"

namespace fettle::script {

struct Machine;

class Budget {
  public:
    explicit Budget(Machine& machine) : machine_(machine) {}

    void begin(std::uint64_t instructions, std::size_t memory);
    void end();

    /// Stops the script that runs, and every other until `go_on`. The one function of a runtime
    /// that a signal handler may call.
    void interrupt() noexcept;
    /// For when no script runs any more.
    void go_on();
    bool interrupted() const { return interrupted_ != 0; }

    bool active() const { return active_; }
    bool stopping() const { return stopping_; }
    /// Why and where: "console:3: stopped ...".
    const std::string& reason() const { return reason_; }
    const std::string& file() const { return file_; }
    int line() const { return line_; }

    /// Work done in C++ on behalf of a script, in instructions. Raises when that is too much.
    void charge(lua_State* L, std::uint64_t instructions);
    /// Work noticed where nothing can be raised; the next instruction is the last.
    void charge_quietly(std::uint64_t instructions);
    /// Memory ran out.
    void memory_refused(const Arena::Refusal& refusal);
    /// "not enough memory: ..." with the limit that was met.
    std::string out_of_memory(const Arena::Refusal& refusal) const;
    /// What is to be said of the latest refusal outside of commands: where, and which limit. ""
    /// when there was none.
    std::string take_refusal();
    /// A coroutine is about to run: it counts too.
    void enter(lua_State* thread);
    /// Raises when the command is being stopped.
    void check(lua_State* L);

  private:
    static constexpr int interval = 250;
    // A single instruction can take long (comparing two texts of 60 MB): time is limited as well.
    static constexpr std::chrono::seconds longest{5};
    static void hook(lua_State* L, lua_Debug* frame);
    void stop(lua_State* L, const std::string& why);
    void arm();
    [[noreturn]] void raise_stop(lua_State* L);

    Machine& machine_;
    void stop_if_interrupted(lua_State* L);
    volatile std::sig_atomic_t interrupted_ = 0;
    bool active_ = false;
    bool stopping_ = false;
    std::int64_t left_ = 0;
    std::uint64_t instructions_ = 0;
    std::chrono::steady_clock::time_point deadline_;
    std::size_t memory_limit_ = 0;
    std::size_t outer_limit_ = 0;
    std::string reason_;
    std::string file_;
    int line_ = 0;
    /// Noted where there is no memory for a text.
    struct Refused {
        Arena::Refusal what{};  // size 0: there was none
        char file[LUA_IDSIZE] = {};
        int line = 0;
    } refused_;
};

}  // namespace fettle::script
