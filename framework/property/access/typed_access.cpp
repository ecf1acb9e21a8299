// Typed reads and writes: numbers and vec2s are accessed without a Value if nothing else has to
// happen (no report, no formula). Scripts use these functions most, so they are as short as
// possible. In all other cases the general functions in tree_edit.cpp are used.

#include <classes/coerce.h>

#include <tree/state.h>

namespace fettle::property {
namespace {

using Access = Property::Shortcut::Access;

/// The two shortcuts of a type: a call of the binding, and a column of the tree.
template <class T>
constexpr Access by_call = std::is_same_v<T, double> ? Access::number : Access::vec2;
template <class T>
constexpr Access in_tree = std::is_same_v<T, double> ? Access::stored_number : Access::stored_vec2;

template <class T>
const Typed<T>& typed_functions(const Binding& binding) {
    if constexpr (std::is_same_v<T, double>)
        return binding.number;
    else
        return binding.vec2;
}

template <class T>
const Range& at_once(const Property& property) {
    if constexpr (std::is_same_v<T, double>)
        return property.shortcut.numbers_at_once;
    else
        return property.shortcut.vec2s_at_once;
}

template <class T>
[[gnu::noinline]] bool read_stored(const Tree::State& s, const Node& node, const Property& property,
                                   T& out) {
    if (property.shortcut.read != in_tree<T>) return false;
    out = s.instances.stored[node.class_id]->cell<T>(property, node.stored_row);
    return true;
}

template <class T>
bool read_typed(const Tree::State& s, Handle instance, const Property& property, T& out) {
    const Node* const node = s.instances.nodes.find_if<&Node::readable>(instance);
    if (node == nullptr || s.instances.reads.noted()) [[unlikely]]
        return false;
    if (property.shortcut.read != by_call<T>) return read_stored(s, *node, property, out);
    out = typed_functions<T>(property.binding).get(property.binding, node->row);
    return true;
}

template <class T>
bool put_stored(Tree::State& s, const Node& node, const Property& property, const T& value) {
    T& cell = s.instances.stored[node.class_id]->cell<T>(property, node.stored_row);
    if (same_bits(cell, value)) return false;
    cell = value;
    return true;
}

void fill(PlainWrite& entry, Handle instance, const Property& property, double x) {
    entry.instance = instance;
    entry.property = &property;
    entry.x = x;
}
void fill(PlainWrite& entry, Handle instance, const Property& property, const Vec2& v) {
    fill(entry, instance, property, v.x);
    entry.y = v.y;
}

/// For properties stored in the tree, for setters that may do anything, and for bindings with an
/// invalidate hook. The setter may itself write, read formulas, and move nodes.
template <class T>
bool write_logged(Tree::State& s, Handle instance, const Property& property, T value) {
    Changes& changes = s.changes;
    WritesLog& log = changes.writes;
    const Node* const node = s.instances.nodes.find_if<&Node::writable>(instance);
    if (node == nullptr || !property.shortcut.writable_range.contains(value)) return false;
    if (property.shortcut.interest != 0 || log.needs_general_write()) return false;
    const bool by_setter = property.shortcut.write == by_call<T>;
    if (!by_setter && property.shortcut.write != in_tree<T>) return false;
    if (property.shortcut.narrow) value = narrowed(value);
    if (!by_setter && !put_stored<T>(s, *node, property, value)) return true;
    if (log.full()) [[unlikely]]
        changes.report_unreported();
    // The entry is made before the call, so that few values must be kept across it.
    PlainWrite& entry = log.begin();
    fill(entry, instance, property, value);
    const Binding& binding = property.binding;
    if (by_setter) {
        // The log already counts the write. A formula that the setter reads must not store an epoch
        // that is equal to the one after the write, or to the one after taking it back.
        struct Done {
            std::uint64_t& invalidations;
            ~Done() { invalidations += 2; }
        } done{changes.invalidations};
        WriteResult put{};
        try {
            put = typed_functions<T>(binding).put(binding, node->row, value);
        } catch (...) {
            log.take_back(entry);
            s.instances.refused(instance, property);
        }
        if (put != WriteResult::done) {
            log.take_back(entry);
            return put == WriteResult::same;
        }
    }
    changes.edited = true;
    if (binding.invalidate != nullptr)
        binding.invalidate(binding.context, s.instances.nodes[instance.index].row);
    if (!changes.shadows.empty() || binding.invalidate != nullptr) changes.note_edit();
    return true;
}

/// The fastest path: no report and no formula can be involved. The call of the setter is last, so
/// that no value must be kept across it.
template <class T>
[[gnu::always_inline]] inline WriteResult write_at_once(Tree::State& s, Handle instance,
                                                        const Property& property, T value) {
    const Node* const node = s.instances.nodes.find_if<&Node::writable>(instance);
    if (node == nullptr || !at_once<T>(property).contains(value) || !s.changes.writes.open())
        [[unlikely]]
        return WriteResult::untried;
    fill(s.changes.writes.begin(), instance, property, value);
    return typed_functions<T>(property.binding).put(property.binding, node->row, value);
}

template <class T>
bool finish_write(Tree::State& s, WriteResult begun, Handle instance, const Property& property,
                  const T& value) {
    if (begun == WriteResult::done) return true;
    if (begun == WriteResult::untried) return write_logged<T>(s, instance, property, value);
    s.changes.writes.take_back_last();
    return begun == WriteResult::same;
}

}  // namespace

bool Tree::read(Handle instance, const Property& property, double& number) const {
    return read_typed(*state_, instance, property, number);
}
bool Tree::read(Handle instance, const Property& property, Vec2& vector) const {
    return read_typed(*state_, instance, property, vector);
}
const Row* Tree::readable(Handle instance) const {
    const Node* const node = state_->instances.nodes.find_if<&Node::readable>(instance);
    return node != nullptr && !state_->instances.reads.noted() ? &node->row : nullptr;
}

WriteResult Tree::begin_write(Handle instance, const Property& property, double number) {
    return write_at_once(*state_, instance, property, number);
}
WriteResult Tree::begin_write(Handle instance, const Property& property, const Vec2& vector) {
    return write_at_once(*state_, instance, property, vector);
}

bool Tree::end_write(WriteResult begun, Handle instance, const Property& property, double number) {
    return finish_write(*state_, begun, instance, property, number);
}
bool Tree::end_write(WriteResult begun, Handle instance, const Property& property,
                     const Vec2& vector) {
    return finish_write(*state_, begun, instance, property, vector);
}

}  // namespace fettle::property
