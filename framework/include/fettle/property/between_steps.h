#pragma once
// Pictures between two steps: what is moved in steps is drawn between where it was before the last
// step and where it is after it.
//
// The tree does this for instances that have their place by a property `position`
// (`place_below`), and for a list `points` (`drawn_points`). Classes with a function
// `Lifecycle::pose` do it themselves, as bodies do. None of it is state: it has no effect on later
// steps, and no snapshot contains it.

#include <cstdint>
#include <limits>

#include <fettle/property/export.h>
#include <fettle/property/track.h>
#include <fettle/property/tree.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// How long a move in one step must be for a jump: m, and px on the screen.
struct FarMoves {
    double world = std::numeric_limits<double>::infinity();
    double screen = std::numeric_limits<double>::infinity();
};

/// The steps of which pictures are drawn.
struct NotedSteps {
    std::uint64_t begun = 0;  ///< how many have begun
    bool running = false;     ///< what is written now is a part of the last one
    FarMoves far{};
};
/// For classes that place their instances by `Lifecycle::pose`. In a module of a shared object no
/// step is noted.
const NotedSteps& noted_steps(const Tree& tree);

/// Notes where all instances are, before a step and after it. A game of which no pictures are drawn
/// does not need this: without it, instances are drawn where they are.
void note_step_begins(Tree& tree);
/// The same after the step. `far`: applies to the pictures until the next step has ended.
void note_step_ended(Tree& tree, const FarMoves& far);
/// Ends a step that has stopped before its end; after `note_step_ended` it does nothing.
void note_step_left(Tree& tree);

/// The list `points`, a stored property of the instance, as it is drawn: each point between its
/// places before and after the last step. A list that has got another length, or in which a point
/// has made a jump, is drawn as it is. `on_screen` and `alpha`: as of `place_below`.
Value drawn_points(const Tree& tree, Handle instance, const Property& points, bool on_screen,
                   double alpha);

}  // namespace fettle::property

FETTLE_PROPERTY_END
