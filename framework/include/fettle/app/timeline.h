#pragma once
// The timeline: the past of a running game. Every so often the whole state is kept as a keyframe,
// and in between everything that was done from outside the simulation. Going to a moment is
// restoring the keyframe before it and stepping the modules again, with scripts, handlers and
// formulas off and what they did taken from the log; the result is the state as it was, bit for
// bit. docs/design/time.md.

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include <fettle/app/clock.h>
#include <fettle/property/snapshot.h>
#include <fettle/property/tree.h>
#include <fettle/property/write_log.h>

#include <fettle/app/export.h>

FETTLE_APP_BEGIN

namespace fettle::app {

class FETTLE_APP_PRIVATE Packer;
class FETTLE_APP_PRIVATE PackedBytes;

class Timeline {
  public:
    /// `step_modules`: what a step is besides what is done from outside.
    Timeline(property::Tree& tree, Clock& clock, std::function<void(double dt)> step_modules);
    ~Timeline();
    Timeline(const Timeline&) = delete;

    // --- Told by the loop
    /// From here to `end_step`, or to `leave_step` where that is not reached, nobody can travel.
    void begin_step();
    /// Right before the modules step.
    void modules_step(double dt);
    /// The modules have stepped, and all of it is delivered.
    void end_step();
    /// The step is over, however it went.
    void leave_step() { in_step_ = false; }

    // --- Travelling, between steps: in the middle of one, and while time travels, `go_to`,
    // `go_near`, `rewind` and `clear` throw Error(bad_structure), and nothing has changed
    /// Throws as they do. `what`: "the past cannot be left".
    void require_between_steps(const char* what) const;
    /// Throws Error(out_of_range) outside `oldest` and `newest`.
    void require(std::int64_t step) const;
    /// Nothing of the past is forgotten until a step is made from here: then what came later is.
    /// Throws as `require` does.
    void go_to(std::int64_t step);
    /// The same, or the nearest step that is kept; nowhere while nothing is.
    void go_near(std::int64_t step);
    /// By simulation time from now, as far back as the past is kept, and no further than the
    /// newest step; nowhere while nothing is. Throws Error(out_of_range) for what is no number.
    void rewind(double seconds);

    /// Keyframes may take this share of the time the game's steps take, 0.01 unless told; the less,
    /// the longer it takes to go somewhere.
    void set_share(double share) { share_ = share; }

    /// Forgets the past.
    void clear();
    bool keeps() const { return !keyframes_.empty(); }
    std::int64_t oldest() const;
    std::int64_t newest() const;
    /// Bytes it takes, about: keyframes, what was written in between, and the memory to make the
    /// next keyframe in. At the end of a step that and the history of edits are no more than
    /// `time.rewind_memory`, of which the history has a quarter at most.
    std::size_t memory() const;
    /// How many whole states are kept.
    std::size_t keyframes() const { return keyframes_.size(); }

  private:
    struct Step {
        std::int64_t number = 0;
        double dt = 0;
        std::vector<property::LoggedWrites> before;  // the modules stepped
        property::LoggedWrites after;
        std::vector<std::pair<property::SnapshotPart*, property::Memory>> changes;
        std::size_t bytes = 0;  // of all that
    };
    struct Keyframe {
        std::int64_t step = 0;
        bool jumped_to = false;  // no step leads here
        std::shared_ptr<PackedBytes> payload;
        property::Snapshot::Memories memories;
        std::size_t held = 0;  // bytes of those
        // Of the history: what it holds, and what it had forgotten by then.
        std::size_t history = 0, forgotten = 0;
        std::size_t memory() const;
    };
    class FETTLE_APP_PRIVATE Jumps;

    bool on() const;
    bool there_is_room() const;
    void share_room();
    void forget_all();
    void begin_log();
    void take_keyframe();
    struct FETTLE_APP_PRIVATE Room;
    Room room_of_packed();
    bool keyframe_is_due() const;
    bool too_much(const Step& step) const;
    void begin_anew();
    void note_jump();
    void settle();
    void travel(std::int64_t step);
    void drop(std::deque<Step>::iterator step);
    void drop_after(std::int64_t step);
    void drop_oldest();
    void trim();
    void thin_out();
    void note_writes(Step& of, property::LoggedWrites& where);
    void note_changes(Step& of);
    std::size_t forgotten() const;
    void redo(const Step& step);
    void redo_writes(const Step& step);

    property::Tree& tree_;
    Clock& clock_;
    std::function<void(double)> step_modules_;
    std::unique_ptr<Jumps> jumps_;
    std::unique_ptr<property::WriteLog> log_;
    std::unique_ptr<Packer> packer_;
    std::deque<Keyframe> keyframes_;
    std::deque<Step> steps_;
    Step tail_;  // done since the newest step, while one is earlier; `before` and `changes` only
    Step open_;
    bool in_step_ = false;
    bool stepping_ = false;         // and what is done is kept
    std::int64_t here_ = 0;         // the step that the tree is at
    std::int64_t spacing_ = 0;      // steps from one keyframe to the next
    std::size_t logged_ = 0;        // bytes of `steps_`
    std::size_t logged_since_ = 0;  // of those, since the last keyframe
    std::size_t room_ = 0;          // bytes that the past and the history may take
    std::size_t history_room_ = 0;  // of these, the history
    std::int64_t no_room_at_ = -1;  // step at which not even one keyframe fitted; -1: none
    std::size_t no_room_ = 0;       // and how much there was
    double share_ = 0.01;
    double begun_ = 0;   // s, when the step began
    double worked_ = 0;  // s, that steps took since the last keyframe
    double cost_ = 0;    // s, that the last keyframe took
};

}  // namespace fettle::app

FETTLE_APP_END
