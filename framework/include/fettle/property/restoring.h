#pragma once
// What a module may know of a snapshot while it reads its own part of it.

#include <functional>

#include <fettle/property/class.h>
#include <fettle/property/export.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

class Tree;

/// Within `SnapshotPart::restore`: who is about to be there, as what, and which row it is going to
/// have. A part that says itself what rows are checks here that each is one of its own, and whose
/// it is: bytes from a stranger may hold any number. Nobody at any other time.
void each_restored(const Tree& tree, const std::function<void(Handle, const Class&, Row)>& visit);

}  // namespace fettle::property

FETTLE_PROPERTY_END
