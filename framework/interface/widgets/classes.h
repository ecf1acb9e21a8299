#pragma once
// The descriptors of the classes that scripts make.

#include <vector>

#include <widgets/widgets.h>

namespace fettle::interface {

std::vector<property::ClassDescriptor> container_classes(Widgets& widgets);
std::vector<property::ClassDescriptor> control_classes(Widgets& widgets);
/// The name of the property that shows what the widget is about: "value", "text", "selected"; ""
/// if it has none.
const char* main_property(Kind kind);

}  // namespace fettle::interface
