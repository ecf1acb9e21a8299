// Writing one element of a list without a copy of the others. A write of the whole list
// (tree_edit.cpp) takes time for each element, so a list that grows one by one would need the
// square of its length.

#include <optional>
#include <string>

#include <fettle/property/added_rules.h>

#include <values/weight.h>

#include <tree/state.h>

namespace fettle::property {

namespace {

/// The list, if it is in the memory of the tree and a write of it does nothing else.
Value* plain_list(Tree::State& s, Handle instance, const Property& property) {
    const Node& node = s.instances.require(instance, property);
    s.require_changeable("write");
    if (property.read_only || property.binding.invalidate != nullptr) return nullptr;
    const bool ruled =
        property.binding.kind == BindingKind::ad_hoc && s.rules_of(instance) != nullptr;
    const bool computed =
        node.has_formula && s.formulas.find({instance.index, property.symbol}) != nullptr;
    if (ruled || computed) return nullptr;
    Value* const kept = s.instances.kept_value(instance.index, node, property);
    return kept != nullptr && kept->is(Type::list) ? kept : nullptr;
}

/// Calls `write(list)`, and does what comes before and after any write. `grown`: by how much the
/// estimated memory grows.
template <class Write, class Report>
void change_list(Tree::State& s, Handle instance, const Property& property, Value& list,
                 std::int64_t grown, Write write, Report report) {
    const Node& node = s.instances.require(instance);
    std::optional<CellState> before = s.history.before_edit(instance, property);
    // The value before is needed only if something watches the list: keeping it copies the list.
    const bool awaited = node.watched || property.shortcut.interest != 0;
    const Value old = awaited ? list : Value();
    write(list);
    if (property.binding.kind == BindingKind::ad_hoc)
        s.changes.weight.add(grown);
    else
        s.changes.weight.add_content(instance.index, grown);
    s.formulas.written(instance, node, property, old);
    s.changes.notify(report);
    if (before) s.history.edited(instance, property, std::move(*before));
}

std::int64_t weight_of(const Value& element) {
    return static_cast<std::int64_t>(size_of(element));
}

[[noreturn]] void no_element(const Tree& tree, Handle instance, const Property& property,
                             std::size_t index, std::size_t size) {
    throw Error(ErrorKind::out_of_range, tree.path(instance, property) + "[" +
                                             std::to_string(index) + "]: the list has " +
                                             std::to_string(size) + " elements");
}

}  // namespace

void Tree::set_element(Handle instance, const Property& property, std::size_t index,
                       const Value& element) {
    State& s = *state_;
    Value* const list = plain_list(s, instance, property);
    const Value whole = list == nullptr ? get(instance, property) : Value();
    const std::size_t size = (list == nullptr ? whole : *list).list().size();
    if (index == 0 || index > size + 1) no_element(*this, instance, property, index, size);
    if (list == nullptr) {
        Value changed = whole;
        changed.set_element(index - 1, element);
        return set(instance, property, changed);
    }
    const Value next = s.instances.coerce_element(instance, property, index, element);
    std::int64_t grown = weight_of(next);
    if (index <= size) {
        const Value& before = list->list()[index - 1];
        if (before == next) return;
        grown -= weight_of(before);
    } else {
        grown += static_cast<std::int64_t>(property.element_weight);
    }
    change_list(
        s, instance, property, *list, grown,
        [&](Value& changed) { changed.set_element(index - 1, next); },
        [&](Observer& o) { o.wrote_element(instance, property, index, &next, *list); });
}

void Tree::remove_last_element(Handle instance, const Property& property) {
    State& s = *state_;
    Value* const list = plain_list(s, instance, property);
    const Value whole = list == nullptr ? get(instance, property) : Value();
    const std::size_t size = (list == nullptr ? whole : *list).list().size();
    if (size == 0) no_element(*this, instance, property, 1, 0);
    if (list == nullptr) {
        Value changed = whole;
        changed.remove_last_element();
        return set(instance, property, changed);
    }
    const std::int64_t grown =
        -weight_of(list->list().back()) - static_cast<std::int64_t>(property.element_weight);
    change_list(
        s, instance, property, *list, grown, [](Value& changed) { changed.remove_last_element(); },
        [&](Observer& o) { o.wrote_element(instance, property, size, nullptr, *list); });
}

}  // namespace fettle::property
