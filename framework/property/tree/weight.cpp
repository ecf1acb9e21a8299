// Estimated memory of a tree.

#include <atomic>
#include <utility>

#include <values/weight.h>

#include "state.h"

namespace fettle::property {

std::uint64_t Tree::State::next_number() {
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}

void Tree::State::note_content(Handle instance, const Node& node, const Property& property,
                               const Value& old) {
    const bool has_content = property.any_type || property.type == Type::list ||
                             (property.type == Type::text && property.enumerators.empty());
    if (!has_content) return;
    const Value now = instances.read(instance.index, node, property);
    const std::int64_t grown = weight_beside(now, property) - weight_beside(old, property);
    if (property.binding.kind == BindingKind::ad_hoc)
        changes.weight.add(grown);
    else
        changes.weight.add_content(instance.index, grown);
}

std::int64_t Tree::weight() const {
    return state_->changes.weight.bytes;
}

void Tree::add_weight(std::int64_t bytes) {
    state_->changes.weight.add(bytes);
}

void Tree::mark_weight(std::int64_t mark, std::function<void()> passed) {
    state_->changes.weight.mark = mark;
    state_->changes.weight.mark_passed = std::move(passed);
}

}  // namespace fettle::property
