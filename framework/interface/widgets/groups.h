#pragma once
// Properties that several classes of widgets have.

#include <vector>

#include <widgets/widgets.h>

namespace fettle::interface {

using Properties = std::vector<property::Property>;

Properties common_properties(Widgets& widgets);
Properties container_properties(Widgets& widgets);
Properties line_up_properties(Widgets& widgets);
/// Font and color of a text; `align`: "left", "center" or "right", where it is by default.
Properties text_properties(Widgets& widgets, const char* align, const char* overflow);
property::Property text_property(Widgets& widgets, const char* doc);
property::Property bind_property(Widgets& widgets, const char* doc);
property::Property min_property(Widgets& widgets);
property::Property max_property(Widgets& widgets);

template <class... Lists>
Properties joined(Properties first, Lists... more) {
    const auto add = [&](Properties& list) {
        for (property::Property& each : list) first.push_back(std::move(each));
    };
    (add(more), ...);
    return first;
}

}  // namespace fettle::interface
