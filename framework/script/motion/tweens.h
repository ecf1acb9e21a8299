#pragma once
// Runs the tweens of a tree, in simulation time.

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <lua/lua_api.h>
#include <motion/tween_classes.h>

namespace fettle::script {

struct Machine;

class Tweens {
  public:
    explicit Tweens(Machine& machine);

    /// What a script gives to `tween`.
    struct Plan {
        Handle target;
        std::string property;
        Value to;
        double seconds = 0;
        std::string ease = "linear";
        property::List curve{};  // for the ease "curve"
    };
    /// Makes a tween; it begins at the next step. Throws Error for a property that cannot change
    /// from its value to this one.
    Handle add(const Plan& plan);
    /// Throws Error for an instance whose properties are all set, if it is a tween that cannot run:
    /// its property is not there, or cannot change to this value.
    void require_valid(Handle made) const;
    /// Makes a tween without a property, for a sequence.
    Handle add_pause(double seconds);
    /// Makes a group of tweens and groups that are below `game.tweens`, not in a group. Throws
    /// Error if groups would be nested too deep.
    Handle add_group(const char* kind, const std::vector<Handle>& members);
    /// Whether the instance is a tween or a group that `add_group` takes.
    bool groupable(Handle each) const;

    /// The last deleted instances whose tweens ended for that reason. Undo may bring them back.
    std::vector<Handle> deleted_targets();

    /// All tweens and groups that are in no group.
    std::vector<Handle> all() const;

    /// One step of `dt` s. Returns false if one raised an error; that one has ended then.
    bool run(double dt) { return run_those(dt, true); }
    /// The same for tweens in real time, once a frame; `dt`: s since the last frame.
    bool advance_real(double dt) { return run_those(dt, false); }

  private:
    Handle holder();
    Handle make(const Class& of);
    Value end_of(const Plan& plan) const;
    Value require_possible(Handle target, const std::string& name, const Value& from,
                           const Value& to, const std::string& who) const;
    bool run_those(double dt, bool pausing);
    bool pauses(Handle each) const;
    bool running(Handle each) const;
    bool over(Handle each) const;
    void end(Handle each, std::string_view why);
    void note_deleted(Handle target);
    std::optional<double> advance(Handle each, double dt, int depth);
    std::optional<double> advance_tween(Handle tween, double dt);
    std::optional<double> advance_group(Handle group, double dt, int depth);
    std::optional<double> advance_run(Handle group, double dt, int depth);
    bool goes_back(Handle group) const;
    void begin_run(Handle group, int depth);
    std::optional<double> pass_time(Handle tween, double dt);
    bool begin(Handle tween);
    void note_begun(Handle within, int depth);
    void stop_others(Handle tween, Handle target, const std::string& name);
    void show(Handle tween);
    void finish(Handle each);

    Machine& machine_;
    const TweenClasses classes_;
    std::deque<Handle> deleted_targets_;
    /// The tweens that have begun, by instance and property. Listed when the first tween of a run
    /// begins: each tween that begins ends the others of its property, and many may begin in a
    /// step.
    using Moved = std::pair<std::uint64_t, std::string>;
    std::optional<std::map<Moved, std::vector<Handle>>> begun_{};
    bool ok_ = true;
};

/// Adds `tween` to the table of globals at the top of the stack.
void open_tweens(lua_State* L);
/// `tween(target, property, to, seconds, ease)`, also a method of every instance.
int tween_function(lua_State* L);

}  // namespace fettle::script
