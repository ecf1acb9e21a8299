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

namespace {

bool has_content(const Property& property) {
    return property.any_type || property.type == Type::list ||
           (property.type == Type::text && property.enumerators.empty());
}

}  // namespace

void Tree::State::note_content(Handle instance, const Node& node, const Property& property,
                               const Value& old) {
    if (!has_content(property)) return;
    const Value now = instances.read(instance.index, node, property);
    const std::int64_t grown = weight_beside(now, property) - weight_beside(old, property);
    if (property.binding.kind == BindingKind::ad_hoc)
        changes.weight.add(grown);
    else
        changes.weight.add_content(instance.index, grown);
}

std::int64_t Tree::State::weight_of_instances() const {
    std::int64_t sum = 0;
    for (std::uint32_t i = 1; i < instances.nodes.end(); ++i)
        if (instances.nodes[i].alive()) sum += instances.weight_of(i);
    return sum;
}

TreeWeight::Content Tree::State::read_content() const {
    std::vector<std::vector<const Property*>> of_class(instances.classes.size());
    for (std::uint32_t id = 0; id < instances.classes.size(); ++id)
        for (const Property* property : instances.classes[id].properties())
            if (has_content(*property) && !property->read_only) of_class[id].push_back(property);
    TreeWeight::Content all;
    for (std::uint32_t i = 1; i < instances.nodes.end(); ++i) {
        const Node& node = instances.nodes[i];
        if (!node.alive()) continue;
        std::int64_t sum = 0;
        for (const Property* property : of_class[node.class_id]) try {
                sum += weight_beside(instances.read(i, node, *property), *property);
            } catch (...) {  // a module that cannot give a value has nothing in it
            }
        if (sum != 0) all.emplace_back(i, sum);
    }
    return all;
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
