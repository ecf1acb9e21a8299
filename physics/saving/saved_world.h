#pragma once

#include <state/world_state.h>

#include <optional>
#include <string>

// Checks of a world that was read from bytes. Each returns the first thing that is wrong.

namespace fettle::physics::detail {

/// Every index is in range, and every list ends. The other checks need that.
std::optional<std::string> links_problem(const WorldState& world);
/// The parts of a world that say the same thing in different ways agree: an object is in the lists
/// of the body it says it belongs to, and a listed object says that it is listed.
std::optional<std::string> memberships_problem(const WorldState& world);
/// All numbers are such as setters accept, or as follow from those.
std::optional<std::string> numbers_problem(const WorldState& world);

}  // namespace fettle::physics::detail
