#include "shadows.h"

#include <utility>

namespace fettle::property {
namespace {

/// The class, the name and the parent of an instance do not depend on cells.
bool is_derived(const Property& property) {
    return property.binding.kind != BindingKind::node &&
           (!property.simulated || !property.derives_from.empty());
}

}  // namespace

void Shadows::refresh(const Tree& tree, const Watchers& watchers, Handle instance) {
    for (const Property* property : ClassRegistry::observed(tree.class_of(instance))) {
        const Cell cell{instance.index, property->symbol};
        const bool wanted =
            watchers.directly_watched(cell) || watchers.broadly_watched(instance, *property);
        if (wanted == holds(cell)) continue;
        if (wanted)
            add(tree, instance, *property);
        else
            remove(cell);
    }
}

void Shadows::forget(const Tree& tree, Handle instance) {
    if (empty()) return;
    for (const Property* property : ClassRegistry::observed(tree.class_of(instance)))
        remove({instance.index, property->symbol});
}

void Shadows::update(Cell cell, const Value& value) {
    if (const auto found = places_.find(cell); found != places_.end()) {
        Row& row = groups_[found->second.group].rows[found->second.row];
        row.last = value;
        row.step = 0;
    }
}

std::uint64_t Shadows::simulated_at(Cell cell) const {
    const auto found = places_.find(cell);
    return found == places_.end() ? 0 : groups_[found->second.group].rows[found->second.row].step;
}

std::vector<CellChange> Shadows::compare(const Instances& instances, std::uint64_t step) {
    std::vector<CellChange> found;
    for (Group& group : groups_) {
        for (Row& row : group.rows) {
            const Property& property = *row.property;
            const Node& node = instances.nodes[row.instance.index];
            // Most cells are vectors that have not changed. They are compared without making a
            // Value.
            if (property.binding.vec2.get != nullptr && row.last.is(Type::vec2)) {
                const Vec2 now = property.binding.vec2.get(property.binding, node.row);
                if (same_bits(now, row.last.vec2())) continue;
            } else if (property.binding.number.get != nullptr && row.last.is(Type::number)) {
                const double now = property.binding.number.get(property.binding, node.row);
                if (same_bits(now, row.last.number())) continue;
            }
            Value now;
            try {
                now = instances.read(row.instance.index, node, property);
            } catch (...) {  // a module that cannot give the value must not hide other changes
                continue;
            }
            if (now == row.last) continue;
            row.last.swap(now);
            row.step = step;
            found.push_back({row.instance, &property, std::move(now), row.last});
        }
    }
    return found;
}

void Shadows::clear() {
    groups_.clear();
    places_.clear();
    derived_ = 0;
    log_.close(WritesLog::Reason::shadow, false);
}

void Shadows::add(const Tree& tree, Handle instance, const Property& property) {
    Value now = tree.peek(instance, property);  // first, because a module may throw
    std::uint32_t group = 0;
    while (group < groups_.size() && groups_[group].property != property.symbol) ++group;
    if (group == groups_.size()) groups_.push_back({property.symbol, {}});
    if (is_derived(property)) ++derived_;
    std::vector<Row>& rows = groups_[group].rows;
    places_[{instance.index, property.symbol}] = {group, static_cast<std::uint32_t>(rows.size())};
    rows.push_back({instance, &property, std::move(now), 0});
    log_.close(WritesLog::Reason::shadow, true);
}

void Shadows::remove(Cell cell) {
    const auto found = places_.find(cell);
    if (found == places_.end()) return;
    const Position place = found->second;
    places_.erase(found);
    std::vector<Row>& rows = groups_[place.group].rows;
    if (is_derived(*rows[place.row].property)) --derived_;
    if (place.row + 1 != rows.size()) {
        rows[place.row] = std::move(rows.back());
        places_[{rows[place.row].instance.index, cell.property}] = place;
    }
    rows.pop_back();
    if (empty()) log_.close(WritesLog::Reason::shadow, false);
}

}  // namespace fettle::property
