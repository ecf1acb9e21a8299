#pragma once

#include <state/world_state.h>

#include <cstdint>
#include <vector>

// Bodies that rock in place among bodies at rest. A round body on a heap rolls to and fro without
// loss, since rolling takes no energy away; a body that is wedged between two others may even get
// the energy back that it loses. One such body would keep a heap of hundreds awake. So where at
// least eight times as many bodies are slow, a body that has rocked in place for some seconds is
// slowed down until it rests, too.
//
// Only a way to and fro within some decimeters counts. A body that rolls away or tips over may be
// slow for long, but it does not come back. A body that something drives is not followed: one with
// a joint or on a belt, or what a kinematic body carries.

namespace fettle::physics::detail {

/// True if the body is faster now than its speed of rest, `slow` (m/s).
bool is_fast(const BodyRecord& body, const BodyState& state, float slow);

/// A stay that begins now.
Stay begun_stay(uint32_t slot, const BodyRecord& body, const BodyState& state);
/// Adds what the body did in the last `passed` seconds. False if the stay is over: the body has
/// left, does not come back, or was pushed. `slow`: its speed of rest, m/s.
bool continue_stay(Stay& stay, const BodyRecord& body, const BodyState& state, float slow,
                   float passed);
bool rocks(const Stay& stay);
/// True if it has been slowed down for some time already: then the solver gives it energy.
bool rocks_for_long(const Stay& stay);
/// Takes a part of its motion away.
void calm(BodyState& state, float passed);

Stay* stay_of(std::vector<Stay>& stays, uint32_t body);  ///< null: it has none
/// For edits: what the body does from now on, it does not do by itself.
void end_stay(std::vector<Stay>& stays, uint32_t body);

}  // namespace fettle::physics::detail
