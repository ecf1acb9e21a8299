#pragma once
// What one console command may use: Lua instructions, and memory of Lua and of the tree. A command
// that runs over is stopped for good: the error is raised again at every instruction until no
// script is left running, so neither pcall nor an error handler nor a coroutine keeps it. A run
// that is to end stops its scripts in the same way, whatever they are.

#include <chrono>
#include <csignal>
#include <cstdint>
#include <string>

#include <lua/arena.h>
#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

struct Limits {
    std::uint64_t instructions = 0;  // 0: as many as it takes, however long that is
    std::size_t memory = 0;          // bytes that it may add
    const char* who = "a command";   // that may, for messages
    std::string raised_by{};         // path of a property; "": of none
};

class Budget {
  public:
    explicit Budget(Machine& machine) : machine_(machine) {}

  private:
    struct Account {
        bool active = false;
        bool counting = false;  // instructions and time
        bool stopping = false;
        bool out_of_room = false;
        std::int64_t left = 0;
        std::uint64_t instructions = 0;
        std::chrono::steady_clock::time_point deadline;
        // What there was when it began: `made` is told by the difference.
        std::size_t memory = 0, lua_before = 0, outer_limit = 0;
        const char* who = "";
        std::string raised_by;
        std::int64_t weight_before = 0;
        std::size_t instances_before = 0, watchers_before = 0;
        std::string reason, file;
        int line = 0;
    };

  public:
    /// In force while it lives; one inside of another counts by itself.
    class Scope {
      public:
        Scope(Budget& budget, const Limits& limits);
        ~Scope();
        Scope(const Scope&) = delete;

      private:
        Budget& budget_;
        Account outer_;
    };

    /// Stops the script that runs, and every other until `go_on`. A signal handler may call it.
    void interrupt() noexcept;
    /// For when no script runs any more.
    void go_on();
    bool interrupted() const { return interrupted_ != 0; }
    void stop_if_interrupted(lua_State* L) {
        if (interrupted()) [[unlikely]]
            stop(L, "stopped: the run is to end");
    }

    bool counting() const { return now_.counting; }
    bool stopping() const { return now_.stopping; }
    /// Whether it stops because the tree, or Lua, came to take too much memory.
    bool out_of_room() const { return now_.stopping && now_.out_of_room; }
    /// Why and where: "console:3: stopped ...".
    const std::string& reason() const { return now_.reason; }
    const std::string& file() const { return now_.file; }
    int line() const { return now_.line; }

    /// Work done in C++ on behalf of a script, in instructions. Raises when that is too much.
    void charge(lua_State* L, std::uint64_t instructions);
    /// Work noticed where nothing can be raised; the next instruction is the last.
    void charge_quietly(std::uint64_t instructions);
    /// Memory ran out.
    void memory_refused(const Arena::Refusal& refusal);
    /// "not enough memory: ..." with the limit that was met.
    std::string out_of_memory(const Arena::Refusal& refusal) const {
        return out_of_memory(refused_here(refusal));
    }
    /// What is to be said of the latest refusal that stopped nothing: where, and which limit. ""
    /// when there was none.
    std::string take_refusal();
    /// A coroutine is about to run: it counts too.
    void enter(lua_State* thread);
    /// Raises when the command is being stopped.
    void check(lua_State* L);
    /// Stops what runs for another reason, at its next instruction at the latest; the reason is
    /// told with the script's position in front.
    void stop(lua_State* L, const std::string& why);
    /// The host's call has come back: what was stopped without a budget is over.
    void call_ended();
    /// The hook looks at what `running` does at its next instruction. A signal handler may call it.
    static void arm(lua_State* running) noexcept;

  private:
    static constexpr int interval = 250;
    // A single instruction can take long (comparing two texts of 60 MB): time is limited as well.
    static constexpr std::chrono::seconds longest{5};
    static void hook(lua_State* L, lua_Debug* frame);
    struct Refused;
    static std::string out_of_memory(const Refused& refused);
    Refused refused_here(const Arena::Refusal& refusal) const;
    void notice_growth();
    void mark_next();
    std::string too_much_memory() const;
    [[noreturn]] void raise_stop(lua_State* L);

    Machine& machine_;
    Account now_;
    volatile std::sig_atomic_t interrupted_ = 0;
    /// Noted where there is no memory for a text.
    struct Refused {
        Arena::Refusal what{};  // size 0: there was none
        std::size_t limit = 0;
        const char* who = "";
        char file[LUA_IDSIZE] = {};
        int line = 0;
    } refused_;
};

}  // namespace fettle::script
