#pragma once

#include <state/step_scratch.h>
#include <state/world_state.h>

#include <span>

namespace fettle::physics::detail {

/// Finds hubs among the awake bodies from place `begin` to `end`, and adds their copies to the
/// bodies that are solved.
void find_hubs(const ObjectState& objects, std::span<const uint32_t> awake, size_t begin,
               size_t end, BodyScratch& bodies, Hubs& hubs);

}  // namespace fettle::physics::detail
