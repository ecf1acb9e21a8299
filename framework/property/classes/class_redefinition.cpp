// Another definition of a class that has instances: its code was loaded again.

#include <algorithm>
#include <utility>

#include <fettle/property/error.h>

#include "class_registry.h"

namespace fettle::property {

namespace {

bool same_kind(const Property& a, const Property& b) {
    return a.type == b.type && a.nullable == b.nullable && a.reference_class == b.reference_class;
}

Property* find_by_name(std::deque<Property>& all, std::string_view name) {
    for (Property& property : all)
        if (property.name == name) return &property;
    return nullptr;
}

}  // namespace

std::vector<Class*> ClassRegistry::with_derived(const Class& of) {
    std::vector<Class*> all;
    for (const auto& each : classes_)
        if (each->is_a(of)) all.push_back(each.get());
    return all;
}

void ClassRegistry::redefine(Class& of, std::vector<Property> wanted) {
    const Class& base = *of.base_;
    for (const Property& property : wanted) {
        if (of.property(property.name) != nullptr) continue;
        for (const Class* derived : with_derived(of))
            if (derived->property(property.name) != nullptr || derived->method(property.name))
                throw Error(ErrorKind::bad_name, of.name() + "." + property.name + ": " +
                                                     derived->name() + " has that name already");
    }
    for (Property& property : of.own_properties_) {
        if (of.property(property.symbol) != &property) continue;  // retired
        const bool stays = std::any_of(wanted.begin(), wanted.end(),
                                       [&](const Property& w) { return w.name == property.name; });
        if (stays) continue;
        if (const Property* inherited = base.property(property.symbol))
            property.default_value = inherited->default_value;
        else
            retire(of, property);
    }
    for (Property& property : wanted) {
        Property* const known = find_by_name(of.own_properties_, property.name);
        const bool inherited = base.property(property.name) != nullptr;
        if (known != nullptr && (inherited || same_kind(*known, property))) {
            Property again = *known;
            again.default_value = property.default_value;
            check_default(of, again);
            known->default_value = again.default_value;
            known->doc = property.doc.empty() && inherited ? known->doc : property.doc;
            continue;
        }
        if (known != nullptr) retire(of, *known);
        if (inherited)
            redeclare(of, std::move(property));
        else
            add_late(of, std::move(property));
    }
}

/// Removes the property from the class and from those that derive from it. Its column stays,
/// unused.
void ClassRegistry::retire(Class& of, Property& property) {
    for (Class* each : with_derived(of)) {
        // A derived class may have declared it again with another default.
        const Property* const here = each->property(property.symbol);
        std::erase(each->properties_, here);
        std::erase(each->observed_, here);
        std::erase(each->initial_, here);
        each->property_index_.erase(property.symbol);
        if (Property* again = find_by_name(each->own_properties_, property.name);
            again != nullptr && each != &of)
            again->name += " (retired)";
    }
    property.name += " (retired)";
}

/// Adds a stored property to the class and to those that derive from it. It has the same index in
/// all of them, so columns without a use fill the gaps.
void ClassRegistry::add_late(Class& of, Property property) {
    const std::vector<Class*> all = with_derived(of);
    std::size_t index = 0;
    for (const Class* each : all) index = std::max(index, each->stored_.size());
    property.symbol = Symbol(property.name);
    property.owner = &of;
    property.shortcut = shortcut_of(property);
    property.shortcut.set_interest(0);
    check_default(of, property);
    property.stored_index = static_cast<std::uint32_t>(index);
    const Property& kept = of.own_properties_.emplace_back(std::move(property));
    for (Class* each : all) {
        while (each->stored_.size() < index) {
            Property& gap = each->own_properties_.emplace_back();
            gap.name = "(unused " + std::to_string(each->stored_.size()) + ")";
            gap.type = Type::boolean;
            gap.default_value = false;
            gap.owner = each;
            gap.hidden = gap.transient = true;
            gap.stored_index = static_cast<std::uint32_t>(each->stored_.size());
            each->stored_.push_back(&gap);
        }
        each->stored_.push_back(&kept);
        each->properties_.push_back(&kept);
        each->property_index_[kept.symbol] = &kept;
    }
}

/// Gives the class its own default of an inherited property.
void ClassRegistry::redeclare(Class& of, Property property) {
    const Property* const inherited = of.base_->property(property.name);
    add_property(of, std::move(property));
    const Property* const kept = of.property(inherited->symbol);
    for (Class* each : with_derived(of)) {
        if (each == &of || each->property(inherited->symbol) != inherited) continue;
        const auto replace = [&](std::vector<const Property*>& list) {
            std::replace(list.begin(), list.end(), inherited, kept);
        };
        replace(each->properties_);
        replace(each->stored_);
        replace(each->observed_);
        if (kept->binding.kind != BindingKind::stored) each->initial_.push_back(kept);
        order_initial(*each);
        each->property_index_[inherited->symbol] = kept;
    }
    order_initial(of);
}

}  // namespace fettle::property
