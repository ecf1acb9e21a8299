#pragma once
// Where values come from that a module computes. The module knows; `Tree::why` asks it.

#include <functional>
#include <string>
#include <vector>

#include <fettle/property/export.h>
#include <fettle/property/tree.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// How a module explains a property of its class. Both functions get an instance that lives.
struct Explainer {
    /// One line for each source of the value: a path, or a path and what comes from it.
    std::function<std::vector<std::string>(Handle)> sources;
    /// Optional: the question may come soon. The module may begin to note what it needs.
    std::function<void(Handle)> prepare{};
};

/// `Tree::why` calls `explainer` for values of the property without a formula. A module in another
/// binary cannot explain its values; there this does nothing.
void explain_with(Tree& tree, const Property& property, Explainer explainer);

/// To be called when somebody looks at an instance: modules prepare their explanations of its
/// properties.
void prepare_explanations(Tree& tree, Handle instance);
/// Whether that was called since the last question. Then a host lets `who` have the places of all
/// writes (`Tree::locate_writes`).
bool take_prepared(Tree& tree);

}  // namespace fettle::property

FETTLE_PROPERTY_END
