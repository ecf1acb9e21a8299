#include <fettle/app/loop.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <stdexcept>

#include <fettle/app/foreground.h>
#include <fettle/property/error.h>
#include <fettle/property/exception_text.h>
#include <fettle/property/explaining.h>

#include <loop/cameras.h>
#include <loop/effects.h>
#include <time/smoothing.h>

namespace fettle::app {

/// Measures the phases of a frame: each `lap` adds the time since the last one to a phase.
class Loop::Stopwatch {
  public:
    void lap(double& phase) {
        const Clock::time_point now = Clock::now();
        phase += std::chrono::duration<double, std::milli>(now - last_).count();
        last_ = now;
    }
    /// Time since the beginning, ms.
    double total() const {
        return std::chrono::duration<double, std::milli>(Clock::now() - begun_).count();
    }
    Timings phases{};

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point begun_ = Clock::now(), last_ = begun_;
};

namespace {

class ObservedFrame {
  public:
    template <class Begin>
    ObservedFrame(LoopObserver* observer, Begin begin) : observer_(observer) {
        if (observer_ != nullptr) begin(*observer_);
    }
    /// Throws the observer's exception, unless another exception is leaving the frame already.
    ~ObservedFrame() noexcept(false) {
        if (observer_ == nullptr) return;
        try {
            observer_->frame_ends();
        } catch (...) {
            if (std::uncaught_exceptions() == uncaught_) throw;
        }
    }
    ObservedFrame(const ObservedFrame&) = delete;

  private:
    LoopObserver* observer_;
    const int uncaught_ = std::uncaught_exceptions();
};

/// During one step, `pressed` is true for the actions that were pressed before it.
class StepInput {
  public:
    explicit StepInput(Input& input) : input_(input) { input_.begin_step(); }
    ~StepInput() { input_.end_step_or_update(); }
    StepInput(const StepInput&) = delete;

  private:
    Input& input_;
};

}  // namespace

Loop::Loop(property::Tree& tree, script::Runtime& runtime, Services& services)
    : tree_(tree),
      runtime_(runtime),
      runtime_life_(runtime.lifetime()),
      services_(services),
      time_(tree.child(tree.root(), "time")),
      timeline_(tree, services.clock, [this](double dt) { step_modules(dt); }) {
    runtime_.add_library("sounds", Audio::library());
    services_.audio.random = [this] { return runtime_life_.expired() ? 0.5 : runtime_.random(); };
    runtime_.on_rewind([this](double seconds) { timeline_.rewind(seconds); });
    // The destructor removes this function, and `life` with it. Then a jump that waits for the
    // barrier is dropped.
    services_.clock.timeline.go_to = [this, life = std::make_shared<char>()](std::int64_t step) {
        // The caller can catch this error. At the barrier, fewer steps may be kept, so the loop
        // goes to the nearest.
        timeline_.require(step);
        const property::Writer writer = tree_.cause().writer;
        tree_.at_barrier([this, step, writer, watched_life = std::weak_ptr(life)] {
            if (watched_life.expired()) return;
            std::optional<property::Tree::CauseScope> cause;
            if (writer == property::Writer::script) cause.emplace(tree_, writer);
            timeline_.go_near(step);
        });
    };
    services_.clock.timeline.branches = [this] { return timeline_.branches(); };
    services_.clock.timeline.name_branch = [this](const std::string& branch,
                                                  const std::string& name) {
        timeline_.name_branch(branch, name);
    };
    const auto at_barrier = [this, life = std::make_shared<char>()](auto what) {
        return [this, what, life](const std::string& branch) {
            timeline_.require_branch(branch);
            tree_.at_barrier([this, what, branch, watched_life = std::weak_ptr(life)] {
                // It may have been dropped since.
                if (!watched_life.expired() && timeline_.has_branch(branch))
                    (timeline_.*what)(branch);
            });
        };
    };
    services_.clock.timeline.switch_to = at_barrier(&Timeline::switch_to);
    services_.clock.timeline.forget_branch = at_barrier(&Timeline::forget_branch);
}

void Loop::require_unpinned() const {
    if (pinned_ != nullptr)
        throw property::Error(property::ErrorKind::bad_structure,
                              std::string("the loop is destroyed by a function that its `") +
                                  pinned_ +
                                  "` is calling, which must not do so; destroy it after that "
                                  "(see \"Lifetimes\" in loop.h)");
}

Loop::~Loop() {
    require_unpinned();
    if (!runtime_life_.expired()) runtime_.on_rewind({});
    services_.clock.timeline = {};
    services_.audio.random = {};
}

void Loop::step_modules(double dt) {
    const Pin pin(*this, "step");
    // By index and with copies, here and below: a called function may add modules and layers.
    for (std::size_t i = 0; i < modules_.size(); ++i) {
        const auto step = modules_[i].step;
        step(dt);
    }
    services_.view.advance(tree_, dt);
    services_.cameras().advance(dt);
    services_.effects().step();
}

void Loop::add(SteppedModule module) {
    if (!module.step)
        throw std::invalid_argument("the module \"" + module.name +
                                    "\" needs a function that makes its step");
    modules_.push_back(std::move(module));
}
void Loop::add(Layer& layer) {
    layers_.push_back(&layer);
}
void Loop::before_step(std::function<void(std::uint64_t)> hook) {
    before_step_ = std::move(hook);
}
void Loop::between_frames(std::function<void()> hook) {
    between_frames_ = std::move(hook);
}

void Loop::handle(const InputEvent& event) {
    const Pin pin(*this, "handle");
    bool taken = false;
    for (std::size_t i = layers_.size(); i > 0 && !taken; --i)
        taken = layers_[i - 1]->handle(event);
    feed(event, taken);
}

void Loop::feed(const InputEvent& event, bool taken) {
    const Pin pin(*this, "feed");
    if (observer_ != nullptr) observer_->event(event, taken);
    if (event.kind == EventKind::closing) closing_ = true;
    if (taken)
        services_.input.observe(event);
    else
        services_.input.apply(event);
}

void Loop::after_barrier(std::function<void()> hook) {
    after_barrier_ = std::move(hook);
}

void Loop::barrier(bool between_steps) {
    std::exception_ptr problem;
    const auto attempt = [&problem](const auto& what) {
        try {
            what();
        } catch (...) {
            if (!problem) problem = std::current_exception();
        }
    };
    attempt([&] { deliver(between_steps); });
    // A copy, because the hook may replace itself.
    if (const auto hook = after_barrier_) attempt(hook);
    if (problem) std::rethrow_exception(problem);
}

void Loop::deliver(bool between_steps) {
    try {
        tree_.barrier(between_steps);
    } catch (const std::exception& error) {
        // Handlers that never stop making changes are an error of the game, not of the program.
        const auto sink = on_error_;
        if (!sink) throw;
        script::ScriptError reported;
        reported.message = property::exception_text(error);
        reported.context = "barrier";
        sink(reported);
    }
}

/// Checks before the frame changes anything.
void Loop::require_ready() const {
    if (runtime_life_.expired())
        throw property::Error(property::ErrorKind::deleted,
                              "the runtime of this loop was destroyed: nothing is left to run");
    timeline_.require_between_steps("a frame cannot begin");
    services_.clock.require_usable();
}

void Loop::on_error(std::function<void(const script::ScriptError&)> sink) {
    on_error_ = std::move(sink);
}

void Loop::announce_next() {
    const std::uint64_t next = steps_made_ + 1;
    if (next == announced_ || !before_step_) return;
    announced_ = next;
    const auto hook = before_step_;  // a copy, because the hook may replace itself
    hook(next);
}

/// Begins the next step or turn. False if there is none.
bool Loop::begin_next() {
    announce_next();
    if (stopped()) return false;
    ++steps_made_;
    return true;
}

/// Menus and transitions are advanced in each frame, before its steps. If time went back at the
/// barrier after that, they are advanced again, with the restored state, as they were when the next
/// step was first made.
void Loop::repeat_after_return(double real_dt) {
    if (!timeline_.consume_went_back()) return;
    if (Foreground* const menus = services_.input.foreground())
        menus->frame(services_.input.mouse(), services_.view.picture(), real_dt);
    runtime_.advance(real_dt);
    barrier();
}

/// Input, barrier, update and barrier. False if the frame ends here.
bool Loop::before_steps(double dt, double real_dt, Stopwatch& watch) {
    services_.clock.real += real_dt;
    (void)timeline_.consume_went_back();
    const bool wants_places = property::consume_explanation_request(tree_);
    tree_.locate_writes(services_.view.show.blame || wants_places);
    if (halted_) {
        services_.input.drop();
        barrier();  // edits from the console still take effect
        return false;
    }
    if (Foreground* const menus = services_.input.foreground())
        menus->frame(services_.input.mouse(), services_.view.picture(), real_dt);
    services_.input.deliver(runtime_);
    watch.lap(watch.phases.input);
    if (stopped()) return false;
    runtime_.advance(real_dt);
    barrier();
    repeat_after_return(real_dt);
    watch.lap(watch.phases.handlers);
    if (stopped() || closing_) return false;  // no other callback follows closing()
    services_.input.begin_update();
    runtime_.call("update", {dt, real_dt});
    services_.input.end_step_or_update();
    watch.lap(watch.phases.update);
    if (stopped()) return false;
    barrier();
    repeat_after_return(real_dt);
    watch.lap(watch.phases.handlers);
    return !stopped();
}

/// One fixed step. False if it was the last.
bool Loop::make_step(Stopwatch& watch) {
    Clock& clock = services_.clock;
    clock.require_usable();  // a script or the host may have changed it since the frame began
    const double dt = clock.dt;
    struct Leave {
        Timeline& timeline;
        property::Tree& tree;
        ~Leave() {
            timeline.leave_step();
            property::note_step_left(tree);
        }
    } leave{timeline_, tree_};
    if (shows_steps_) note_step_begins();
    timeline_.begin_step();
    clock.advance();
    tree_.set_step(static_cast<std::uint64_t>(clock.step));
    const StepInput pressed(services_.input);
    runtime_.step(clock.now, dt);
    watch.lap(watch.phases.scripts);
    if (stopped()) return false;
    // Going to another step is not allowed between the scripts and the modules of a step.
    barrier(false);
    watch.lap(watch.phases.handlers);
    if (stopped()) return false;
    {
        const property::Tree::CauseScope cause(tree_, property::Writer::simulation);
        services_.audio.step(dt);
        timeline_.modules_step(dt);
        step_modules(dt);
        for (std::size_t i = 0; i < modules_.size(); ++i)
            if (const auto report = modules_[i].report) report();
        tree_.stepped();
    }
    watch.lap(watch.phases.modules);
    barrier(false);
    timeline_.end_step();
    if (observer_ != nullptr) observer_->stepped();
    barrier();
    if (shows_steps_) note_step_ended();
    watch.lap(watch.phases.handlers);
    return !stopped();
}

/// Pictures are drawn between the states before and after the last step.
void Loop::note_step_begins() {
    property::note_step_begins(tree_);
    services_.view.note_step_begins();
    services_.cameras().note_step_begins();
}

void Loop::note_step_ended() {
    const View& view = services_.view;
    property::note_step_ended(
        tree_, {.world = view.far(), .screen = view.far() / view.height * view.picture().y});
    services_.view.note_step_ended();
    services_.cameras().note_step_ended();
}

void Loop::frame(double seconds, std::int64_t step_limit) {
    const Pin pin(*this, "frame");
    shows_steps_ = true;
    if (const auto hook = between_frames_) hook();
    require_ready();
    if (!std::isfinite(seconds))
        throw property::Error(
            property::ErrorKind::out_of_range,
            "a frame of " + property::number_text(seconds) + " seconds: expected how long it was");
    const ObservedFrame observed(observer_,
                                 [&](LoopObserver& w) { w.frame_begins(seconds, step_limit); });
    Stopwatch watch;
    Clock& clock = services_.clock;
    seconds = std::max(0.0, seconds);
    // `seconds` is the length of the frame before.
    if (const FrameTimes* const before = clock.frames.complete(1000 * seconds))
        smooth(clock.timings.wait, before->ms.wait, seconds);
    const std::int64_t begun_at = clock.step;
    const double passed = clock.paused ? 0 : seconds * clock.scale;
    const bool will_step = clock.paused ? clock.step_once : due_seconds_ + passed >= clock.dt;
    const auto limit = static_cast<std::uint64_t>(std::max<std::int64_t>(step_limit, 0));
    if (will_step && !halted_ && steps_made_ < limit) announce_next();
    // `dt` of update is at most the time that this frame may simulate.
    if (before_steps(std::min(passed, clock.max_steps * clock.dt), seconds, watch)) {
        if (clock.paused) {
            // A step is due as soon as the game is resumed, and the picture shows the last step.
            due_seconds_ = clock.dt;
            if (clock.step_once) {
                if (begin_next()) make_step(watch);
                tree_.set(time_, "step_once", false);
            } else {
                wait(seconds);
            }
            services_.input.drop_unseen_presses();
        } else {
            if (clock.step_once) tree_.set(time_, "step_once", false);
            due_seconds_ += passed;
            catch_up(limit, watch);
        }
    }
    clock.alpha = clock.paused || halted_ || steps_made_ >= limit
                      ? 1.0
                      : std::clamp(due_seconds_ / clock.dt, 0.0, 1.0);
    end_frame(watch, seconds, 1000 * seconds);
    if (!clock.paused || clock.step != begun_at) log_frame(watch);
}

/// A frame of a paused game.
void Loop::wait(double seconds) {
    const property::Tree::CauseScope cause(tree_, property::Writer::simulation);
    services_.audio.wait(seconds);
}

void Loop::catch_up(std::uint64_t limit, Stopwatch& watch) {
    Clock& clock = services_.clock;
    // The tolerance makes sixty steps of sixty frames of 1/60 s, whose sum is slightly below one
    // second.
    const auto due = [&] { return due_seconds_ >= clock.dt * (1 - 1e-9); };
    for (int made = 0; due() && !clock.paused && steps_made_ < limit; ++made) {
        if (made == clock.max_steps) {
            const double dropped = std::floor(due_seconds_ / clock.dt);
            clock.dropped_steps += static_cast<std::int64_t>(dropped);
            due_seconds_ -= dropped * clock.dt;
            break;
        }
        if (!begin_next()) break;
        due_seconds_ = std::max(0.0, due_seconds_ - clock.dt);
        if (!make_step(watch)) break;
    }
}

void Loop::turn() {
    const Pin pin(*this, "turn");
    shows_steps_ = false;  // pictures of a headless run show the last step
    if (const auto hook = between_frames_) hook();
    require_ready();
    const ObservedFrame observed(observer_, [](LoopObserver& w) { w.turn_begins(); });
    Stopwatch watch;
    Clock& clock = services_.clock;
    if (!begin_next()) return;
    if (!before_steps(clock.paused ? 0 : clock.dt, clock.dt, watch)) return;
    if (!clock.paused || clock.step_once) {
        const bool once = clock.step_once;
        make_step(watch);
        if (once) tree_.set(time_, "step_once", false);
    } else {
        wait(clock.dt);
        services_.input.drop_unseen_presses();
    }
    clock.alpha = 1;
    const double total = watch.total();
    end_frame(watch, clock.dt, total);
    clock.fps = 0;  // a headless run shows no frames
    log_frame(watch);
    (void)clock.frames.complete(total);
}

void Loop::log_frame(const Stopwatch& watch) {
    const Clock& clock = services_.clock;
    services_.clock.frames.add({.ms = watch.phases, .frame = clock.frame, .step = clock.step});
}

/// `seconds`: for the smoothing; `total`: of the frame, ms.
void Loop::end_frame(const Stopwatch& watch, double seconds, double total) {
    Clock& clock = services_.clock;
    services_.input.end_frame();
    ++clock.frame;
    if (seconds <= 0) return;
    Timings& average = clock.timings;
    smooth(average.input, watch.phases.input, seconds);
    smooth(average.update, watch.phases.update, seconds);
    smooth(average.scripts, watch.phases.scripts, seconds);
    smooth(average.modules, watch.phases.modules, seconds);
    smooth(average.handlers, watch.phases.handlers, seconds);
    if (average.frame > 0)
        smooth(average.frame, total, seconds);
    else
        average.frame = total;  // the first frame
    clock.fps = average.frame > 0 ? 1000 / average.frame : 0;
}

void Loop::halt() {
    halted_ = Halt{.step = services_.clock.step, .paused = services_.clock.paused};
    timeline_.note_failure();
}

bool Loop::retry() {
    const Pin pin(*this, "retry");
    const bool ran = halted_ && !halted_->paused;
    const bool elsewhere = halted_ && services_.clock.step != halted_->step;
    const bool back = timeline_.go_before_failure();
    if (elsewhere && ran) tree_.set(time_, "paused", false);
    resume();
    return back;
}

void Loop::resume() {
    halted_.reset();
    due_seconds_ = 0;
}

}  // namespace fettle::app
