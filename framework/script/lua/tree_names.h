#pragma once
// Names of the property tree that nearly all sources of this library use.

#include <fettle/property/error.h>
#include <fettle/property/tree.h>

namespace fettle::script {

using property::Class;
using property::Error;
using property::ErrorKind;
using property::Handle;
using property::List;
using property::Property;
using property::Type;
using property::Value;
using property::Vec2;

}  // namespace fettle::script
