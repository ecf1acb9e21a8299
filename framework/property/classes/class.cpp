// Look-up of the members of a class.

#include <fettle/property/class.h>

namespace fettle::property {

int Property::enumerator_index(std::string_view text) const {
    for (std::size_t i = 0; i < enumerators.size(); ++i)
        if (enumerators[i] == text) return static_cast<int>(i);
    return -1;
}

Value Record::get(std::string_view name) const {
    for (std::size_t i = 0; fields != nullptr && i < fields->size() && i < values.size(); ++i)
        if ((*fields)[i].name == name) return values[i];
    return {};
}

bool Class::is_a(const Class& other) const {
    for (const Class* c = this; c != nullptr; c = c->base_)
        if (c == &other) return true;
    return false;
}

namespace {
template <class Map>
auto look_up(const Map& map, Symbol name) -> typename Map::mapped_type {
    if (!name) return nullptr;
    const auto found = map.find(name);
    return found == map.end() ? nullptr : found->second;
}
}  // namespace

const Property* Class::property(Symbol name) const {
    return look_up(property_index_, name);
}
const Method* Class::method(Symbol name) const {
    return look_up(method_index_, name);
}
const Event* Class::event(Symbol name) const {
    return look_up(event_index_, name);
}

std::vector<std::string> Class::member_names() const {
    std::vector<std::string> names;
    for (const Property* property : properties_) names.push_back(property->name);
    for (const Method* method : methods_) names.push_back(method->name);
    return names;
}

}  // namespace fettle::property
