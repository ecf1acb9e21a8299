#pragma once
// Facts about a plan that decide which invariants it has to keep.

#include "wild/plans/plan.h"

namespace fettle::bench::wild {

/// Something other than gravity puts energy into the world: a motor, a spring, a kinematic body, a
/// belt, a field.
bool is_driven(const WorldPlan& plan);

/// Shapes bounce in a solver that applies Newton's law of restitution at each contact by itself.
/// With friction, or if the bodies have joints, such bounces may add energy.
bool bounces_singly(const WorldPlan& plan);

/// No force from outside: no gravity, no fixed body, no border, no field, no damping, and no joint
/// with the world.
bool is_isolated(const WorldPlan& plan);

/// Everything in it comes to rest: nothing is driven, nothing bounces much, slides or rolls on
/// without resistance, or swings without friction.
bool can_rest(const WorldPlan& plan);

/// A speed that nothing in this world has reason to exceed in its first `seconds`.
float plausible_speed(const WorldPlan& plan, float seconds);

/// How deep shapes overlap at the start and how far joints are apart, m and rad, without what is
/// less than 1 cm: the further motion of a world that begins like this means little.
float fault_at_start(const WorldPlan& plan);

/// Half of the largest extent of a body, from its origin, m.
float reach_of(const BodyPlan& body);

}  // namespace fettle::bench::wild
