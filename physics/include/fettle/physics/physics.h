#pragma once

// The headers of Fettle::physics that most programs need. geometry.h and outlines.h (functions that
// need no world) and mover.h (characters) are included by themselves.
#include <fettle/physics/instruction_set.h>
#include <fettle/physics/version.h>
#include <fettle/physics/world.h>
