// Public functions for formulas; formulas.cpp settles them.

#include <fettle/property/path.h>
#include <fettle/property/question.h>

#include <optional>

#include "state.h"

namespace fettle::property {

void Tree::State::require_changeable(std::string_view what) const {
    if (instances.reads.noted())
        throw Error(ErrorKind::formula, "the formula of " + formulas.running() +
                                            " computes a value: it cannot " + std::string(what));
    if (underway.inquiry != nullptr) underway.inquiry->refuse(what);
}

void Tree::require_changeable(std::string_view what) const {
    state_->require_changeable(what);
}

bool Tree::changeable() const {
    return !state_->instances.reads.noted() && state_->underway.inquiry == nullptr;
}

void Tree::set_formula(Handle instance, const Property& property, Formula formula) {
    State& s = *state_;
    s.instances.require(instance, property);
    s.require_changeable("define a formula");
    if (s.instances.nodes[instance.index].being_deleted)
        s.underway.require_staying(s.instances, instance, "define a formula of it");
    if (!formula.function)
        throw Error(ErrorKind::wrong_type,
                    path(instance, property) + ": a formula needs a function");
    if (property.read_only)
        throw Error(ErrorKind::read_only, path(instance, property) + " is read-only");
    if (!takes_formula(property))
        throw Error(ErrorKind::bad_structure,
                    path(instance, property) +
                        ": cannot have a formula: it is the place of the instance in the tree, "
                        "which a formula may not change; assign a plain value");
    std::optional<CellState> before = s.history.before_edit(instance, property);
    s.formulas.set(instance, property, std::move(formula));
    s.changes.notify([&](Observer& o) { o.formula_changed(instance, property); });
    if (before) s.history.edited(instance, property, std::move(*before));
}

void Tree::set_formula(Handle instance, std::string_view name, Formula formula) {
    if (const Property* found = find(instance, name))
        return set_formula(instance, *found, std::move(formula));
    if (!formula.function)
        throw Error(ErrorKind::wrong_type,
                    path(instance) + path_suffix(name) + ": a formula needs a function");
    // Adding the property and setting its formula are one step of undo.
    state_->history.begin(path(instance) + path_suffix(name) + ": a formula", false);
    struct End {
        History& history;
        ~End() { history.end(); }
    } end{state_->history};
    set_formula(instance, state_->add_ad_hoc(instance, name, Value()), std::move(formula));
}

const Formula* Tree::formula(Handle instance, const Property& property) const {
    if (!state_->instances.require(instance).has_formula) return nullptr;
    return state_->formulas.find({instance.index, property.symbol});
}

void Tree::remove_formula(Handle instance, const Property& property) {
    state_->instances.require(instance, property);
    State& s = *state_;
    s.require_changeable("end a formula");
    if (s.formulas.find({instance.index, property.symbol}) == nullptr) return;
    std::optional<CellState> before = s.history.before_edit(instance, property);
    s.formulas.remove({instance.index, property.symbol});
    s.changes.notify([&](Observer& o) { o.formula_changed(instance, property); });
    if (before) s.history.edited(instance, property, std::move(*before));
}

std::string Tree::problem(Handle instance, const Property& property) const {
    if (!state_->instances.require(instance, property).has_formula) return {};
    return state_->formulas.problem({instance.index, property.symbol});
}

void on_formula_problem(Tree& tree, std::function<void(const FormulaProblem&)> sink) {
    tree.state().formulas.problem_sink = std::move(sink);
}

void formula_problem_reported(Tree& tree, Handle instance, const Property& property) {
    tree.state().formulas.problem_reported({instance.index, property.symbol});
}

void Tree::compile_formulas_with(FormulaCompiler compiler) {
    state_->formulas.compiler = std::move(compiler);
}
const FormulaCompiler& Tree::formula_compiler() const {
    return state_->formulas.compiler;
}

std::size_t Tree::formula_count() const {
    return state_->formulas.size();
}

bool Tree::in_formula() const {
    return state_->instances.reads.noted();
}

}  // namespace fettle::property
