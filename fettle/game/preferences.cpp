#include <game/preferences.h>

#include <string>
#include <variant>

namespace fettle::program {

namespace {

using property::List;
using property::Store;
using property::Type;
using property::Value;

/// Lists are tables in a store, with the keys 1, 2, 3 ...
Store::Entry entry_of(const Value& value) {
    if (!value.is(Type::list)) return {.value = value};
    Store::Entry table{.content = std::make_shared<Store::Content>()};
    std::int64_t number = 0;
    for (const Value& each : value.list()) table.content->entries[++number] = entry_of(each);
    return table;
}

Value value_of(const Store::Entry& entry) {
    if (entry.content == nullptr) return entry.value;
    List list;
    for (const auto& [key, each] : entry.content->entries) list.push_back(value_of(each));
    return list;
}

}  // namespace

void follow_preferences(Store& kept, interface::Interface& interface) {
    for (const auto& [key, entry] : kept.entries(Store::root))
        if (const auto* path = std::get_if<std::string>(&key))
            interface.begin_with(*path, value_of(entry));
    interface.on_preference([&kept](const std::string& path, const Value& value) {
        kept.set(Store::root, path, entry_of(value));
    });
}

}  // namespace fettle::program
