#pragma once

#include <fettle/physics/export.h>

// Version of the library. The macros are the version of the headers with which a program is
// compiled, `version` is that of the library with which it runs. Versions with the same major and
// minor number are compatible.

#define FETTLE_PHYSICS_VERSION_MAJOR 0
#define FETTLE_PHYSICS_VERSION_MINOR 1
#define FETTLE_PHYSICS_VERSION_PATCH 0

FETTLE_PHYSICS_BEGIN

/// One number to compare with: 10000 for each major version, 100 for each minor version.
#define FETTLE_PHYSICS_VERSION                                                   \
    (FETTLE_PHYSICS_VERSION_MAJOR * 10000 + FETTLE_PHYSICS_VERSION_MINOR * 100 + \
     FETTLE_PHYSICS_VERSION_PATCH)

namespace fettle::physics {

/// The value of FETTLE_PHYSICS_VERSION in the library with which the program runs.
[[nodiscard]] int version() noexcept;

}  // namespace fettle::physics

FETTLE_PHYSICS_END
