#pragma once
// Runs the top level of a game (main.lua and the modules that it requires), and notes what a later
// reload needs: what the top level declared, and which globals, handlers and timers are its own.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <fettle/script/runtime.h>

#include <handlers/connections.h>
#include <handlers/timers.h>
#include <sandbox/random.h>

namespace fettle::script {

struct Machine;

class TopLevel {
  public:
    explicit TopLevel(Machine& machine) : machine_(machine) {}

    /// Runs the top level of a game that begins. `run` returns false after an error.
    bool load(const std::function<bool()>& run);
    /// Runs the top level of a game that goes on. After an error, everything is as it was, and the
    /// result contains the error.
    Reloaded reload(const std::function<bool()>& run);
    /// To be called when the step after `step` begins. Gives a note, once for each reload, if the
    /// game has gone back to a step before a reload that has changed its values.
    void note_return(std::uint64_t step);

  private:
    struct Kept;
    struct Noted {
        std::vector<Connections::Noted> connections;
        std::vector<Timers::Noted> timers;
    };

    void begin_noting();
    Noted end_noting();
    void move_into(Kept& kept);
    void restore(const Kept& kept, const Noted& made);
    void take(Noted made, Reloaded& result);
    void replace_timers(const std::vector<Timers::Noted>& made);
    void note_globals(int before);

    Machine& machine_;
    Random::State random_{};          // when the top level of this game began
    std::vector<std::string> names_;  // globals that the top level assigned
    Noted noted_;
    std::optional<std::uint64_t> reloaded_at_;  // none: no reload, or the note was given
};

}  // namespace fettle::script
