#pragma once
// Checks of a snapshot: each instance must have its own object, and joints must connect bodies.

#include <array>
#include <span>

#include <hosting/hosting.h>

namespace fettle::physics_module {

/// The objects in the snapshot, each of which is already checked separately.
struct RestoredObjects {
    std::array<physics::World*, max_worlds> worlds{};
    std::array<Handle, max_worlds> selves{};
    std::array<std::span<const Ties>, max_worlds> ties{};
};

/// Called within `Hosting::restore`. Throws Error(damaged) if the row of an instance refers to no
/// object, to the object of another instance or to an object of another kind; if an object refers
/// to an instance with another row; or if a joint connects an instance that is not a body. Bytes
/// from a file may contain any number.
void check_rows(const Hosting& hosting, const RestoredObjects& objects,
                const property::ByteReader& from);

}  // namespace fettle::physics_module
