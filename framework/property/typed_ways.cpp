// The typed ways: numbers and vec2s read and written without a Value in between, where nobody has
// to be told and nothing else stands between a cell and who asks for it. This is what scripts do
// most, so it is kept as short as it can be; whatever is out of the ordinary goes the long way
// (tree_edit.cpp), which does the same and more.

#include <memory>
#include <span>
#include <stdexcept>

#include <fettle/property/tree.h>

#include "state.h"

namespace fettle::property {
namespace {

using Way = Property::Shortcut::Way;

/// The two ways of a type: called, and kept by the tree.
template <class T>
constexpr Way by_call = std::is_same_v<T, double> ? Way::number : Way::vec2;
template <class T>
constexpr Way in_tree = std::is_same_v<T, double> ? Way::stored_number : Way::stored_vec2;

template <class T>
const Typed<T>& typed_way(const Binding& binding) {
    if constexpr (std::is_same_v<T, double>)
        return binding.number;
    else
        return binding.vec2;
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
    if (node == nullptr || node->has_formula || s.formulas.tracking()) return false;
    if (property.shortcut.read == by_call<T>)
        out = typed_way<T>(property.binding).get(property.binding, node->row);
    else if (property.shortcut.read == in_tree<T>)
        out = s.stored[node->class_id]->cell<T>(property, node->stored_row);
    else
        return false;
    return true;
}

template <class T>
bool put_stored(Tree::State& s, const Node& node, const Property& property, const T& value) {
    T& cell = s.stored[node.class_id]->cell<T>(property, node.stored_row);
    if (same_bits(cell, value)) return false;
    cell = value;
    return true;
}

[[noreturn, gnu::cold, gnu::noinline]] void refused(Tree::State& s, Handle instance,
                                                    const Property& property,
                                                    const std::invalid_argument& why) {
    throw Error(ErrorKind::rejected, s.tree.path(instance, property) + ": " + why.what());
}

}  // namespace

/// What is left to do in the less usual circumstances.
[[gnu::noinline]] void Tree::State::note_typed(Handle instance, const Property& property) {
    // The setter may have moved nodes.
    const Binding& binding = property.binding;
    if (binding.invalidate != nullptr)
        binding.invalidate(binding.context, nodes[instance.index].row);
    note_edit();
}

/// The write itself and what it leaves to do. Apart from the checks before it: those need neither
/// a frame nor the value anywhere but in a register.
template <class T>
[[gnu::noinline]] static bool put_typed(Tree::State& s, Handle instance, const Property& property,
                                        typename Typed<T>::Passed value, const Node& node) {
    if (property.shortcut.write == by_call<T>) [[likely]] {
        try {
            const Put put = typed_way<T>(property.binding).put(property.binding, node.row, value);
            if (put != Put::done) [[unlikely]]
                return put == Put::same;
        } catch (const std::invalid_argument& refusal) {
            refused(s, instance, property, refusal);
        }
    } else if (!put_stored<T>(s, node, property, value)) {
        return true;
    }
    s.edited = true;
    ++s.epoch;
    if (!s.shadows.empty() || property.binding.invalidate != nullptr) [[unlikely]]
        s.note_typed(instance, property);
    if (s.untold.next == s.untold.end) [[unlikely]]
        s.make_room_for_untold();
    // Made where it stays: a copy of one just made stalls on its half-written bytes.
    PlainWrite& told = *s.untold.next++;
    told.instance = instance;
    told.property = &property;
    if constexpr (std::is_same_v<T, double>) {
        told.x = value;
    } else {
        told.x = value.x();
        told.y = value.y();
    }
    return true;
}

/// Only where nobody has to be told at once, and no other value stands for the cell's.
template <class T>
inline bool Tree::State::write_typed(Handle instance, const Property& property, T value) {
    const Node* const node = nodes.find(instance);
    if (node == nullptr || node->watched || node->has_formula || node->has_dependents ||
        property.interest != 0 || records || formulas.tracking() ||
        (property.shortcut.write != by_call<T> && property.shortcut.write != in_tree<T>) ||
        !fit(property.shortcut, value)) [[unlikely]]
        return false;
    return put_typed<T>(*this, instance, property, value, *node);
}

void Tree::State::make_room_for_untold() {
    if (untold.first != nullptr) return tell_untold();
    untold.first = std::make_unique<PlainWrite[]>(PlainWrites::most);
    untold.next = untold.first.get();
    untold.end = untold.next + PlainWrites::most;
}

void Tree::State::tell_untold() {
    const std::span<const PlainWrite> told(untold.first.get(), untold.next);
    // Emptied first: who is told may ask for things that tell again. Nobody who is told writes.
    untold.next = untold.first.get();
    writes.note(told, writer, step);
    if (replaying) return;
    for (Observer* observer : observers) observer->wrote_plain(told);
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
