#pragma once

#include <constraints/solver_body.h>
#include <state/step_scratch.h>
#include <state/world_state.h>
#include <threads/pool.h>

#include <span>

namespace fettle::physics::detail {

/// Writes the awake bodies into the arrays of the solver, with the effect of gravity and forces in
/// a sub-step of length `h`, and finds the hubs among them.
void gather_bodies(const ObjectState& objects, Columns& columns, const ActiveLists& active,
                   const WorldDef& settings, const Strips& strips, float h, BodyScratch& bodies,
                   Hubs& hubs, ThreadPool* threads);

/// Must be called when no later stage of the step needs the ends of the bodies.
void clear_ends(const ActiveLists& active, BodyScratch& bodies);

// Fields of force: once per step they add to the forces of the sub-steps on the awake bodies.

/// Adds the fields to the forces of a sub-step of length `h`; the step has length `dt`. `boxes`:
/// the boxes of the shapes, by slot.
void apply_fields(const ObjectState& objects, const Columns& columns, std::span<const Box4> boxes,
                  std::span<const uint32_t> awake, Vec2 gravity, float h, float dt,
                  BodyScratch& bodies);
/// True if a field acts on a body where it is now.
bool in_any_field(const ObjectState& objects, const Columns& columns, std::span<const Box4> boxes,
                  uint32_t body);

}  // namespace fettle::physics::detail
