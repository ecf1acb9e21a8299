#pragma once

#include <fettle/property/class.h>

namespace fettle::physics_module {

class Hosting;

/// `why` explains mass, center, inertia, velocity and pose of bodies.
void explain_bodies(Hosting& hosting, const property::Class& body);

}  // namespace fettle::physics_module
