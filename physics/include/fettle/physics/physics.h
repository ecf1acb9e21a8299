#pragma once

// Everything of Fettle::physics.
#include <fettle/physics/world.h>
