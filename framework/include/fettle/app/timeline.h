#pragma once
// The timeline: the past of a running game. It stores the whole state in keyframes at intervals,
// and between keyframes a log of all changes from outside the simulation. To go to a step, the
// keyframe before it is restored and the modules are stepped again. Scripts, handlers and formulas
// are off during this; their changes come from the log. The result is the same state, bit for bit.
// See docs/design/time.md.

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>
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
    /// `step_modules`: steps the modules, which is the part of a step that is not in the log.
    Timeline(property::Tree& tree, Clock& clock, std::function<void(double dt)> step_modules);
    ~Timeline();
    Timeline(const Timeline&) = delete;

    // --- Calls of the loop
    /// Until `end_step`, or `leave_step` after an exception, going to another step is refused.
    void begin_step();
    /// Call right before the modules step.
    void modules_step(double dt);
    /// Call when the modules have stepped and all events are delivered.
    void end_step();
    /// Call at the end of a step, also after an exception.
    void leave_step();
    /// Call when a script fails; outside of a step it has no effect.
    void note_failure();
    /// Goes to the state before the last step if a script failed in that step, so that it can be
    /// made again. Edits after the failure are made again. Does nothing and returns false if that
    /// is impossible, or if other code has made a step or gone to another one since.
    bool go_before_failure();

    // --- Going to another step. In the middle of a step, and while another step is being restored,
    // `go_to`, `go_near`, `rewind` and `clear` throw Error(bad_structure) and change nothing
    /// Throws Error(bad_structure) in these cases. `what`: text for the message, "the past cannot
    /// be left".
    void require_between_steps(const char* what) const;
    /// Throws Error(out_of_range) outside `oldest` and `newest`.
    void require(std::int64_t step) const;
    /// Goes to a step. Later steps are kept as the newest until the game makes a step from here,
    /// and then as a branch. Throws as `require` does.
    void go_to(std::int64_t step);
    /// As `go_to`, but to the nearest step that is kept; does nothing if none is kept.
    void go_near(std::int64_t step);
    /// Goes back by this simulation time from now, at most to the oldest step that is kept and not
    /// beyond the newest; does nothing if none is kept. Throws Error(out_of_range) for NaN.
    void rewind(double seconds);

    /// Whether the timeline has gone to a step before the newest since the last call. The tree is
    /// then in the state right after that step.
    bool consume_went_back() { return std::exchange(place_.returned, false); }

    /// Calls `visit` for the kept steps from `from` on, in order, up to the present one, with the
    /// tree in the state after that step. At the end the tree is as it was, bit for bit; as after
    /// any restoring, watchers are compared at the next barrier. If a snapshot was restored after
    /// `from`, begins there; does nothing if no step is kept. Throws as `go_to`
    /// does. `visit` must change nothing, and throw nothing.
    void review(std::int64_t from, const std::function<void(std::int64_t step)>& visit);

    /// As above, up to the step `to`, which may be later than the present one; at most to the
    /// newest one, and to the last before a snapshot was restored.
    void review(std::int64_t from, std::int64_t to,
                const std::function<void(std::int64_t step)>& visit);

    /// Repeats the kept steps from `from` on as if something had been different: calls `change`
    /// with the tree in the state after step `from`, then `visit` for each step up to the present
    /// one. Writes of scripts come from the log, since scripts do not run; the modules compute new
    /// values. At the end the tree is as it was, bit for bit, also if `change`, `visit` or a step
    /// throws: the exception is thrown then. If a snapshot was restored after `from`, begins
    /// there. Throws as `go_to` does, and Error(out_of_range) if `from` is not kept.
    void repeat_with(std::int64_t from, const std::function<void()>& change,
                     const std::function<void(std::int64_t step)>& visit);

    // --- Branches. If the game makes a step from an earlier one, the steps after that one are kept
    // as a branch. The past of the running game is the present branch; `Clock::branch` is its name.
    // At most `Clock::branch_limit` others are kept, and their steps are dropped at the same age as
    // those of the past. If there are too many branches or too little memory, whole branches are
    // dropped before the past gets shorter, the oldest first: those that a script left by going
    // back, then those of persons, at last those that a person has named. No other branch gets the
    // number of a dropped one as its name.
    /// The branches besides the present one, the oldest first.
    std::vector<Branch> branches() const;
    /// `told`: is called with a line for people when a branch is dropped because of a limit. Of the
    /// branches that scripts left, only the first one is told.
    void on_dropped_branch(std::function<void(const std::string& line)> told) {
        told_dropped_ = std::move(told);
    }
    /// Whether there is such a branch besides the present one.
    bool has_branch(const std::string& branch) const;
    /// Throws Error(unknown_name) if there is none.
    void require_branch(const std::string& branch) const;
    /// Makes that branch the present one and goes to its last step; the one that was present is
    /// kept. Throws Error(unknown_name) if there is no such branch, and as `go_to` does.
    void switch_to(const std::string& branch);
    /// Gives a branch, also the present one, another name. Throws Error(unknown_name) if there is
    /// no such branch, and Error(bad_name) if another has that name, or it is empty, longer than 40
    /// bytes, or has a control character.
    void name_branch(const std::string& branch, const std::string& name);
    /// Forgets a branch. Throws Error(unknown_name) if there is no such branch besides the present
    /// one.
    void forget_branch(const std::string& branch);
    /// As `review`, for the steps of another branch, up to its last one. Throws
    /// Error(unknown_name), too.
    void review_branch(const std::string& branch, std::int64_t from,
                       const std::function<void(std::int64_t step)>& visit);

    /// The share of the time of the game's steps that keyframes may take, 0.01 by default; a
    /// smaller share makes going to a step slower.
    void set_share(double share) { pace_.share = share; }

    /// Drops all steps.
    void clear();
    bool keeps() const { return !keyframes_.empty(); }
    std::int64_t oldest() const;
    std::int64_t newest() const;
    /// The range of steps that `go_to` accepts now; both ends are the current step if none is kept.
    /// Valid also right after other code has restored a state, while `oldest` and `newest` are
    /// updated only later.
    struct KeptSteps {
        std::int64_t oldest, newest;
    };
    KeptSteps kept_steps() const;
    /// Memory in bytes, estimated: keyframes and logs, also of the branches, and the memory for the
    /// next keyframe. At the end of a step, this and the history of edits together are at most
    /// `time.rewind_memory`, of which the history has at most a quarter.
    std::size_t memory() const;
    /// Number of keyframes.
    std::size_t keyframes() const { return keyframes_.size(); }

  private:
    /// Logged writes, and the changes of the parts after them.
    struct Piece {
        property::LoggedWrites writes;
        std::vector<std::pair<property::SnapshotPart*, property::Memory>> changes;
        std::size_t bytes = 0;
        bool broken = false;  // of a step that an error ended early
    };
    struct Step {
        std::int64_t number = 0;
        double dt = 0;
        std::vector<Piece> before;  // before the modules stepped
        Piece after;
        std::size_t bytes = 0;  // of all of these
    };
    struct Keyframe {
        std::int64_t step = 0;
        bool jumped_to = false;  // reached by a jump, not by a step
        std::shared_ptr<PackedBytes> payload;
        property::Snapshot::Memories memories;
        std::size_t held = 0;  // bytes of these
        // Bytes that the history held, and bytes that it had dropped, at this step.
        std::size_t history = 0, forgotten = 0;
        std::size_t memory() const;
    };
    using Steps = std::deque<std::shared_ptr<Step>>;
    /// Another branch, with all that is needed to go there. It shares the memory of the steps that
    /// it has in common with the present one.
    struct Other {
        std::string name;
        bool named = false;      // by a person
        bool by_script = false;  // a script has left it by going back
        std::int64_t fork = 0;   // the last step that it has in common with the present branch
        std::deque<Keyframe> keyframes;
        Steps steps;
        Step tail;              // as `tail_`
        std::size_t bytes = 0;  // of the steps after `fork`, and of `tail`
        std::int64_t newest() const;
        std::size_t memory() const;
    };
    /// The last step in which a script failed.
    struct Failure {
        std::int64_t step = -1;  // -1: none
        std::size_t pieces = 0;  // of `tail_` at its end
    };
    /// Where the tree is, and whether a step is being made.
    struct Place {
        std::int64_t here = 0;   // the step that the tree is at
        bool returned = false;   // for `consume_went_back`
        bool by_script = false;  // a script has made the last jump
        bool in_step = false;
        bool stepping = false;  // in a step: changes are logged
    };
    /// The memory of the past.
    struct Bytes {
        std::size_t logged = 0;        // of `steps_`
        std::size_t logged_since = 0;  // of these since the last keyframe
        std::size_t room = 0;          // that the past and the history may use
        std::size_t no_room = 0;       // `room` when it was too small for one keyframe
        std::int64_t no_room_at = -1;  // the last step at which it was too small; -1: none
    };
    /// How often keyframes are made.
    struct Pace {
        double share = 0.01;       // of the time of steps
        std::int64_t spacing = 0;  // steps from one keyframe to the next
        double begun = 0;          // s, at the start of the step
        double worked = 0;         // s, duration of the steps since the last keyframe
        double cost = 0;           // s, duration of making the last keyframe
    };
    class FETTLE_APP_PRIVATE Jumps;
    class FETTLE_APP_PRIVATE Travelling;

    bool on() const;
    bool memory_available() const;
    void share_room();
    void drop_all();
    void begin_log();
    void take_keyframe();
    struct FETTLE_APP_PRIVATE Room;
    Room room_of_packed();
    bool keyframe_is_due() const;
    bool too_much(const Step& step) const;
    void restart();
    void note_jump();
    void save_changes();
    void travel(std::int64_t step);
    void replay(const Keyframe& frame, std::int64_t step,
                const std::function<void(std::int64_t)>& visit);
    void repeat_steps(const Keyframe& frame, const Steps& steps, std::int64_t from, std::int64_t to,
                      const std::function<void(std::int64_t step)>& visit);
    void drop(Steps::iterator step);
    // --- branches.cpp
    void keep_branch();
    void trim_branches();
    void drop_branch(const std::string& limit);
    void count_bytes(Other& branch) const;
    std::string new_branch_name();
    std::vector<Other>::iterator other_branch(const std::string& name);
    void exchange_with(Other& other);
    const Keyframe& start_of(std::int64_t from) const;
    void run_in_past(const Keyframe& frame, const std::function<void()>& repeat);
    void drop_after(std::int64_t step);
    void drop_oldest();
    void trim();
    void thin_out();
    void note(Step& of, Piece& piece);
    void drop_broken();
    void skip_changes();
    std::size_t forgotten() const;
    void redo(const Step& step);
    void redo(const Piece& piece);

    property::Tree& tree_;
    Clock& clock_;
    std::function<void(double)> step_modules_;
    std::unique_ptr<Jumps> jumps_;
    std::unique_ptr<property::WriteLog> log_;
    std::unique_ptr<Packer> packer_;
    std::deque<Keyframe> keyframes_;
    Steps steps_;
    std::vector<Other> others_;  // in the order in which they were left
    bool named_ = false;         // the present branch, by a person
    std::size_t last_name_ = 1;  // the number of the last branch
    std::deque<std::pair<std::string, std::string>> dropped_;  // the last ones, and why
    bool script_drop_told_ = false;
    std::function<void(const std::string& line)> told_dropped_;
    Step tail_;  // after the newest step, while the tree is at an earlier one; `before` only
    Step open_;
    Step edits_;  // at an earlier step than the newest, before the next step; `before` only
    Failure failure_;
    Place place_;
    Bytes bytes_;
    Pace pace_;
};

}  // namespace fettle::app

FETTLE_APP_END
