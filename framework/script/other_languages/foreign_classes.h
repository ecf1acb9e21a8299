#pragma once
// Names of classes in other engines: what is written in their place here.

#include <string>
#include <string_view>

#include <fettle/property/tree.h>

namespace fettle::script {

/// ` (write RevoluteJoint { ... })` for "HingeJoint2D"; "" for a name that no such engine has.
std::string hint_for_class(std::string_view name);

/// The class of that name. Throws Error with such a hint if there is none.
const property::Class& class_called(const property::Tree& tree, std::string_view name);

}  // namespace fettle::script
