// Formulas as the tree's users see them; how they settle is formulas.cpp.

#include <fettle/property/path.h>
#include <fettle/property/question.h>
#include <fettle/property/tree.h>

#include <optional>

#include "state.h"

namespace fettle::property {

void Tree::State::require_changeable(std::string_view what) const {
    if (formulas.tracking())
        throw Error(ErrorKind::formula, "the formula of " + formulas.running() +
                                            " computes a value: it cannot " + std::string(what));
    if (inquiry != nullptr) inquiry->refuse(what);
}

void Tree::require_changeable(std::string_view what) const {
    state_->require_changeable(what);
}

bool Tree::changeable() const {
    return !state_->formulas.tracking() && state_->inquiry == nullptr;
}

bool takes_formula(const Property& property) {
    return !property.read_only && property.binding.kind != BindingKind::node;
}

void Tree::State::drop_formula(Handle instance, const Property& property) {
    formulas.remove({instance.index, property.symbol});
}

void Tree::set_formula(Handle instance, const Property& property, Formula formula) {
    State& s = *state_;
    s.require(instance, property);
    s.require_changeable("define a formula");
    if (s.nodes[instance.index].dying) s.require_staying(instance, "define a formula of it");
    if (!formula.function)
        throw Error(ErrorKind::wrong_type,
                    path(instance, property) + ": a formula needs a function");
    if (property.read_only)
        throw Error(ErrorKind::read_only, path(instance, property) + " is read-only");
    if (!takes_formula(property))
        throw Error(ErrorKind::bad_structure,
                    path(instance, property) +
                        ": cannot have a formula: it tells where the instance is in the tree, and "
                        "a formula computes a value and moves nothing; assign a plain value");
    std::optional<History::CellState> before;
    if (s.history.recording()) before = s.history.capture(instance, property);
    s.formulas.set(instance, property, std::move(formula));
    s.tell([&](Observer& o) { o.formula_changed(instance, property); });
    if (before) s.history.edited(instance, property, std::move(*before));
}

void Tree::set_formula(Handle instance, std::string_view name, Formula formula) {
    if (const Property* found = find(instance, name))
        return set_formula(instance, *found, std::move(formula));
    // The property and its formula come, and go again by undo, as one.
    state_->history.begin(path(instance) + path_suffix(name) + ": a formula", false);
    struct End {
        History& history;
        ~End() { history.end(); }
    } end{state_->history};
    set_formula(instance, state_->add_ad_hoc(instance, name, Value()), std::move(formula));
}

const Formula* Tree::formula(Handle instance, const Property& property) const {
    if (!state_->require(instance).has_formula) return nullptr;
    return state_->formulas.find({instance.index, property.symbol});
}

void Tree::remove_formula(Handle instance, const Property& property) {
    state_->require(instance, property);
    State& s = *state_;
    s.require_changeable("end a formula");
    if (s.formulas.find({instance.index, property.symbol}) == nullptr) return;
    std::optional<History::CellState> before;
    if (s.history.recording()) before = s.history.capture(instance, property);
    s.drop_formula(instance, property);
    s.tell([&](Observer& o) { o.formula_changed(instance, property); });
    if (before) s.history.edited(instance, property, std::move(*before));
}

std::string Tree::problem(Handle instance, const Property& property) const {
    state_->require(instance, property);
    return state_->formulas.problem({instance.index, property.symbol});
}

void on_formula_problem(Tree& tree, std::function<void(const FormulaProblem&)> sink) {
    tree.state().formulas.problem_sink = std::move(sink);
}

void formula_problem_told(Tree& tree, Handle instance, const Property& property) {
    tree.state().formulas.problem_told({instance.index, property.symbol});
}

Explanation Tree::why(Handle instance, const Property& property) const {
    state_->require(instance, property);
    std::vector<Cell> seen;
    return state_->formulas.why(instance, property, seen);
}

void Tree::compile_formulas_with(FormulaCompiler compiler) {
    state_->formula_compiler = std::move(compiler);
}
const FormulaCompiler& Tree::formula_compiler() const {
    return state_->formula_compiler;
}

// --- History ---

void Tree::observe_edits(EditObserver* observer) {
    state_->history.observe(observer);
}

void Tree::begin_edit(std::string name, bool scripts) {
    state_->require_changeable("begin an edit");
    state_->history.begin(std::move(name), scripts);
}
void Tree::end_edit() {
    state_->require_changeable("end an edit");
    state_->history.end();
}
UndoResult Tree::undo() {
    state_->require_changeable("undo");
    state_->require_no_deletion("undo");
    return state_->history.undo();
}
UndoResult Tree::redo() {
    state_->require_changeable("redo");
    state_->require_no_deletion("redo");
    return state_->history.redo();
}
std::vector<HistoryEntry> Tree::history() const {
    return state_->history.entries();
}
std::size_t Tree::history_bytes() const {
    return state_->history.bytes();
}
std::size_t Tree::history_bytes_ever() const {
    return state_->history.bytes_ever();
}
void Tree::set_history_limit(std::size_t bytes) {
    state_->require_changeable("limit the history");
    state_->history.set_limit(bytes);
}

Provenance Tree::who(Handle instance, const Property& property) const {
    state_->require(instance, property);
    if (const auto step = state_->shadows.simulated_at({instance.index, property.symbol}))
        return {.known = true, .cause = {.writer = Writer::simulation, .where = {}, .step = step}};
    state_->tell_plain_writes();
    Provenance written = state_->writes.find(instance, property.symbol);
    const bool computed = !property.derives_from.empty();
    if (written.known || !property.simulated || computed) return written;
    return {.known = true, .cause = {.writer = Writer::simulation, .where = {}, .step = step()}};
}

std::size_t Tree::formula_count() const {
    return state_->formulas.size();
}

bool Tree::in_formula() const {
    return state_->formulas.tracking();
}

}  // namespace fettle::property
