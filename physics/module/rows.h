#pragma once
// Whether the rows that a snapshot gives to instances are theirs, and what it says of joints holds.

#include <array>
#include <vector>

#include "hosting.h"

namespace fettle::physics_module {

/// What is about to be there, each of it checked by itself.
struct RestoredObjects {
    std::array<physics::World*, most_worlds> worlds{};
    std::array<Handle, most_worlds> selves{};
    const std::vector<JointRecord>* joints = nullptr;
};

/// Within `Hosting::restore`. Throws Error(damaged) where an instance is to have a row that is
/// nobody's, somebody else's or of another kind, where an object is said to be that of an instance
/// that has another, and where a joint hangs in no world, ties what is no body or acts as another
/// type: bytes from a stranger may hold any number.
void check_rows(const Hosting& hosting, const RestoredObjects& objects,
                const property::ByteReader& from);

}  // namespace fettle::physics_module
