#pragma once

#include <fettle/physics/export.h>

#include <stdexcept>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// Thrown in two cases. A function that a world called has edited or destroyed this world
/// (callbacks.h describes what such a function may do). Or the world has an owner, and only the
/// owner may create and destroy its objects (owner.h). The call has changed nothing.
class Locked : public std::invalid_argument {
  public:
    using std::invalid_argument::invalid_argument;
};

}  // namespace fettle::physics

FETTLE_PHYSICS_END
