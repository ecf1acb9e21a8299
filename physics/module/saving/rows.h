#pragma once
// Checks of a snapshot: that the rows of instances are theirs, and that joints join bodies.

#include <array>
#include <span>

#include <hosting/hosting.h>

namespace fettle::physics_module {

/// Objects that the snapshot will restore, each checked by itself.
struct RestoredObjects {
    std::array<physics::World*, most_worlds> worlds{};
    std::array<Handle, most_worlds> selves{};
    std::array<std::span<const Ties>, most_worlds> ties{};
};

/// Called within `Hosting::restore`. Throws Error(damaged) if the row of an instance is the row of
/// no object, of another instance's object or of another kind, if an object names an instance that
/// has another row, and if a joint joins an instance that is no body: foreign bytes may hold any
/// number.
void check_rows(const Hosting& hosting, const RestoredObjects& objects,
                const property::ByteReader& from);

}  // namespace fettle::physics_module
