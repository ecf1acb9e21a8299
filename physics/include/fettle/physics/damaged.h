#pragma once

#include <fettle/physics/export.h>

#include <stdexcept>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// Thrown by methods of a world whose state is incomplete, because an allocation failed in the
/// middle of an edit or a step. Such a world has no objects: lists are empty, and handles are not
/// valid. It can be destroyed, or get another state by `World::restore`, `World::take` or
/// assignment, and then works like any other.
class Damaged : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace fettle::physics

FETTLE_PHYSICS_END
