#pragma once
// Limits of one console command: Lua instructions, and memory of Lua and the tree. A command that
// exceeds a limit is stopped for good: the error is raised again at every instruction until no
// script is running, so that pcall, error handlers and coroutines cannot continue. All scripts of a
// run that is to end are stopped in the same way.

#include <chrono>
#include <csignal>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include <limits/arena.h>
#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

struct Limits {
    std::uint64_t instructions = 0;     // 0: no limit, also of time
    std::size_t memory = 0;             // bytes that may be added
    std::size_t whole = 0;              // the limit for messages, if a part of it is in use already
    const char* subject = "a command";  // name of the limited code, for messages
    std::string raised_by{};            // path of the property that raises the limit; "": none
    double seconds = 5;                 // if instructions are limited: one can take long
};

class Budget {
  public:
    explicit Budget(Machine& machine);

  private:
    struct Account {
        bool active = false;
        bool counting = false;  // whether instructions and time are limited
        bool stopping = false;
        bool memory_exceeded = false;
        std::int64_t left = 0;
        std::uint64_t instructions = 0;
        double seconds = 0;
        std::chrono::steady_clock::time_point deadline;
        // Values at the beginning, to compute the memory that was added since.
        std::size_t memory = 0, lua_before = 0, outer_limit = 0;
        std::size_t whole = 0;  // for messages
        const char* subject = "";
        std::string raised_by;
        std::int64_t weight_before = 0;
        std::size_t instances_before = 0, watchers_before = 0;
        std::string reason, file;
        int line = 0;
    };

  public:
    /// The limits apply while it exists. A nested scope counts separately.
    class Scope {
      public:
        Scope(Budget& budget, const Limits& limits);
        ~Scope();
        Scope(const Scope&) = delete;

      private:
        Budget& budget_;
        Account outer_;
    };

    /// The limits of a call into the scripts of a game that is not trusted; none otherwise.
    std::optional<Limits> of_call() const;
    /// Returns why a script has to stop because of other limits; "" if it may go on. Called each
    /// time the tree has grown somewhat.
    std::function<std::string()> passed_limit;

    /// Applies `GameLimits::tree` while no scope exists. To be called once the options are there.
    void limit_tree();

    /// Stops the running script and all others until `go_on`. A signal handler may call it.
    void interrupt() noexcept;
    /// Allows scripts again. To be called when no script runs.
    void go_on();
    bool interrupted() const { return interrupted_ != 0; }
    void stop_if_interrupted(lua_State* L) {
        if (interrupted()) [[unlikely]]
            stop(L, "stopped: it was interrupted");
    }

    bool counting() const { return now_.counting; }
    bool stopping() const { return now_.stopping; }
    /// Whether it is stopping because the tree or Lua used too much memory.
    bool memory_exceeded() const { return now_.stopping && now_.memory_exceeded; }
    /// Reason with position: "console:3: stopped ...".
    const std::string& reason() const { return now_.reason; }
    const std::string& file() const { return now_.file; }
    int line() const { return now_.line; }

    /// Charges work that C++ does for a script, in instructions. Raises an error if the limit is
    /// exceeded.
    void charge(lua_State* L, std::uint64_t instructions);
    /// The same for work whose time does not follow from its size: also stops when the time is
    /// over.
    void charge_by_the_clock(lua_State* L, std::uint64_t instructions);
    /// The same where no error may be raised; the script is stopped at its next instruction.
    void charge_quietly(std::uint64_t instructions);
    /// To be called when Lua is to get no more memory. Returns whether it gets none; false for a
    /// larger stack, which is refused at the next instruction.
    bool memory_refused(const Arena::Refusal& refusal);
    /// "not enough memory: ..." with the exceeded limit.
    std::string out_of_memory(const Arena::Refusal& refusal) const {
        return out_of_memory(describe(refusal));
    }
    /// The message for the latest refusal that did not stop the script: its place and the limit; ""
    /// if there was none.
    std::string take_refusal();
    /// To be called before a coroutine runs, so that its instructions count, too.
    void enter(lua_State* thread);
    /// Raises the error if the command is being stopped.
    void check(lua_State* L);
    /// Stops the running script for another reason, at its next instruction at the latest. The
    /// message is the script's position and `why`.
    void stop(lua_State* L, const std::string& why);
    /// To be called at the end of a call by the host: a stop without a budget ends there.
    void call_ended();
    /// Sets the hook for the next instruction of `running`. A signal handler may call it.
    static void arm(lua_State* running) noexcept;

  private:
    static constexpr int interval = 250;
    static void hook(lua_State* L, lua_Debug* frame);
    struct Refused;
    static std::string out_of_memory(const Refused& refused);
    Refused describe(const Arena::Refusal& refusal) const;
    void refuse_grown_stack(lua_State* L);
    void notice_growth();
    void mark_next();
    void mark_at(std::int64_t weight);
    std::string too_late() const;
    std::string too_much_memory() const;
    std::string instances_and_memory() const;
    [[noreturn]] void raise_stop(lua_State* L);

    Machine& machine_;
    const std::int64_t first_weight_;  // of the tree before any script ran
    std::int64_t mark_ = 0;            // the weight of the tree at which its growth is noticed
    Account now_;
    volatile std::sig_atomic_t interrupted_ = 0;
    /// A refusal, with fixed-size members because there is no memory for a text.
    struct Refused {
        Arena::Refusal what{};  // size 0: no refusal
        std::size_t limit = 0;
        const char* subject = "";
        char file[LUA_IDSIZE] = {};
        int line = 0;
    } refused_;
    Arena::Refusal grown_stack_{};  // size 0: none
};

}  // namespace fettle::script
