#pragma once

// All headers of Fettle::physics.
#include <fettle/physics/instruction_set.h>
#include <fettle/physics/version.h>
#include <fettle/physics/world.h>
