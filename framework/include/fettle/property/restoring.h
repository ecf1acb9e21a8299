#pragma once
// Information for a module that reads its part of a snapshot.

#include <functional>

#include <fettle/property/class.h>
#include <fettle/property/export.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

class Tree;

/// Inside `SnapshotPart::restore`: visits each instance that will exist, with its class and its
/// row. A part that stores rows itself must check here that each row exists and belongs to the
/// instance, because bytes from a file may contain any number. At any other time there are no
/// instances.
void each_restored(const Tree& tree, const std::function<void(Handle, const Class&, Row)>& visit);

}  // namespace fettle::property

FETTLE_PROPERTY_END
