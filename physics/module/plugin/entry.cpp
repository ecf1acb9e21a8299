// The entry point of physics as a module that plugs in.

#include <fettle/module/guest.h>
#include <fettle/physics_module/physics_module.h>

FETTLE_GUEST(fettle::physics_module::PhysicsModule, FETTLE_VERSION)
