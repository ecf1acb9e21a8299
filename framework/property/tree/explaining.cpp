// Explanations of values by the modules that compute them.

#include <fettle/property/explaining.h>

#include <utility>

#include "state.h"

namespace fettle::property {

void explain_with(Tree& tree, const Property& property, Explainer explainer) {
    tree.state().explainers[&property] = std::move(explainer);
}

void prepare_explanations(Tree& tree, Handle instance) {
    if (!tree.alive(instance)) return;
    tree.state().looked_at = true;
    const auto& all = tree.state().explainers;
    if (all.empty()) return;
    for (const Property* property : tree.class_of(instance).properties())
        if (const auto found = all.find(property); found != all.end() && found->second.prepare)
            found->second.prepare(instance);
}

bool consume_explanation_request(Tree& tree) {
    return std::exchange(tree.state().looked_at, false);
}

Explanation Tree::why(Handle instance, const Property& property) const {
    State& s = *state_;
    s.instances.require(instance, property);
    std::vector<Cell> seen;
    Explanation out = s.formulas.why(instance, property, seen);
    if (formula(instance, property) != nullptr) return out;
    const auto found = s.explainers.find(&property);
    if (found == s.explainers.end()) return out;
    for (std::string& line : found->second.sources(instance)) {
        Explanation& source = out.from.emplace_back();
        source.path = std::move(line);
    }
    return out;
}

}  // namespace fettle::property
