#pragma once
// The loop: one frame of a game, with or without a window.
//
//   input -> barrier -> update(dt, real_dt) -> barrier
//     -> while a fixed step is due {
//          tweens, timers and coroutines, step(dt), states -> barrier
//          -> voices, modules, view, events of modules -> barrier
//        }
//     -> draw

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fettle/app/event.h>
#include <fettle/app/export.h>
#include <fettle/app/layer.h>
#include <fettle/app/services.h>
#include <fettle/app/timeline.h>
#include <fettle/property/tree.h>
#include <fettle/script/runtime.h>

FETTLE_APP_BEGIN

namespace fettle::app {

class Screen;

/// Hashes of the parts of a state by name: "time", "values", and those of modules.
using Hashes = std::vector<std::pair<std::string, std::uint64_t>>;

/// Functions of a module that the loop calls.
struct SteppedModule {
    std::string name{};
    std::function<void(double dt)> step{};
    std::function<void()> report{};         // optional
    std::function<std::uint64_t()> hash{};  // optional
};

/// Gets all input of a loop in order, which is the content of a recording.
class LoopObserver {
  public:
    virtual ~LoopObserver() = default;
    /// `taken`: a layer used the event, so that the game does not get it.
    virtual void event(const InputEvent& event, bool taken) = 0;
    /// Called at the beginning and at the end of a frame or a turn.
    virtual void frame_begins(double seconds, std::int64_t step_limit) = 0;
    virtual void turn_begins() = 0;
    virtual void frame_ends() = 0;
    /// Called after each step.
    virtual void stepped() = 0;
};

/// **Lifetimes.** Tree and services outlive the loop; layers and the observer outlive the loop that
/// they were given to. A runtime may be destroyed before the loop: then `stopped` is true, and
/// `frame` and `turn` throw Error(deleted). Functions that the loop calls (hooks, callbacks, steps
/// of modules, layers) must not destroy it: if one does, the program ends with a message that says
/// so. A host that wants to end it sets a flag of its own, and tests it after `frame` or `turn`.
///
/// `frame` and `turn` throw, before they change anything, Error(out_of_range) for an unusable clock
/// (`Clock::require_usable`), and Error(bad_structure) in the middle of a step. They pass on
/// exceptions of the host's functions.
class Loop {
  public:
    Loop(property::Tree& tree, script::Runtime& runtime, Services& services);
    ~Loop();
    Loop(const Loop&) = delete;

    /// Throws std::invalid_argument, which names the module, if it has no `step`.
    void add(SteppedModule module);
    /// The last added layer gets events first and is drawn last. Not owned.
    void add(Layer& layer);
    /// The part of `whole` that all layers leave free, except for one.
    ClipRectangle free_area(ClipRectangle whole, const Layer* except = nullptr) const;
    /// Called before the callbacks of the `n`th step of this run, from 1. It is called once for
    /// each `n`, which counts as `steps_made` does and does not depend on `time.step`. A headless
    /// run counts turns, so that a paused game can be resumed.
    void before_step(std::function<void(std::uint64_t n)> hook);

    /// Called after each barrier, also after one that failed. Its exceptions leave the frame,
    /// unless the barrier has thrown already.
    void after_barrier(std::function<void()> hook);
    /// Called at the beginning of a frame, when no code of the game runs.
    void between_frames(std::function<void()> hook);

    /// Called when a barrier fails as a whole (handlers that never stop making changes); without
    /// it, the exception leaves the frame.
    void on_error(std::function<void(const script::ScriptError&)> sink);

    /// Handles an event from the window: layers get it first, then the tree. The game's callbacks
    /// follow in the next frame.
    void handle(const InputEvent& event);
    /// The same with the recorded result of the layers.
    void feed(const InputEvent& event, bool taken);
    /// Sets the observer, which is not owned; null: none.
    void set_observer(LoopObserver* observer) { observer_ = observer; }
    /// A frame, `seconds` of real time after the last one (below 0 counts as 0; Error(out_of_range)
    /// unless it is finite). Makes the steps that are due, at most `time.max_steps`; none once this
    /// run has made `step_limit` steps.
    void frame(double seconds, std::int64_t step_limit = INT64_MAX);
    /// A frame of a headless run: one step, unless paused; real time has no effect.
    void turn();
    /// Draws the game and the layers. `seconds`: real time since the last call.
    void draw(Screen& screen, double seconds);
    /// Draws only the layers, for use during a call into the game.
    void draw_layers(Screen& screen, double seconds);

    /// Steps that this run has made; steps that are made again after going back count again. Turns
    /// of a headless run count, too, although they make no step while paused.
    std::uint64_t steps_made() const { return steps_made_; }

    /// Stops input, updates and steps, after an error. Edits still have an effect.
    void halt();
    void resume();
    /// As `resume`; but if a script failed within a step, goes back to before this step, so that it
    /// is made again (`Timeline::go_before_failure`). A game that ran when it was halted, and that
    /// has gone to an earlier step since, runs on from there, although going back paused it.
    /// Returns true if it went back. To be called between frames.
    bool retry();
    bool halted() const { return halted_.has_value(); }
    /// True if the loop is halted, the game has called quit(), or its runtime is destroyed.
    bool stopped() const {
        return halted_ || runtime_life_.expired() || runtime_.quit_status().has_value();
    }
    /// Whether a script or a console command runs now.
    bool script_runs() const { return !runtime_life_.expired() && runtime_.running(); }
    /// True after a request to close the window.
    bool closing() const { return closing_; }

    Timeline& timeline() { return timeline_; }

    /// Hash of all data that influence later steps: modules, the clock, and the values in the tree.
    std::uint64_t hash() const;
    /// The hashes of the parts by name, with which a difference can be located.
    Hashes hashes() const;

  private:
    class FETTLE_APP_PRIVATE Stopwatch;
    /// While it lives, functions are called that must not destroy the loop.
    class FETTLE_APP_PRIVATE Pin {
      public:
        Pin(Loop& loop, const char* what)
            : loop_(loop), outer_(std::exchange(loop.pinned_, what)) {}
        ~Pin() { loop_.pinned_ = outer_; }
        Pin(const Pin&) = delete;

      private:
        Loop& loop_;
        const char* outer_;
    };
    void require_unpinned() const;
    void announce_next();
    bool begin_next();
    bool before_steps(double dt, double real_dt, Stopwatch& watch);
    void repeat_after_return(double real_dt);
    bool make_step(Stopwatch& watch);
    void note_step_begins();
    void note_step_ended();
    void wait(double seconds);
    void step_modules(double dt);
    void catch_up(std::uint64_t limit, Stopwatch& watch);
    void barrier(bool between_steps = true);
    void deliver(bool between_steps);
    void require_ready() const;
    void end_frame(const Stopwatch& watch, double seconds, double total);
    void log_frame(const Stopwatch& watch);

    property::Tree& tree_;
    script::Runtime& runtime_;
    std::weak_ptr<const void> runtime_life_;
    Services& services_;
    property::Handle time_;
    std::vector<SteppedModule> modules_;
    std::vector<Layer*> layers_;
    std::function<void(std::uint64_t)> before_step_;
    std::function<void()> after_barrier_;
    std::function<void()> between_frames_;
    std::function<void(const script::ScriptError&)> on_error_;
    Timeline timeline_;
    LoopObserver* observer_ = nullptr;
    const char* pinned_ = nullptr;  // the running function that must not destroy the loop
    double due_seconds_ = 0;        // s of simulation time that are due
    std::uint64_t steps_made_ = 0;
    std::uint64_t announced_ = 0;
    bool shows_steps_ = false;  // pictures are drawn between two steps
    struct Halt {
        std::int64_t step = 0;
        bool paused = false;
    };
    std::optional<Halt> halted_;  // where the game was halted, and whether it was paused
    bool closing_ = false;
};

}  // namespace fettle::app

FETTLE_APP_END
