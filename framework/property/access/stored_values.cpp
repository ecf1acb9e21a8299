#include <stdexcept>

#include <fettle/property/stored_values.h>

#include <tree/state.h>

namespace fettle::property {

StoredValues::StoredValues(const Tree& tree, Handle instance) : tree_(tree), instance_(instance) {
    const Instances& all = tree.state().instances;
    const Node& node = all.require(instance);
    columns_ = all.stored[node.class_id].get();
    row_ = node.stored_row;
}

template <class T>
const T* StoredValues::find(const Property& property) const {
    if (property.binding.kind != BindingKind::stored || columns_ == nullptr) return nullptr;
    return columns_->find<T>(property, row_);
}

double StoredValues::number(const Property& property) const {
    if (const double* const found = find<double>(property)) return *found;
    return tree_.peek(instance_, property).as_double();
}

std::int64_t StoredValues::integer(const Property& property) const {
    if (const std::int64_t* const found = find<std::int64_t>(property)) return *found;
    return tree_.peek(instance_, property).integer();
}

Vec2 StoredValues::vec2(const Property& property) const {
    if (const Vec2* const found = find<Vec2>(property)) return *found;
    return tree_.peek(instance_, property).vec2();
}

bool StoredValues::boolean(const Property& property) const {
    if (const std::uint8_t* const found = find<std::uint8_t>(property)) return *found != 0;
    return tree_.peek(instance_, property).boolean();
}

Color StoredValues::color(const Property& property) const {
    if (const Color* const found = find<Color>(property)) return *found;
    return tree_.peek(instance_, property).color();
}

const Value& StoredValues::value(const Property& property) const {
    if (const Value* const found = find<Value>(property)) return *found;
    throw std::logic_error(property.name + " is not stored as a value of the tree");
}

}  // namespace fettle::property
