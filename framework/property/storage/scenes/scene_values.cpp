#include <utility>

#include <scenes/scene_names.h>
#include <scenes/scene_text.h>
#include <values/scene_value.h>

namespace fettle::property {

const std::string* SceneValues::value(Handle instance, const std::string& property) const {
    const auto its = values_.find(instance.key());
    if (its == values_.end()) return nullptr;
    const auto found = its->second.find(property);
    return found == its->second.end() ? nullptr : &found->second;
}

void SceneValues::set(Handle instance, const Property& property, std::string text) {
    const Type type = declared_type(property);
    const bool may_name = type == Type::nil || type == Type::reference || type == Type::list;
    if (may_name && text.find('"') != std::string::npos)
        naming_[{instance.key(), property.name}] = instance;
    else
        naming_.erase({instance.key(), property.name});
    values_[instance.key()][property.name] = std::move(text);
}

void SceneValues::remove(Handle instance, const std::string& property) {
    if (const auto its = values_.find(instance.key()); its != values_.end())
        its->second.erase(property);
    naming_.erase({instance.key(), property});
}

void SceneValues::forget(const Tree& tree, Handle instance) {
    const auto one = [this](Handle each) {
        values_.erase(each.key());
        naming_.erase(naming_.lower_bound({each.key(), {}}),
                      naming_.lower_bound({each.key() + 1, {}}));
    };
    one(instance);
    tree.each_below(instance, one);
}

void SceneValues::take_from(const SceneValues& other) {
    for (auto& [instance, values] : values_) {
        const auto known = other.values_.find(instance);
        if (known == other.values_.end()) continue;
        values = known->second;
        const std::pair<std::uint64_t, std::string> begin = {instance, {}},
                                                    end = {instance + 1, {}};
        naming_.erase(naming_.lower_bound(begin), naming_.lower_bound(end));
        naming_.insert(other.naming_.lower_bound(begin), other.naming_.lower_bound(end));
    }
}

void SceneValues::clear() {
    values_.clear();
    naming_.clear();
}

std::size_t SceneValues::bytes() const {
    constexpr std::size_t node = 64;  // of a container, besides the texts
    std::size_t sum = (values_.size() + naming_.size()) * 2 * node;
    for (const auto& [instance, values] : values_)
        for (const auto& [name, text] : values) sum += node + name.size() + text.size();
    return sum;
}

bool SceneValues::rename(const Tree& tree, const std::string& mention, const NewPath& path) {
    bool renamed = false;
    for (const auto& [cell, instance] : naming_) {
        std::string& text = values_.at(cell.first).at(cell.second);
        if (text.find(mention) == std::string::npos || !tree.alive(instance)) continue;
        const Property* declared = tree.class_of(instance).property(cell.second);
        text = declared == nullptr
                   ? value_with_paths(text, path)
                   : value_with_paths(text, path, declared_type(*declared), declared->element);
        renamed = true;
    }
    return renamed;
}

}  // namespace fettle::property
