#pragma once

#include <fettle/physics/export.h>

#include <stdexcept>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// A world was edited by a function that it was calling itself, or was destroyed by one: what is
/// allowed where is told in callbacks.h. Or it belongs to a host that alone makes and ends what is
/// in it (owner.h). Nothing has changed by the call that throws this.
class Locked : public std::invalid_argument {
  public:
    using std::invalid_argument::invalid_argument;
};

}  // namespace fettle::physics

FETTLE_PHYSICS_END
