#pragma once
// Names that no child of any instance can have, because they mean something else there.

#include <string>
#include <vector>

#include <fettle/property/export.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

class Tree;

/// From now on, an instance that is created, placed or renamed below another one cannot get one of
/// these names: the scripts of a tree reserve those of the methods that every instance has. They
/// replace names that were reserved before; instances that exist keep their names. A class
/// cannot have a property or a method of one of these names, except for Object and for classes that
/// users cannot create: throws Error(bad_name) if a class has one already.
void reserve_names(Tree& tree, const std::vector<std::string>& names);

}  // namespace fettle::property

FETTLE_PROPERTY_END
