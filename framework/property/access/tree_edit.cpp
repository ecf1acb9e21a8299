// Properties of a tree: reading and writing. A write has these steps:
//
//   1 coerce  2 validate  3 stop if equal  4 note for the history  5 call the owner's setter
//   6 call its invalidate hook  7 queue the change
//
// Steps 1 and 2 are in coerce.cpp. Step 4 is only for recorded edits and stores the old state of
// the cell. The history gets the edit after the last step, so a refused write leaves nothing in it.

#include <optional>

#include <fettle/property/added_rules.h>
#include <fettle/property/path.h>
#include <fettle/property/spelling.h>

#include <classes/coerce.h>

#include <tree/state.h>

namespace fettle::property {

std::string Tree::path(Handle instance, const Property& property) const {
    const std::string suffix = path_suffix(property.name);
    if (instance == state_->instances.root)
        return suffix.front() == '.' ? suffix.substr(1) : "game" + suffix;
    return path(instance) + suffix;
}

// --- Look-up

const Property* Tree::find(Handle instance, Symbol name) const {
    const State& s = *state_;
    if (name) s.instances.reads.note_name(instance, name);
    const Node& node = s.instances.require(instance);
    if (const Property* declared = s.instances.classes[node.class_id].property(name))
        return declared;
    if (!node.has_ad_hoc || !name) return nullptr;
    const AdHoc::Entry* own = s.instances.ad_hoc.find(instance.index, name.text());
    return own == nullptr ? nullptr : own->first;
}

const Property* Tree::find(Handle instance, std::string_view name) const {
    // In a formula a missing name is a dependency too, so it needs a symbol.
    return find(instance, in_formula() ? Symbol(name) : Symbol::find(name));
}

const Property& Tree::property(Handle instance, std::string_view name) const {
    if (const Property* found = find(instance, name)) return *found;
    std::vector<std::string> names = class_of(instance).member_names();
    for (const Property* own : ad_hoc(instance)) names.push_back(own->name);
    for (const Handle c : children(instance)) names.push_back(this->name(c));
    throw Error(ErrorKind::unknown_name, path(instance) + " has no property \"" +
                                             std::string(name) + "\"" + suggestion(name, names));
}

std::vector<const Property*> Tree::ad_hoc(Handle instance) const {
    std::vector<const Property*> all;
    if (state_->instances.require(instance).has_ad_hoc)
        for (const auto& [name, own] : state_->instances.ad_hoc.of_instance.at(instance.index))
            all.push_back(own.first);
    return all;
}

std::vector<const Property*> Tree::properties(Handle instance) const {
    std::vector<const Property*> all = class_of(instance).properties();
    for (const Property* own : ad_hoc(instance)) all.push_back(own);
    return all;
}

// --- Reading

Value Tree::get(Handle instance, const Property& property) const {
    State& s = *state_;
    s.instances.reads.note_value(instance, property);
    const Node& node = s.instances.require(instance, property);
    if (node.has_formula) s.formulas.settle({instance.index, property.symbol});
    // The most common binding, without a further call.
    const Binding& binding = property.binding;
    if (binding.kind == BindingKind::accessor) return binding.get(binding.context, node.row);
    return s.instances.read(instance.index, node, property);
}

Value Tree::peek(Handle instance, const Property& property) const {
    return state_->instances.read(instance.index, state_->instances.require(instance, property),
                                  property);
}

Value Tree::get(Handle instance, std::string_view name) const {
    return get(instance, property(instance, name));
}

// --- Editing

Value Tree::coerce(Handle instance, const Property& property, const Value& value) const {
    state_->instances.require(instance, property);
    return state_->instances.coerce(instance, property, value);
}

void Tree::set(Handle instance, const Property& property, const Value& value) {
    State& s = *state_;
    const Node& node = s.instances.require(instance, property);
    s.require_changeable("write");
    if (value.is(property.type)) {
        bool done = false;
        if (value.is(Type::number)) done = write(instance, property, value.number());
        if (value.is(Type::vec2)) done = write(instance, property, value.vec2());
        if (done && !s.changes.observers.all.empty())
            s.changes.report_plain_writes();  // at once, unlike `write`
        if (done) return;
    }
    if (property.read_only)
        throw Error(ErrorKind::read_only,
                    path(instance, property) + " is read-only" +
                        (property.derives_from.empty() ? "" : ": it is derived"));
    if (value.is_nil() && !property.nullable && property.type != Type::reference) {
        if (property.binding.kind == BindingKind::ad_hoc)
            return remove_ad_hoc(instance, property.name);
        return reset(instance, property);
    }
    const Pin pin(s.lifetime, "a binding of a property");
    const Value next = s.instances.coerce(instance, property, value);
    AddedRules* const rules =
        property.binding.kind == BindingKind::ad_hoc ? s.rules_of(instance) : nullptr;
    if (rules != nullptr) rules->check(instance, property.name, next);
    std::optional<CellState> before = s.history.before_edit(instance, property);
    const Value old = s.instances.read(instance.index, node, property);
    const bool had_formula =
        node.has_formula && s.formulas.find({instance.index, property.symbol}) != nullptr;
    const bool is_overridden = property.binding.overridden == nullptr ||
                               property.binding.overridden(property.binding.context, node.row);
    if (old == next && is_overridden && !had_formula) {
        // The object of the property may be gone: a deleted action, for example.
        if (rules != nullptr) rules->changed(instance, property.name);
        return;
    }
    try {
        s.instances.write(instance.index, node, property, next);
    } catch (...) {
        s.instances.refused(instance, property);
    }
    // An accepted value replaces the formula; after a refused one the formula stays.
    if (had_formula) s.formulas.remove({instance.index, property.symbol});
    // The setter may have moved the node table (by a rename or a new parent), so the node is looked
    // up again.
    if (const Node* after = s.instances.nodes.find(instance)) {
        s.note_content(instance, *after, property, old);
        s.formulas.written(instance, *after, property, old);
        s.changes.notify([&](Observer& o) { o.wrote(instance, property, next); });
    }
    if (before) s.history.edited(instance, property, std::move(*before));
    if (rules != nullptr) rules->changed(instance, property.name);
}

void Tree::set(Handle instance, std::string_view name, const Value& value) {
    set(instance, property(instance, name), value);
}

void Tree::reset(Handle instance, const Property& property) {
    State& s = *state_;
    const Node& node = s.instances.require(instance, property);
    s.require_changeable("write");
    if (property.read_only)
        throw Error(ErrorKind::read_only, path(instance, property) + " is read-only");
    if (property.binding.kind == BindingKind::ad_hoc) return remove_ad_hoc(instance, property.name);
    if (property.binding.kind == BindingKind::node)
        throw Error(ErrorKind::wrong_type,
                    path(instance, property) + ": expected " + expectation(property) + ", got nil");
    const bool redeclared = property.owner != nullptr && property.owner->base() != nullptr &&
                            property.owner->base()->property(property.symbol) != nullptr;
    if (property.binding.reset == nullptr || redeclared)
        return set(instance, property, property.default_value);
    const Pin pin(s.lifetime, "a binding of a property");
    std::optional<CellState> before = s.history.before_edit(instance, property);
    const Value old = s.instances.read(instance.index, node, property);
    try {
        property.binding.reset(property.binding.context, node.row);
    } catch (...) {
        s.instances.refused(instance, property);
    }
    if (node.has_formula) s.formulas.remove({instance.index, property.symbol});
    if (property.binding.invalidate != nullptr)
        property.binding.invalidate(property.binding.context, node.row);
    s.formulas.written(instance, node, property, old);
    s.changes.notify([&](Observer& o) { o.was_reset(instance, property); });
    if (before) s.history.edited(instance, property, std::move(*before));
}

bool Tree::overridden(Handle instance, const Property& property) const {
    const Node& node = state_->instances.require(instance, property);
    if (property.binding.kind == BindingKind::ad_hoc) return true;
    if (property.read_only) return false;
    if (property.binding.overridden != nullptr)
        return property.binding.overridden(property.binding.context, node.row);
    if (property.binding.kind == BindingKind::node) return false;
    return !(state_->instances.read(instance.index, node, property) == property.default_value);
}

std::string Tree::text(const Value& value, Precision precision) const {
    if (value.is(Type::reference)) {
        if (!value.reference()) return "nil";
        return alive(value.reference()) ? path(value.reference()) : "(deleted)";
    }
    if (!value.is(Type::list)) return value_text(value, precision);
    std::string out = "{";
    for (const Value& element : value.list()) {
        if (out.size() > 1) out += ", ";
        out += text(element, precision);
    }
    return out + "}";
}

}  // namespace fettle::property
