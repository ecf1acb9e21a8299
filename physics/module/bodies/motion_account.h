#pragma once

#include <fettle/property/class.h>

namespace fettle::physics_module {

class Hosting;

/// `why` explains the velocity and the pose of bodies.
void explain_motion(Hosting& hosting, const property::Class& body);

}  // namespace fettle::physics_module
