#pragma once
// Information for a module that reads its part of a snapshot.

#include <functional>

#include <fettle/property/class.h>
#include <fettle/property/export.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

class Tree;

/// Visits each instance that the snapshot contains, with its class and its row. A part that stores
/// rows itself must check here that each row exists and belongs to the instance, because bytes from
/// a file may contain any number. To be called only inside `SnapshotPart::restore`; at any other
/// time it visits nothing.
void each_restored(const Tree& tree, const std::function<void(Handle, const Class&, Row)>& visit);

}  // namespace fettle::property

FETTLE_PROPERTY_END
