#pragma once
// The classes Tween, TweenGroup and Tweens. The tree keeps all their values, so snapshots, saved
// games and replays contain tweens without further work.

#include <lua/tree_names.h>

namespace fettle::script {

/// Name of the child of the root below which tweens run.
inline constexpr const char* tweens_name = "tweens";

/// The two kinds of groups.
inline constexpr const char* in_sequence = "sequence";
inline constexpr const char* in_parallel = "parallel";

/// Groups within groups beyond this depth do not run.
inline constexpr int deepest_tweens = 32;

/// What the classes Tween and TweenGroup have in common.
struct RunningClass {
    const Class& of;
    const Property& paused;
    const Property& pauses;
    const Property& loops;
    const Property& alternate;
    const Property& turn;
    const Property& reversed;
    const Property& over;
    const property::Event& finished;
};

struct TweenClass : RunningClass {
    const Property& target;
    const Property& property;
    const Property& from;
    const Property& to;
    const Property& seconds;
    const Property& ease;
    const Property& curve;
    const Property& progress;
    const Property& shown;
};

struct TweenGroupClass : RunningClass {
    const Property& kind;
    const Property& run_time;
};

struct TweenClasses {
    TweenClass tween;
    TweenGroupClass group;
    const Class& holder;
};

/// How long all runs of a tween or a group take, and one run of a group, s. An endless one: a run.
double seconds_of(const property::Tree& tree, Handle each);
double seconds_of_run(const property::Tree& tree, Handle group);

/// Defines the classes, unless an earlier runtime of the tree has done so.
TweenClasses define_tween_classes(property::Tree& tree);

}  // namespace fettle::script
