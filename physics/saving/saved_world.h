#pragma once

#include <state/world_state.h>

#include <optional>
#include <string>

// Checks of a deserialized world. Each returns a description of the first error.

namespace fettle::physics::detail {

/// Checks that every index is in range and every list ends. The other checks rely on this.
std::optional<std::string> links_problem(const WorldState& world);
/// Checks redundant data: an object must be in the lists of its body, and a listed object must be
/// marked as listed.
std::optional<std::string> memberships_problem(const WorldState& world);
/// Checks that all numbers are values that setters accept, or follow from such values.
std::optional<std::string> numbers_problem(const WorldState& world);

}  // namespace fettle::physics::detail
