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
    double x = v.x(), y = v.y();
    if (!fit(shortcut, x) || !fit(shortcut, y)) return false;
    v = Vec2(x, y);  // at once: whoever reads both would wait for one half after the other
    return true;
}

template <class T>
[[gnu::noinline]] bool read_stored(const Tree::State& s, const Node& node, const Property& property,
                                   T& out) {
    if (property.shortcut.read != in_tree<T>) return false;
    out = s.stored[node.class_id]->cell<T>(property, node.stored_row);
    return true;
}

template <class T>
bool read_typed(const Tree::State& s, Handle instance, const Property& property, T& out) {
    const Node* const node = s.nodes.find_if<&Node::readable>(instance);
    if (node == nullptr || s.formulas.tracking()) [[unlikely]]
        return false;
    if (property.shortcut.read != by_call<T>) return read_stored(s, *node, property, out);
    out = typed_way<T>(property.binding).get(property.binding, node->row);
    return true;
}

template <class T>
bool put_stored(Tree::State& s, const Node& node, const Property& property, const T& value) {
    T& cell = s.stored[node.class_id]->cell<T>(property, node.stored_row);
    if (same_bits(cell, value)) return false;
    cell = value;
    return true;
}

}  // namespace

template <class T>
static void put_down(PlainWrite& entry, Handle instance, const Property& property, const T& value) {
    entry.instance = instance;
    entry.property = property.symbol;
    entry.is_vec2 = !std::is_same_v<T, double>;
    if constexpr (std::is_same_v<T, double>) {
        entry.x = value;
    } else {
        entry.x = value.x();
        entry.y = value.y();
    }
}

/// What is left to do in the less usual circumstances.
[[gnu::noinline]] void Tree::State::note_typed(Handle instance, const Property& property) {
    const Binding& binding = property.binding;
    if (binding.invalidate != nullptr)
        // The setter may have moved nodes.
        binding.invalidate(binding.context, nodes[instance.index].row);
    note_edit();
}

/// The setter threw: the write did not happen. Called while the exception is caught.
[[noreturn, gnu::cold, gnu::noinline]] void Tree::State::take_back_thrown(PlainWrite& entry) {
    const PlainWrite was = entry;
    writes.take_back(entry);
    try {
        throw;
    } catch (const std::invalid_argument& refusal) {
        throw Error(ErrorKind::rejected,
                    tree.path(was.instance, *tree.find(was.instance, was.property)) + ": " +
                        refusal.what());
    }
}

/// Hands the value of `entry` over to the module. The entry in the log is made first: then next to
/// nothing has to be kept over the call.
template <class T>
[[gnu::always_inline]] inline static Put hand_over(Tree::State& s, PlainWrite& entry,
                                                   const Property& property, Row row,
                                                   typename Typed<T>::Passed value) {
    try {
        return typed_way<T>(property.binding).put(property.binding, row, value);
    } catch (...) {
        s.take_back_thrown(entry);
    }
}

/// The value was there already (true), or takes the long way.
[[gnu::noinline]] bool Tree::State::take_back(PlainWrite& entry, Put why) {
    writes.take_back(entry);
    return why == Put::same;
}

/// Of properties kept by the tree, and of those that want to hear of writes.
template <class T>
[[gnu::noinline]] bool Tree::State::write_by_way(Handle instance, const Property& property, T value,
                                                 const Node& node) {
    const bool by_setter = property.shortcut.write == by_call<T>;
    if (!by_setter && property.shortcut.write != in_tree<T>) return false;
    if (!by_setter && !put_stored<T>(*this, node, property, value)) return true;
    if (writes.full()) [[unlikely]]
        tell_untold();
    PlainWrite& entry = writes.begin();
    put_down(entry, instance, property, value);
    if (by_setter) {
        const Put put = hand_over<T>(*this, entry, property, node.row, value);
        if (put != Put::done) return take_back(entry, put);
    }
    edited = true;
    ++epoch;
    if (!shadows.empty() || property.binding.invalidate != nullptr) note_typed(instance, property);
    return true;
}

/// The write itself, and what it leaves to do.
template <class T>
[[gnu::noinline]] static bool put_at_once(Tree::State& s, PlainWrite& entry,
                                          const Property& property, Row row,
                                          typename Typed<T>::Passed value) {
    const Put put = hand_over<T>(s, entry, property, row, value);
    if (put != Put::done) [[unlikely]]
        return s.take_back(entry, put);
    ++s.epoch;
    if (!s.shadows.empty()) [[unlikely]]
        s.note_edit();
    return true;
}

/// Only where nobody has to be told at once, and no other value stands for the cell's.
template <class T>
[[gnu::always_inline]] inline bool Tree::State::write_typed(Handle instance,
                                                            const Property& property, T value) {
    const Node* const node = nodes.find_if<&Node::writable>(instance);
    if (node == nullptr || property.interest != 0 || records || formulas.tracking() ||
        !fit(property.shortcut, value)) [[unlikely]]
        return false;
    if (property.shortcut.at_once != by_call<T> || writes.full()) [[unlikely]]
        return write_by_way<T>(instance, property, value, *node);
    PlainWrite& entry = writes.begin();
    put_down(entry, instance, property, value);
    return put_at_once<T>(*this, entry, property, node->row, value);
}

void Observer::wrote_plain(const Tree& tree, std::span<const PlainWrite> writes) {
    for (const PlainWrite& write : writes)
        if (write.instance)
            wrote(write.instance, *tree.find(write.instance, write.property), write.value());
}

void Tree::State::tell_untold() {
    const std::span<const PlainWrite> told = writes.untold();
    // Emptied first: who is told may ask for things that tell again. Nobody who is told writes.
    writes.tell(writer, step);
    if (replaying) return;
    for (Observer* observer : observers) observer->wrote_plain(tree, told);
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
