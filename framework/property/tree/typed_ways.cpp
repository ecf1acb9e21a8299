// The typed ways: numbers and vec2s read and written without a Value in between, where nobody has
// to be told and nothing else stands between a cell and who asks for it. This is what scripts do
// most, so it is kept as short as it can be; whatever is out of the ordinary goes the long way
// (tree_edit.cpp), which does the same and more.

#include <memory>
#include <span>
#include <stdexcept>

#include <fettle/property/exception_text.h>
#include <fettle/property/tree.h>

#include <classes/coerce.h>

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

template <class T>
const Range& at_once(const Property& property) {
    if constexpr (std::is_same_v<T, double>)
        return property.numbers_at_once;
    else
        return property.vec2s_at_once;
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

void put_down(PlainWrite& entry, Handle instance, const Property& property, double x) {
    entry.instance = instance;
    entry.property = &property;
    entry.x = x;
}
void put_down(PlainWrite& entry, Handle instance, const Property& property, const Vec2& v) {
    put_down(entry, instance, property, v.x());
    entry.y = v.y();
}

}  // namespace

Value PlainWrite::value() const {
    const bool narrow = property->shortcut.narrow;
    if (property->type == Type::number) return Value(narrow ? narrowed(x) : x);
    return Value(narrow ? narrowed(Vec2(x, y)) : Vec2(x, y));
}

/// The setter threw: the write did not happen. Called while the exception is caught.
[[noreturn, gnu::cold, gnu::noinline]] void Tree::State::refused(Handle instance,
                                                                 const Property& property) const {
    try {
        throw;
    } catch (const std::invalid_argument& refusal) {
        throw Error(ErrorKind::rejected, tree.path(instance, property) + ": " + refusal.what());
    } catch (const std::exception&) {
        throw;
    } catch (...) {
        throw Error(ErrorKind::rejected, tree.path(instance, property) + ": " + exception_text());
    }
}

/// Of properties kept by the tree, of setters that may do anything, and of those that want to hear
/// of writes. The setter may itself write, read formulas, and move nodes.
template <class T>
bool Tree::State::write_by_way(Handle instance, const Property& property, T value) {
    const Node* const node = nodes.find_if<&Node::writable>(instance);
    if (node == nullptr || !property.shortcut.takes.contains(value)) return false;
    if (property.interest != 0 || only_the_long_way()) return false;
    const bool by_setter = property.shortcut.write == by_call<T>;
    if (!by_setter && property.shortcut.write != in_tree<T>) return false;
    if (property.shortcut.narrow) value = narrowed(value);
    if (!by_setter && !put_stored<T>(*this, *node, property, value)) return true;
    if (writes.full()) [[unlikely]]
        tell_untold();
    // Made first: then next to nothing has to be kept over the call.
    PlainWrite& entry = writes.begin();
    put_down(entry, instance, property, value);
    const Binding& binding = property.binding;
    if (by_setter) {
        // The log counts the write already. A formula that the setter reads must not take the epoch
        // it saw for the one after the write, nor for the one after taking it back.
        struct Done {
            std::uint64_t& upheavals;
            ~Done() { upheavals += 2; }
        } done{upheavals};
        Put put{};
        try {
            put = typed_way<T>(binding).put(binding, node->row, value);
        } catch (...) {
            writes.take_back(entry);
            refused(instance, property);
        }
        if (put != Put::done) {
            writes.take_back(entry);
            return put == Put::same;
        }
    }
    edited = true;
    if (binding.invalidate != nullptr)
        binding.invalidate(binding.context, nodes[instance.index].row);
    if (!shadows.empty() || binding.invalidate != nullptr) note_edit();
    return true;
}

/// Only where nobody has to be told at once, and no other value stands for the cell's. Ends with
/// the call of the setter, so that nothing has to be kept over it.
template <class T>
[[gnu::always_inline]] inline Put Tree::State::write_at_once(Handle instance,
                                                             const Property& property, T value) {
    const Node* const node = nodes.find_if<&Node::writable>(instance);
    if (node == nullptr || !at_once<T>(property).contains(value) || !writes.open()) [[unlikely]]
        return Put::untried;
    put_down(writes.begin(), instance, property, value);
    return typed_way<T>(property.binding).put(property.binding, node->row, value);
}

template <class T>
bool Tree::State::end_write(Put begun, Handle instance, const Property& property, const T& value) {
    if (begun == Put::done) return true;
    if (begun == Put::untried) return write_by_way<T>(instance, property, value);
    writes.take_back_last();
    return begun == Put::same;
}

void Observer::wrote_plain(const PlainWrites& writes) {
    for (const PlainWrite& write : writes.list)
        if (write.instance) wrote(write.instance, *write.property, write.value());
}

void Tree::State::tell_untold() {
    const PlainWrites told = writes.untold();
    // Emptied first: who is told may ask for things that tell again. Nobody who is told writes.
    writes.tell(writer, step);
    if (!replaying && !observers.empty())
        tell_each([&](Observer& observer) { observer.wrote_plain(told); });
}

bool Tree::read(Handle instance, const Property& property, double& number) const {
    return read_typed(*state_, instance, property, number);
}
bool Tree::read(Handle instance, const Property& property, Vec2& vector) const {
    return read_typed(*state_, instance, property, vector);
}
const Row* Tree::readable(Handle instance) const {
    const Node* const node = state_->nodes.find_if<&Node::readable>(instance);
    return node != nullptr && !state_->formulas.tracking() ? &node->row : nullptr;
}

Put Tree::begin_write(Handle instance, const Property& property, double number) {
    return state_->write_at_once(instance, property, number);
}
Put Tree::begin_write(Handle instance, const Property& property, const Vec2& vector) {
    return state_->write_at_once(instance, property, vector);
}

bool Tree::end_write(Put begun, Handle instance, const Property& property, double number) {
    return state_->end_write(begun, instance, property, number);
}
bool Tree::end_write(Put begun, Handle instance, const Property& property, const Vec2& vector) {
    return state_->end_write(begun, instance, property, vector);
}

}  // namespace fettle::property
