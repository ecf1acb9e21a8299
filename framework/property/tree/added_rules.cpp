#include <fettle/property/added_rules.h>

#include "state.h"

namespace fettle::property {

void set_added_rules(Tree& tree, const Class& of, AddedRules* rules) {
    auto& all = tree.state().added_rules;
    std::erase_if(all, [&of](const auto& each) { return each.first == &of; });
    if (rules != nullptr) all.emplace_back(&of, rules);
}

bool has_added_rules(const Tree& tree, Handle instance) {
    return tree.state().rules_of(instance) != nullptr;
}

AddedRules* Tree::State::rules_of(Handle instance) const {
    if (added_rules.empty() || !tree.alive(instance)) return nullptr;
    const Class* of = &tree.class_of(instance);
    for (const auto& [ruled, rules] : added_rules)
        if (ruled == of) return rules;
    return nullptr;
}

}  // namespace fettle::property
