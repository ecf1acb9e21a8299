#pragma once
// The end of a class whose module ends before the tree.

#include <fettle/property/class.h>
#include <fettle/property/export.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

class Tree;

/// For the owner of the memory that the properties of a class are bound to, before that memory
/// ends. Deletes all instances of the class and of classes that derive from it, with everything
/// below them. The class stays registered, but no instance of it, or of a class that derives from
/// it, can be made, restored or brought back by undo any more: that throws Error(rejected).
/// Exceptions of lifecycle functions are ignored if the instance is gone. Throws Error where
/// instances cannot be deleted, for example in a formula or a lifecycle function; a second call
/// deletes the rest.
void end_class(Tree& tree, const Class& ended);

}  // namespace fettle::property

FETTLE_PROPERTY_END
