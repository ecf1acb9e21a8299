#pragma once

// Everything of Fettle::physics.
#include <fettle/physics/instruction_set.h>
#include <fettle/physics/world.h>
