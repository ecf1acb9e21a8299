#include "shadows.h"

#include <fettle/property/tree.h>

namespace fettle::property {
namespace {

bool is_derived(const Property& property) {
    return !property.simulated || !property.derives_from.empty();
}

}  // namespace

void Shadows::refresh(const Tree& tree, const Watchers& watchers, Handle instance) {
    for (const Property* property : tree.class_of(instance).observed_) {
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
    for (const Property* property : tree.class_of(instance).observed_)
        remove({instance.index, property->symbol});
}

void Shadows::update(Cell cell, const Value& value) {
    if (const auto found = places_.find(cell); found != places_.end())
        groups_[found->second.group].rows[found->second.row].last = value;
}

void Shadows::add(const Tree& tree, Handle instance, const Property& property) {
    std::uint32_t group = 0;
    while (group < groups_.size() && groups_[group].property != property.symbol) ++group;
    if (group == groups_.size()) groups_.push_back({property.symbol, true, {}});
    // A derived value may change by an edit too, so its group is always compared.
    if (is_derived(property)) {
        groups_[group].only_stepped = false;
        ++derived_;
    }
    std::vector<Row>& rows = groups_[group].rows;
    places_[{instance.index, property.symbol}] = {group, static_cast<std::uint32_t>(rows.size())};
    rows.push_back({instance, &property, tree.peek(instance, property)});
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
}

}  // namespace fettle::property
