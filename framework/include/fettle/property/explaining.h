#pragma once
// Explanations of the values that a module computes, for `Tree::why`.

#include <functional>
#include <string>
#include <vector>

#include <fettle/property/export.h>
#include <fettle/property/tree.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// How a module explains a property of its class. Both functions get a live instance.
struct Explainer {
    /// One line for each source of the value: a path, or a path and what comes from it.
    std::function<std::vector<std::string>(Handle)> sources;
    /// Optional: called while `sources` is likely to be called soon. The module may begin to record
    /// what it needs for that.
    std::function<void(Handle)> prepare{};
};

/// `Tree::why` calls `explainer` for values of the property without a formula. A module in another
/// binary cannot explain its values; there this does nothing.
void explain_with(Tree& tree, const Property& property, Explainer explainer);

/// To be called in each frame in which a tool shows an instance: modules prepare their explanations
/// of its properties.
void prepare_explanations(Tree& tree, Handle instance);
/// True if `prepare_explanations` was called since the last call of this function. Then a host
/// turns on `Tree::locate_writes`, so that `last_writer` has the places of all writes.
bool consume_explanation_request(Tree& tree);

}  // namespace fettle::property

FETTLE_PROPERTY_END
