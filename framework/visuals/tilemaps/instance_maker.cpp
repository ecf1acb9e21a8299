#include <fettle/property/error.h>

#include <tilemaps/map_objects.h>

namespace fettle::visuals {

using property::Error;
using property::ErrorKind;
using property::Handle;
using property::Property;
using property::Type;
using property::Value;

Handle Maker::add(const property::Class& of, Handle parent, const std::string& name) {
    if (name.empty()) return tree_.create(of, parent);
    int& number = numbers_[{parent.index, name}];
    std::string refusal;
    const auto made_instead = [&](Handle made) {
        if (!refusal.empty()) report(refusal + "; it is called \"" + tree_.name(made) + "\"");
        return made;
    };
    for (int tries = 0; tries < 1000; ++tries) {
        ++number;
        const std::string numbered = number == 1 ? name : name + "_" + std::to_string(number);
        if (tree_.child(parent, numbered)) continue;
        try {
            return made_instead(tree_.create(of, parent, numbered));
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::bad_name) throw;
            if (refusal.empty()) refusal = error.what();
        }
    }
    return made_instead(tree_.create(of, parent));
}

void Maker::set(Handle instance, const char* name, const Value& value) {
    try {
        tree_.set(instance, name, value);
    } catch (const Error& error) {
        report(error.what());
    }
}

void Maker::set_if_there(Handle instance, const char* name, const Value& value) {
    if (tree_.find(instance, name) != nullptr) set(instance, name, value);
}

void Maker::set_or_add(Handle instance, const std::string& name, const Value& value) {
    try {
        tree_.set_or_add(instance, name, value);
    } catch (const Error& error) {
        report(error.what());
    }
}

void Maker::set_custom(Handle instance, const maps::Properties& properties) {
    for (const auto& [name, value] : properties) {
        const Property* const property = tree_.find(instance, name);
        if (property != nullptr && property->type == Type::reference && value.is(Type::integer))
            open_.push_back({instance, property, value.integer(), what_});
        else
            set_or_add(instance, name, value);
    }
}

void Maker::resolve_references() {
    for (const Open& each : open_) {
        begin_messages(each.what);
        const auto found = by_id_.find(each.id);
        if (found == by_id_.end()) {
            if (each.id != 0)
                report(each.property->name + ": the map has no object " + std::to_string(each.id));
            continue;
        }
        try {
            tree_.set(each.instance, *each.property, Value(found->second));
        } catch (const Error& error) {
            report(error.what());
        }
    }
    open_.clear();
}

}  // namespace fettle::visuals
