#pragma once

#include <fettle/physics/export.h>

#include <stdexcept>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// A function that a world called has edited or destroyed this world; callbacks.h says what such a
/// function may do. Or the world has an owner, and only the owner creates and destroys its objects
/// (owner.h). The call that throws this has changed nothing.
class Locked : public std::invalid_argument {
  public:
    using std::invalid_argument::invalid_argument;
};

}  // namespace fettle::physics

FETTLE_PHYSICS_END
