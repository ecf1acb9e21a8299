// Formulas as the tree's users see them; how they settle is formulas.cpp.

#include <fettle/property/tree.h>

#include "state.h"

namespace fettle::property {

void Tree::State::forbid_in_formula(const char* what) const {
    if (formulas.tracking())
        throw Error(ErrorKind::formula,
                    std::string("a formula computes a value: it cannot ") + what);
}

void Tree::State::drop_formula(Handle instance, const Property& property) {
    formulas.remove({instance.index, property.symbol});
}

void Tree::set_formula(Handle instance, const Property& property, Formula formula) {
    State& s = *state_;
    s.require(instance);
    s.forbid_in_formula("define another");
    if (property.read_only)
        throw Error(ErrorKind::read_only, path(instance, property) + " is read-only");
    s.formulas.set(instance, property, std::move(formula));
}

void Tree::set_formula(Handle instance, std::string_view name, Formula formula) {
    const Property* found = find(instance, name);
    set_formula(instance, found != nullptr ? *found : state_->add_ad_hoc(instance, name, Value()),
                std::move(formula));
}

const Formula* Tree::formula(Handle instance, const Property& property) const {
    if (!state_->require(instance).has_formula) return nullptr;
    return state_->formulas.find({instance.index, property.symbol});
}

void Tree::remove_formula(Handle instance, const Property& property) {
    state_->require(instance);
    state_->forbid_in_formula("end another");
    state_->drop_formula(instance, property);
}

std::string Tree::problem(Handle instance, const Property& property) const {
    state_->require(instance);
    return state_->formulas.problem({instance.index, property.symbol});
}

Explanation Tree::why(Handle instance, const Property& property) const {
    state_->require(instance);
    std::vector<Cell> seen;
    return state_->formulas.why(instance, property, seen);
}

std::size_t Tree::formula_count() const {
    return state_->formulas.size();
}

bool Tree::in_formula() const {
    return state_->formulas.tracking();
}

}  // namespace fettle::property
