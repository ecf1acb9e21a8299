// The typed ways: numbers and vec2s read and written without a Value in between, where nobody has
// to be told and nothing else stands between a cell and who asks for it. This is what scripts do
// most, so it is kept as short as it can be; whatever is out of the ordinary goes the long way
// (tree_edit.cpp), which does the same and more.

#include <stdexcept>

#include <fettle/property/tree.h>

#include "state.h"

namespace fettle::property {
namespace {

constexpr std::size_t most_untold = 4096;

const Typed<double>& typed_way(const Binding& binding, double) {
    return binding.number;
}
const Typed<Vec2>& typed_way(const Binding& binding, const Vec2&) {
    return binding.vec2;
}

constexpr Type type_of(double) {
    return Type::number;
}
Type type_of(const Vec2&) {
    return Type::vec2;
}

// As the property's memory holds it; false where it needs a second look. A NaN is never in range.
bool fit(const Property::Shortcut& shortcut, double& x) {
    if (shortcut.narrow) x = static_cast<double>(static_cast<float>(x));
    return x >= shortcut.min && x <= shortcut.max;
}
bool fit(const Property::Shortcut& shortcut, Vec2& v) {
    return fit(shortcut, v.x()) && fit(shortcut, v.y());
}

template <class T>
bool read_typed(const Tree::State& s, Handle instance, const Property& property, T& out) {
    const Node* const node = s.nodes.find(instance);
    if (node == nullptr || node->has_formula || !property.shortcut.readable ||
        property.type != type_of(out) || s.formulas.tracking())
        return false;
    if (property.binding.kind == BindingKind::stored)
        out = s.stored[node->class_id]->cell<T>(property, node->stored_row);
    else
        typed_way(property.binding, out).get(property.binding, node->row, out);
    return true;
}

}  // namespace

/// Whether nobody has to be told at once, and no other value stands for the cell's.
bool Tree::State::may_write(const Node& node, const Property& property) const {
    return property.shortcut.writable && property.interest == 0 &&
           !(node.watched || node.has_formula || node.has_dependents) && !formulas.tracking() &&
           !history.recording(writer);
}

void Tree::State::note_typed(Handle instance, const Property& property, double x, double y) {
    note_edit();
    writes.note(instance, property.symbol, writer, step);
    if (observers.empty() || replaying) return;
    untold.push_back({instance, &property, x, y});
    if (untold.size() >= most_untold) tell_untold();
}

template <class T>
bool Tree::State::write_typed(Handle instance, const Property& property, T value) {
    const Node* const node = nodes.find(instance);
    if (node == nullptr || property.type != type_of(value) || !may_write(*node, property) ||
        !fit(property.shortcut, value))
        return false;
    const Binding& binding = property.binding;
    if (binding.kind == BindingKind::stored) {
        T& cell = stored[node->class_id]->cell<T>(property, node->stored_row);
        if (same_bits(cell, value)) return true;
        cell = value;
    } else {
        try {
            if (!typed_way(binding, value).put(binding, node->row, value)) return true;
        } catch (const std::invalid_argument& refusal) {
            throw Error(ErrorKind::rejected, tree.path(instance, property) + ": " + refusal.what());
        }
    }
    // The setter may have moved nodes.
    if (binding.invalidate != nullptr)
        binding.invalidate(binding.context, nodes[instance.index].row);
    if constexpr (std::is_same_v<T, double>)
        note_typed(instance, property, value, 0);
    else
        note_typed(instance, property, value.x(), value.y());
    return true;
}

void Tree::State::tell_untold() {
    // Emptied first: who is told may ask for things that tell again.
    std::vector<PlainWrite> told;
    told.swap(untold);
    for (Observer* observer : observers) observer->wrote_plain(told);
    told.clear();
    if (untold.empty()) untold.swap(told);  // the room is used again
}

bool Tree::read(Handle instance, const Property& property, double& number) const {
    return read_typed(*state_, instance, property, number);
}
bool Tree::read(Handle instance, const Property& property, Vec2& vector) const {
    return read_typed(*state_, instance, property, vector);
}
bool Tree::write(Handle instance, const Property& property, double number) {
    return state_->write_typed(instance, property, number);
}
bool Tree::write(Handle instance, const Property& property, const Vec2& vector) {
    return state_->write_typed(instance, property, vector);
}

}  // namespace fettle::property
