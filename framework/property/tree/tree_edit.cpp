// Properties of a tree: reading, and the edit pipeline.
//
//   1 coerce  2 validate  3 equal? stop  4 note for the history  5 the owner's setter  6 its
//   invalidate hook  7 queue the change
//
// Steps 1 and 2 are coerce.cpp. Step 4 is for edits that are recorded, and notes what the cell was;
// the history is told of the edit at the end, when the cell is what it has become, so that a write
// that the owner refuses leaves nothing in it.

#include <algorithm>
#include <cstring>
#include <optional>
#include <stdexcept>

#include <fettle/property/path.h>
#include <fettle/property/spelling.h>
#include <fettle/property/tree.h>

#include <classes/coerce.h>

#include "state.h"

namespace fettle::property {
namespace {

// Names of ad-hoc properties in a tree: their descriptors stay for ever.
constexpr std::size_t most_own_names = 100'000;

template <class T>
T load(const std::byte* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

template <class T>
void store(std::byte* at, const T& value) {
    std::memcpy(at, &value, sizeof value);
}

Value read_column(const Property& property, const std::byte* at) {
    switch (property.binding.native) {
        case Native::f32:
            return static_cast<double>(load<float>(at));
        case Native::f64:
            return load<double>(at);
        case Native::i32:
            return static_cast<std::int64_t>(load<std::int32_t>(at));
        case Native::i64:
            return load<std::int64_t>(at);
        case Native::boolean:
            return load<bool>(at);
        case Native::vec2f:
            return Vec2(load<float>(at), load<float>(at + sizeof(float)));
        case Native::vec2d:
            return Vec2(load<double>(at), load<double>(at + sizeof(double)));
        case Native::color:
            return load<Color>(at);
        case Native::enumeration: {
            const auto index = load<std::uint8_t>(at);
            return index < property.enumerator_values.size() ? property.enumerator_values[index]
                                                             : Value();
        }
    }
    return {};
}

void write_column(const Property& property, std::byte* at, const Value& value) {
    switch (property.binding.native) {
        case Native::f32:
            return store(at, static_cast<float>(value.number()));
        case Native::f64:
            return store(at, value.number());
        case Native::i32:
            return store(at, static_cast<std::int32_t>(value.integer()));
        case Native::i64:
            return store(at, value.integer());
        case Native::boolean:
            return store(at, value.boolean());
        case Native::vec2f:
            store(at, static_cast<float>(value.vec2().x()));
            return store(at + sizeof(float), static_cast<float>(value.vec2().y()));
        case Native::vec2d:
            store(at, value.vec2().x());
            return store(at + sizeof(double), value.vec2().y());
        case Native::color:
            return store(at, value.color());
        case Native::enumeration:
            return store(at, static_cast<std::uint8_t>(property.enumerator_index(value.text())));
    }
}

std::byte* cell_of(const Binding& binding, Row row) {
    return binding.base(binding.context) + static_cast<std::size_t>(row) * binding.stride;
}

struct CellName {
    const Tree& tree;
    Handle instance;
    const Property& property;
};

std::string path_of_cell(const void* what) {
    const auto& cell = *static_cast<const CellName*>(what);
    return cell.tree.path(cell.instance, cell.property);
}

}  // namespace

std::string Tree::path(Handle instance, const Property& property) const {
    const std::string suffix = path_suffix(property.name);
    if (instance == state_->root) return suffix.front() == '.' ? suffix.substr(1) : "game" + suffix;
    return path(instance) + suffix;
}

std::string Tree::State::cell_path(Handle handle, const Property& property) const {
    return tree.path(handle, property);
}

// --- Finding
// ---------------------------------------------------------------------------------------------------------

const Property* Tree::find(Handle instance, Symbol name) const {
    const State& s = *state_;
    if (s.formulas.tracking() && name) state_->formulas.note_name(instance, name);
    const Node& node = s.require(instance);
    if (const Property* declared = s.classes[node.class_id].property(name)) return declared;
    if (!node.has_ad_hoc || !name) return nullptr;
    const auto& own = s.ad_hoc.at(instance.index);
    const auto found = own.find(name.text());
    return found == own.end() ? nullptr : found->second.first;
}

const Property* Tree::find(Handle instance, std::string_view name) const {
    // In a formula an absent name is a dependency as well, so it needs a symbol.
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
    if (state_->require(instance).has_ad_hoc)
        for (const auto& [name, own] : state_->ad_hoc.at(instance.index)) all.push_back(own.first);
    return all;
}

std::vector<const Property*> Tree::properties(Handle instance) const {
    std::vector<const Property*> all = class_of(instance).properties();
    for (const Property* own : ad_hoc(instance)) all.push_back(own);
    return all;
}

// --- Reading
// ---------------------------------------------------------------------------------------------------------

Value Tree::State::read(std::uint32_t index, const Node& node, const Property& property) const {
    const Binding& binding = property.binding;
    switch (binding.kind) {
        case BindingKind::column:
            return read_column(property, cell_of(binding, node.row));
        case BindingKind::accessor:
            return binding.get(binding.context, node.row);
        case BindingKind::stored:
            return stored[node.class_id]->get(property, node.stored_row);
        case BindingKind::node:
            return binding.node_get(binding.context, tree, nodes.handle(index));
        case BindingKind::ad_hoc: {
            if (!node.has_ad_hoc) return {};
            const auto& own = ad_hoc.at(index);
            const auto found = own.find(property.name);
            return found == own.end() ? Value() : found->second.second;
        }
    }
    return {};
}

Value Tree::get(Handle instance, const Property& property) const {
    State& s = *state_;
    if (s.formulas.tracking()) s.formulas.note_read(instance, property);
    const Node& node = s.require(instance, property);
    if (node.has_formula) s.formulas.settle({instance.index, property.symbol});
    // The commonest binding, without another call.
    const Binding& binding = property.binding;
    if (binding.kind == BindingKind::accessor) return binding.get(binding.context, node.row);
    return s.read(instance.index, node, property);
}

Value Tree::peek(Handle instance, const Property& property) const {
    return state_->read(instance.index, state_->require(instance, property), property);
}

Value Tree::get(Handle instance, std::string_view name) const {
    return get(instance, property(instance, name));
}

// --- Editing
// ---------------------------------------------------------------------------------------------------------

Value Tree::State::coerce(Handle instance, const Property& property, const Value& value) const {
    const CellName cell{tree, instance, property};
    return coerce_value(property, value, {.tree = &tree, .path = &path_of_cell, .what = &cell});
}

Value Tree::coerce(Handle instance, const Property& property, const Value& value) const {
    state_->require(instance, property);
    return state_->coerce(instance, property, value);
}

void Tree::State::write(std::uint32_t index, const Node& node, const Property& property,
                        const Value& value) {
    const Binding& binding = property.binding;
    switch (binding.kind) {
        case BindingKind::column:
            // A setter of its own goes before the plain store: it can refuse, and it does the store
            // itself.
            if (binding.set != nullptr)
                binding.set(binding.context, node.row, value);
            else
                write_column(property, cell_of(binding, node.row), value);
            break;
        case BindingKind::accessor:
            binding.set(binding.context, node.row, value);
            break;
        case BindingKind::stored:
            stored[node.class_id]->set(property, node.stored_row, value);
            break;
        case BindingKind::node:
            binding.node_set(binding.context, tree, nodes.handle(index), value);
            break;
        case BindingKind::ad_hoc:
            ad_hoc.at(index).at(property.name).second = value;
            break;
    }
    if (binding.invalidate != nullptr) binding.invalidate(binding.context, nodes[index].row);
}

void Tree::State::written(Handle handle, const Node& node, const Property& property,
                          const Value& old_value) {
    note_edit();
    tell_plain_writes();
    writes.note(handle, property, writer, step);
    if (history.recording()) writes.note_in_full(handle, property.symbol, tree.cause());
    if (node.has_dependents) formulas.changed({handle.index, property.symbol});
    if (!node.watched && property.interest == 0) return;
    const Value now = read(handle.index, node, property);
    if (now == old_value) return;
    queue_change(handle, property, old_value, now, tree.cause());
}

void Tree::set(Handle instance, const Property& property, const Value& value) {
    State& s = *state_;
    const Node& node = s.require(instance, property);
    s.require_changeable("write");
    if (value.is(property.type)) {
        bool done = false;
        if (value.is(Type::number)) done = write(instance, property, value.number());
        if (value.is(Type::vec2)) done = write(instance, property, value.vec2());
        if (done && !s.observers.empty()) s.tell_plain_writes();  // at once, unlike `write`
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
    const State::Pin pin(s, "a binding of a property");
    const Value next = s.coerce(instance, property, value);
    std::optional<History::CellState> before;
    if (s.history.recording() && property.binding.kind != BindingKind::node)
        before = s.history.capture(instance, property);
    const Value old = s.read(instance.index, node, property);
    const bool had_formula =
        node.has_formula && s.formulas.find({instance.index, property.symbol}) != nullptr;
    const bool stands = property.binding.overridden == nullptr ||
                        property.binding.overridden(property.binding.context, node.row);
    if (old == next && stands && !had_formula) return;
    try {
        s.write(instance.index, node, property, next);
    } catch (...) {
        s.refused(instance, property);
    }
    s.add_weight(weight_beside(next) - weight_beside(old));
    // A value that was taken replaces the formula; one that was refused leaves it.
    if (had_formula) s.drop_formula(instance, property);
    // The setter may have moved nodes (a rename, another parent), so the node is looked up again.
    if (const Node* after = s.nodes.find(instance)) {
        s.written(instance, *after, property, old);
        s.tell([&](Observer& o) { o.wrote(instance, property, next); });
    }
    if (before) s.history.edited(instance, property, std::move(*before));
}

void Tree::set(Handle instance, std::string_view name, const Value& value) {
    set(instance, property(instance, name), value);
}

void Tree::reset(Handle instance, const Property& property) {
    State& s = *state_;
    const Node& node = s.require(instance, property);
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
    const State::Pin pin(s, "a binding of a property");
    std::optional<History::CellState> before;
    if (s.history.recording()) before = s.history.capture(instance, property);
    const Value old = s.read(instance.index, node, property);
    try {
        property.binding.reset(property.binding.context, node.row);
    } catch (...) {
        s.refused(instance, property);
    }
    if (node.has_formula) s.drop_formula(instance, property);
    if (property.binding.invalidate != nullptr)
        property.binding.invalidate(property.binding.context, node.row);
    s.written(instance, node, property, old);
    s.tell([&](Observer& o) { o.was_reset(instance, property); });
    if (before) s.history.edited(instance, property, std::move(*before));
}

bool Tree::overridden(Handle instance, const Property& property) const {
    const Node& node = state_->require(instance, property);
    if (property.binding.kind == BindingKind::ad_hoc) return true;
    if (property.read_only) return false;
    if (property.binding.overridden != nullptr)
        return property.binding.overridden(property.binding.context, node.row);
    if (property.binding.kind == BindingKind::node) return false;
    return !(state_->read(instance.index, node, property) == property.default_value);
}

// --- Ad-hoc properties
// -----------------------------------------------------------------------------------------------

const Property& Tree::State::ad_hoc_property(Symbol name) {
    std::unique_ptr<Property>& slot = ad_hoc_properties[name];
    if (slot == nullptr) {
        if (ad_hoc_properties.size() > most_own_names) {
            ad_hoc_properties.erase(name);
            throw Error(ErrorKind::bad_name,
                        "\"" + name.text().substr(0, 80) + "\": properties of " +
                            std::to_string(most_own_names) +
                            " different names were added already; keep what is counted in a list, "
                            "or in children");
        }
        add_weight(weight_of_own_descriptor);
        slot = std::make_unique<Property>();
        slot->name = name.text();
        slot->symbol = name;
        slot->type = Type::nil;
        slot->any_type = slot->infinity = true;
        slot->doc = "Added to this instance by a user.";
        slot->binding.kind = BindingKind::ad_hoc;
        slot->note_interest(watchers.interest(*slot));
    }
    return *slot;
}

void Tree::State::put_ad_hoc(Handle instance, const Property& added, const Value& value) {
    Node& node = require(instance);
    add_weight(weight_of_own_property + weight_beside(value));
    ad_hoc[instance.index].emplace(added.name, std::pair(&added, value));
    node.has_ad_hoc = true;
    written(instance, node, added, Value());
}

const Property& Tree::State::add_ad_hoc(Handle instance, std::string_view name,
                                        const Value& value) {
    require_changeable("write");
    const Class& of = tree.class_of(instance);
    const auto refuse = [&](ErrorKind kind, const std::string& reason) {
        throw Error(kind, tree.path(instance) + ": " + reason);
    };
    const std::string quoted = "\"" + std::string(name) + "\"";
    if (name.empty()) refuse(ErrorKind::bad_name, "the name of a property cannot be empty");
    check_length(name);
    if (name.find('\0') != std::string_view::npos)
        refuse(ErrorKind::bad_name, "the name " + quoted + " holds a zero byte");
    if (of.method(name) != nullptr)
        refuse(ErrorKind::bad_name, quoted + " is a method of " + of.name());
    if (tree.child(instance, name)) refuse(ErrorKind::bad_name, quoted + " is a child here");
    const std::vector<std::string> members = of.member_names();
    const auto near = std::ranges::find_if(
        members, [name](const std::string& declared) { return near_miss(name, declared); });
    if (near != members.end())
        refuse(ErrorKind::near_miss,
               of.name() + " has no property " + quoted + " (did you mean \"" + *near + "\"?)");
    // Input and the like are of the present only: nothing that is added there could be restored.
    if (of.snapshots() == Snapshots::never)
        refuse(ErrorKind::unknown_name, of.name() + " has no property " + quoted +
                                            ", and none can be added to it" +
                                            suggestion(name, members));
    const Property& added = ad_hoc_property(Symbol(name));
    const Value next = coerce(instance, added, value);
    put_ad_hoc(instance, added, next);
    tell([&](Observer& o) { o.wrote(instance, added, next); });
    if (history.recording()) history.edited(instance, added, {});
    return added;
}

void Tree::set_or_add(Handle instance, std::string_view name, const Value& value) {
    if (const Property* found = find(instance, name)) return set(instance, *found, value);
    if (value.is_nil() && !name.empty() && class_of(instance).method(name) == nullptr &&
        !child(instance, name))
        return;
    state_->add_ad_hoc(instance, name, value);
}

void Tree::remove_ad_hoc(Handle instance, std::string_view name) {
    State& s = *state_;
    Node& node = s.require(instance);
    if (!node.has_ad_hoc) return;
    auto& own = s.ad_hoc.at(instance.index);
    const auto found = own.find(std::string(name));
    if (found == own.end()) return;
    s.require_changeable("write");
    const Property* const property = found->second.first;
    const Value old = found->second.second;
    std::optional<History::CellState> before;
    if (s.history.recording()) before = s.history.capture(instance, *property);
    if (node.has_formula) s.drop_formula(instance, *property);
    own.erase(found);
    s.add_weight(-weight_of_own_property - weight_beside(old));
    if (own.empty()) {
        s.ad_hoc.erase(instance.index);
        node.has_ad_hoc = false;
    }
    s.written(instance, node, *property, old);
    s.tell([&](Observer& o) { o.removed(instance, *property); });
    if (before) s.history.edited(instance, *property, std::move(*before));
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
