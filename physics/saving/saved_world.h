#pragma once

#include <state/world_state.h>

#include <optional>
#include <string>

// Checks of a deserialized world. Each returns a description of the first fault.

namespace fettle::physics::detail {

/// Every index is in range, and every list ends. The other checks rely on this.
std::optional<std::string> links_problem(const WorldState& world);
/// Redundant data agree: an object is in the lists of its body, and a listed object has the mark
/// that it is listed.
std::optional<std::string> memberships_problem(const WorldState& world);
/// All numbers are values that setters accept, or follow from such values.
std::optional<std::string> numbers_problem(const WorldState& world);

}  // namespace fettle::physics::detail
