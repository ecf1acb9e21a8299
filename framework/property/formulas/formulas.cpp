#include "formulas.h"

#include <algorithm>
#include <utility>

#include <fettle/property/error.h>
#include <fettle/property/exception_text.h>

#include <values/weight.h>

namespace fettle::property {
namespace {

// On the first run the dependencies are unknown, so formulas that read formulas run inside each
// other. Lua allows only 200 nested C calls. A deeper nest is abandoned and computed from its
// deepest formula on.
constexpr std::size_t deepest_nest = 24;

}  // namespace

bool takes_formula(const Property& property) {
    return !property.read_only && property.binding.kind != BindingKind::node;
}

// --- Creation and removal

Formulas::Entry* Formulas::entry(Cell cell) const {
    const auto found = entries_.find(cell);
    return found == entries_.end() ? nullptr : found->second.get();
}

const Formula* Formulas::find(Cell cell) const {
    const Entry* e = entry(cell);
    return e != nullptr ? &e->formula : nullptr;
}

void Formulas::set(Handle instance, const Property& property, Formula formula) {
    const Cell cell{instance.index, property.symbol};
    remove(cell);
    // Removed entries are erased when they are the majority; erasing each one at once would be
    // slow.
    if (order_.size() > 64 + 2 * entries_.size())
        std::erase_if(order_, [](const auto& e) { return e->removed; });
    changes_.weight.add(weight_of_formula);
    const auto made = std::make_shared<Entry>();
    made->cell = cell;
    made->instance = instance;
    made->property = &property;
    made->formula = std::move(formula);
    made->number = ++made_;
    made->value = tree_.peek(instance, property);
    entries_[cell] = made;
    order_.push_back(made);
    changes_.instances.nodes[instance.index].has_formula = true;
    pending_ = true;
    mark_dependents(cell);
}

std::string Formulas::running() const {
    const Entry& e = *stack_.back();
    return tree_.path(e.instance, *e.property);
}

void Formulas::remove(Cell cell) {
    const auto found = entries_.find(cell);
    if (found == entries_.end()) return;
    const std::shared_ptr<Entry> gone = found->second;
    changes_.weight.add(-weight_of_formula);
    set_dependencies(*gone, {});
    if (gone->volatile_sources) --volatile_;
    gone->removed = true;
    reported_.erase(cell);
    entries_.erase(found);
    if (entries_.empty()) order_.clear();
    mark_dependents(cell);
}

std::vector<Formulas::Image> Formulas::images() const {
    std::vector<Image> all;
    all.reserve(entries_.size());
    for (const auto& e : order_)
        if (!e->removed) all.push_back({e->instance, e->property->symbol, e->formula});
    return all;
}

void Formulas::clear() {
    for (const auto& e : order_) e->removed = true;
    changes_.weight.add(-weight_of_formula * static_cast<std::int64_t>(entries_.size()));
    entries_.clear();
    order_.clear();
    dependents_.clear();
    read_of_.clear();
    volatile_ = 0;
    pending_ = false;
}

void Formulas::instance_gone(std::uint32_t index) {
    const auto names = read_of_.find(index);
    if (names == read_of_.end()) return;
    const std::vector<Symbol> read(names->second.begin(), names->second.end());
    for (const Symbol name : read) mark_dependents({index, name});
}

void Formulas::name_changed(std::uint32_t parent, const NodeName& name) {
    if (entries_.empty()) return;
    // A name without a symbol was never read, so no formula depends on it.
    if (const Symbol asked = Symbol::find(name.text())) mark_dependents({parent, asked});
    mark_dependents(Reads::structure);
}

void Formulas::written(Handle handle, const Node& node, const Property& property,
                       const Value& old_value) {
    if (node.has_dependents) mark_dependents({handle.index, property.symbol});
    changes_.written(handle, node, property, old_value);
}

// --- Push: marking

void Formulas::mark_dependents(Cell cell) {
    const auto first = dependents_.find(cell);
    if (first == dependents_.end()) return;
    // A source that is written repeatedly marks its dependents once.
    if (std::exchange(first->second.marked, settlings_) == settlings_) return;
    std::vector<Entry*> reached;
    const auto reach = [&reached](Entry* e, State as) {
        if (e->state == State::clean) reached.push_back(e);
        e->state = std::max(e->state, as);
    };
    for (const Dependent& d : first->second.list) reach(d.formula, State::dirty);
    while (!reached.empty()) {
        const Entry* e = reached.back();
        reached.pop_back();
        if (const auto next = dependents_.find(e->cell); next != dependents_.end())
            for (const Dependent& d : next->second.list) reach(d.formula, State::check);
    }
    pending_ = true;
}

void Formulas::make_volatile(Entry& top) {
    std::vector<Entry*> reached{&top};
    while (!reached.empty()) {
        Entry* e = reached.back();
        reached.pop_back();
        if (e->volatile_sources) continue;
        e->volatile_sources = true;
        ++volatile_;
        if (const auto next = dependents_.find(e->cell); next != dependents_.end())
            for (const Dependent& d : next->second.list) reached.push_back(d.formula);
    }
}

// --- Pull: settling

bool Formulas::settled(const Entry& e) const {
    return e.state == State::clean && (!e.volatile_sources || e.checked == changes_.epoch());
}

Formulas::Finding Formulas::check_sources(const Entry& e, Entry*& unsettled) const {
    for (const Dependency& d : e.dependencies) {
        if (d.formula) {
            Entry* source = entry(d.cell);
            if (source == nullptr) return Finding::changed;
            if (!settled(*source)) {
                unsettled = source;
                return Finding::unsettled_source;
            }
            if (source->version != d.version) return Finding::changed;
        } else if (d.observed) {
            if (changes_.instances.nodes.find(d.instance) == nullptr) return Finding::changed;
            if (!(tree_.peek(d.instance, *d.property) == d.seen)) return Finding::changed;
        }
    }
    return Finding::unchanged;
}

// Settles the sources first, along the dependencies of the last run. There is no recursion, so the
// length of a chain is not limited.
void Formulas::settle_known(Entry& top) {
    std::vector<Entry*> way{&top};
    top.queued = true;
    struct Unqueue {
        std::vector<Entry*>& way;
        ~Unqueue() {
            for (Entry* e : way) e->queued = false;
        }
    } unqueue{way};
    while (!way.empty()) {
        Entry& e = *way.back();
        if (!settled(e)) {
            Entry* source = nullptr;
            const Finding finding = check_sources(e, source);
            if (finding == Finding::unsettled_source && !source->queued && !source->running) {
                source->queued = true;
                way.push_back(source);
                continue;
            }
            if (e.state == State::dirty || finding != Finding::unchanged) {
                run(e);
            } else {
                note_settled(e);
            }
        }
        e.queued = false;
        way.pop_back();
    }
}

void Formulas::settle(Entry& e) {
    if (!stack_.empty()) {
        if (stack_.size() >= deepest_nest && !settled(e)) {
            too_deep_ = &e;
            throw Error(ErrorKind::formula, "formulas are nested too deep");
        }
        return settle_known(e);
    }
    std::vector<Entry*> ends{&e};
    while (!ends.empty()) {
        too_deep_ = nullptr;
        try {
            settle_known(*ends.back());
        } catch (const Error&) {
            if (too_deep_ == nullptr) throw;
        }
        if (too_deep_ == nullptr) {
            ends.pop_back();
        } else if (std::find(ends.begin(), ends.end(), too_deep_) == ends.end()) {
            ends.push_back(too_deep_);
        } else {
            fail_in_long_cycle(*too_deep_);
        }
    }
}

// A cycle that is longer than formulas may be nested. This formula counts as settled while the
// others of the cycle read it, so they end with its error. They are settled before it is settled
// again, and it reads them then.
void Formulas::fail_in_long_cycle(Entry& e) {
    e.origin.clear();
    fail(e, "it depends on itself, through more than " + std::to_string(deepest_nest) +
                " other formulas");
    note_settled(e);
}

void Formulas::settle(Cell cell) {
    const auto found = entries_.find(cell);
    if (found == entries_.end() || changes_.replaying) return;
    const std::shared_ptr<Entry> e = found->second;
    if (e->running) throw Error(ErrorKind::formula, note_cycle(*e));
    // An inquiry must not write the memory of the owner, so the formula keeps its value.
    if (!settled(*e) && underway_.inquiry == nullptr) settle(*e);
    if (e->error.empty() || e->removed) return;
    // An error that passes through many formulas names the formula that was read and the formula in
    // which the error began. With all formulas in between, the texts of n formulas would need space
    // for n² names.
    const std::string start = tree_.path(e->instance, *e->property) + " is in error: ";
    passed_on_ = e->origin.empty() ? start + e->error : e->origin;
    throw Error(ErrorKind::formula, e->origin.empty() ? passed_on_ : start + e->origin);
}

// Every formula of a cycle gets the same text, which begins with the formula that was made first.
// So the text does not depend on which of them is read first.
std::string Formulas::note_cycle(const Entry& again) {
    std::vector<Entry*> cycle(std::find(stack_.begin(), stack_.end(), &again), stack_.end());
    const auto first =
        std::min_element(cycle.begin(), cycle.end(),
                         [](const Entry* a, const Entry* b) { return a->number < b->number; });
    std::rotate(cycle.begin(), first, cycle.end());
    std::string text = "it depends on itself: ";
    for (const Entry* e : cycle) text += tree_.path(e->instance, *e->property) + " → ";
    text += tree_.path(cycle.front()->instance, *cycle.front()->property);
    for (Entry* e : cycle) e->cycle = text;
    return text;
}

std::vector<Read>* Formulas::note_in(std::vector<Read>* reads) {
    changes_.writes.close(WritesLog::Reason::formula, reads != nullptr);
    return changes_.instances.reads.note_in(reads);
}

void Formulas::note_settled(Entry& e) {
    e.state = State::clean;
    e.checked = changes_.epoch();
    ++settlings_;
}

void Formulas::run(Entry& e) {
    const std::shared_ptr<Entry> held = entries_.at(e.cell);
    std::vector<Read> found;
    Value result;
    std::string error;
    e.cycle.clear();
    e.running = true;
    stack_.push_back(&e);
    std::vector<Read>* const outer = note_in(&found);
    try {
        result = e.formula.function(tree_);
    } catch (...) {
        error = exception_text();
        if (error.empty()) error = "failed";
    }
    if (!e.cycle.empty()) error = e.cycle;
    e.origin = !error.empty() && !passed_on_.empty() && error.ends_with(passed_on_) ? passed_on_
                                                                                    : std::string();
    note_in(nullptr);  // reads by a setter are not noted
    stack_.pop_back();
    e.running = false;
    struct Restore {
        Formulas& formulas;
        std::vector<Read>* outer;
        ~Restore() { formulas.note_in(outer); }
    } restore{*this, outer};
    if (too_deep_ != nullptr) throw Error(ErrorKind::formula, "formulas are nested too deep");
    if (e.removed) return;
    set_dependencies(e, found);
    note_settled(e);
    if (error.empty())
        finish(e, result);
    else
        fail(e, error);
}

void Formulas::finish(Entry& e, const Value& result) {
    Instances& instances = changes_.instances;
    Value next;
    try {
        const Pin pin(changes_.lifetime, "a binding of a property");
        next = tree_.coerce(e.instance, *e.property, result);
        const Value old = tree_.peek(e.instance, *e.property);
        if (!(next == old)) {
            instances.write(e.instance.index, instances.require(e.instance), *e.property, next);
            const Tree::CauseScope scope(tree_, Writer::formula);
            written(e.instance, instances.require(e.instance), *e.property, old);
            changes_.notify([&](Observer& o) { o.wrote(e.instance, *e.property, next); });
        }
    } catch (...) {
        e.origin.clear();
        return fail(e, exception_text());
    }
    if (!(next == e.value) || !e.error.empty()) {
        ++e.version;
        mark_dependents(e.cell);
    }
    e.value = next;
    problems_changed_ = problems_changed_ || !e.error.empty();
    e.error.clear();
    note_settled(e);
}

void Formulas::fail(Entry& e, const std::string& error) {
    if (error == e.error) return;
    e.error = error;
    problems_changed_ = true;
    ++e.version;
    mark_dependents(e.cell);
}

void Formulas::settle_all(bool stepped) {
    if (entries_.empty() || (!pending_ && volatile_ == 0 && !stepped)) return;
    pending_ = false;
    const std::vector<std::shared_ptr<Entry>> all = order_;
    for (const std::shared_ptr<Entry>& e : all) {
        if (e->removed) continue;
        try {
            // The simulation may have written the property; the value of the formula replaces it.
            if (stepped && e->property->simulated &&
                !(tree_.peek(e->instance, *e->property) == e->value))
                e->state = State::dirty;
            if (!settled(*e)) settle(*e);
        } catch (const Error&) {
            // The entry stores the error; a read of the cell throws it.
        }
    }
}

}  // namespace fettle::property
