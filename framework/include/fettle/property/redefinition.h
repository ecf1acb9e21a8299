#pragma once
// Another definition of a class that has instances.

#include <vector>

#include <fettle/property/export.h>
#include <fettle/property/tree.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// Replaces the properties that a class without a module declares itself, while instances of it may
/// live: its code was loaded again. The instances get the default of a new property. A property of
/// another type keeps the values that fit the new type. One that is not in `own` does not exist any
/// more; pointers to it stay valid, but no instance has it. Throws Error, and has changed nothing,
/// for a name that a derived class or a child of an instance has.
void redefine(Tree& tree, const Class& of, std::vector<Property> own);

/// Replaces the events that a class without a module declares itself. An event of a name that was
/// there before keeps its handlers. Throws Error, and has changed nothing, for a name that the
/// class, its base or a derived class has for something else.
void declare_events(Tree& tree, const Class& of, std::vector<Event> own);

}  // namespace fettle::property

FETTLE_PROPERTY_END
