#include "stand_in_values.h"

namespace fettle::module {

using property::Tree;
using property::Type;
using property::Value;

const Value& StandInValues::at(std::uint64_t key) const {
    const auto found = all.find(key);
    return found == all.end() ? default_value : found->second;
}

void StandInValues::set(std::uint64_t key, const Value& value) {
    all[key] = value;
    overridden.insert(key);
}

void StandInValues::reset(std::uint64_t key) {
    all.erase(key);
    overridden.erase(key);
}

std::byte* StandInValues::column() {
    const std::size_t size = (std::size_t{rows->last} + 1) * cell_size;
    if (cells.size() < size) cells.resize(2 * size);
    return cells.data();
}

namespace {

Value default_of(Tree& tree, const property::Field& field) {
    if (field.nullable) return {};
    if (field.type != Type::reference) return property::default_value(field.type);
    const property::Class* of = tree.find_class(field.reference_class);
    return tree.create(of == nullptr ? tree.object_class() : *of);
}

}  // namespace

property::Result StandInAnswer::get(Tree& tree) const {
    if (many) return std::vector<property::Record>{};
    if (returns.empty()) return Value();
    if (returns.size() == 1) return default_of(tree, returns.front());
    property::Record record{.fields = &returns, .values = {}};
    for (const property::Field& field : returns) record.values.push_back(default_of(tree, field));
    return record;
}

}  // namespace fettle::module
