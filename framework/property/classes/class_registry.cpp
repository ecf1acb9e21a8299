#include "class_registry.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fettle/property/error.h>
#include <fettle/property/path.h>
#include <fettle/property/spelling.h>

#include <values/weight.h>

#include "coerce.h"
#include "descriptor_check.h"
#include "lasting_fields.h"

namespace fettle::property {
namespace {

// A node stores the number of its class in 16 bits. Classes are never deleted.
constexpr std::size_t max_classes = 10'000;
static_assert(max_classes <= UINT16_MAX);

/// `text_field` for `TextField`, `hud_bar` for `HUDBar`.
std::string stem_of(std::string_view name) {
    const auto capital = [&](std::size_t i) { return name[i] >= 'A' && name[i] <= 'Z'; };
    const auto small = [&](std::size_t i) { return name[i] >= 'a' && name[i] <= 'z'; };
    std::string stem;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const bool begins_word = i > 0 && capital(i) && name[i - 1] != '_' &&
                                 (!capital(i - 1) || (i + 1 < name.size() && small(i + 1)));
        if (begins_word) stem += '_';
        stem += static_cast<char>(capital(i) ? name[i] + ('a' - 'A') : name[i]);
    }
    return stem;
}

// The default of a property whose descriptor gives none.
Value zero_of(const Property& property) {
    // A write of nil to a reference stores the empty reference.
    if (property.any_type || (property.nullable && property.type != Type::reference)) return {};
    if (!property.enumerators.empty()) return property.enumerator_values.front();
    return default_value(property.type);
}

/// The bound itself if it is a float, otherwise the next float inside the range (`inwards`: 1 or
/// -1).
double inner_float(double bound, float inwards) {
    const auto nearest = static_cast<float>(bound);
    const double widened = static_cast<double>(nearest);
    const bool outside = inwards > 0 ? widened < bound : widened > bound;
    return outside ? static_cast<double>(
                         std::nextafter(nearest, inwards * std::numeric_limits<float>::infinity()))
                   : widened;
}

// A number or vector may be read and written without a Value if that skips no check or callback of
// an ordinary write.
Property::Shortcut shortcut_to(const Property& property) {
    Property::Shortcut shortcut;
    const bool number = property.type == Type::number;
    if ((!number && property.type != Type::vec2) || property.any_type || property.nullable)
        return shortcut;
    const Binding& binding = property.binding;
    using Access = Property::Shortcut::Access;
    if (property.sparse) return shortcut;  // it has no cell of its own
    if (binding.kind == BindingKind::stored) {
        shortcut.read = shortcut.write = number ? Access::stored_number : Access::stored_vec2;
    } else {
        const Access called = number ? Access::number : Access::vec2;
        if (number ? binding.number.get != nullptr : binding.vec2.get != nullptr)
            shortcut.read = called;
        // A column's own setter may refuse the value.
        const bool plain = binding.kind != BindingKind::column || binding.set == nullptr;
        if (plain && (number ? binding.number.put != nullptr : binding.vec2.put != nullptr))
            shortcut.write = called;
    }
    if (property.read_only || binding.overridden != nullptr) shortcut.write = Access::none;
    if (binding.kind != BindingKind::stored && binding.invalidate == nullptr &&
        (number ? binding.number.plain : binding.vec2.plain))
        shortcut.plain = shortcut.write;
    shortcut.narrow = property.precision() == Precision::single_precision;
    // Up to this bound, an integer converts to the stored type and back without change.
    const double largest = shortcut.narrow ? 0x1p24 : 0x1p53 - 1;
    shortcut.writable_range.min = std::max(property.range.min, -largest);
    shortcut.writable_range.max = std::min(property.range.max, largest);
    if (shortcut.narrow) {
        // With these bounds, a value between two floats stays in the range after rounding.
        shortcut.writable_range.min = inner_float(shortcut.writable_range.min, 1);
        shortcut.writable_range.max = inner_float(shortcut.writable_range.max, -1);
    }
    return shortcut;
}

}  // namespace

Property::Shortcut ClassRegistry::shortcut_of(const Property& property) {
    return shortcut_to(property);
}

Class* ClassRegistry::find(std::string_view name) const {
    const auto found = by_name_.find(std::string(name));
    return found == by_name_.end() ? nullptr : found->second;
}

std::vector<std::string> ClassRegistry::names() const {
    std::vector<std::string> all;
    for (const auto& c : classes_) all.push_back(c->name());
    return all;
}

void ClassRegistry::require_living(const Class& of) const {
    for (const Class* ended : ended_)
        if (of.is_a(*ended))
            throw Error(ErrorKind::rejected, of.name() +
                                                 ": it can have no instances any more, "
                                                 "because what computed with class " +
                                                 ended->name() + " has ended");
}

Class& ClassRegistry::define(ClassDescriptor descriptor) {
    check_name_length(descriptor.name);
    if (!is_identifier(descriptor.name))
        throw Error(ErrorKind::bad_name,
                    "\"" + descriptor.name + "\" cannot be the name of a class");
    if (classes_.size() >= max_classes)
        throw Error(ErrorKind::rejected, descriptor.name + ": there are " +
                                             std::to_string(max_classes) +
                                             " classes already, as many as a game can have");
    if (find(descriptor.name) != nullptr)
        throw Error(ErrorKind::bad_name, "there is a class \"" + descriptor.name + "\" already");
    const Class* base = descriptor.base.empty() ? nullptr : find(descriptor.base);
    if (!descriptor.base.empty() && base == nullptr)
        throw Error(ErrorKind::unknown_name, "class " + descriptor.name +
                                                 ": no class is called \"" + descriptor.base +
                                                 "\"" + suggestion(descriptor.base, names()));
    if (base == nullptr && size() > 0)
        throw Error(ErrorKind::unknown_name, "class " + descriptor.name +
                                                 ": it derives from no class; the base of all is "
                                                 "\"Object\"");
    if (size() > std::numeric_limits<std::uint16_t>::max())
        throw Error(ErrorKind::bad_structure, "class " + descriptor.name + ": a tree has at most " +
                                                  std::to_string(size()) + " classes");
    check_descriptor(descriptor, base);
    std::unique_ptr<Class> made(new Class());
    made->base_ = base;
    made->snapshots_ = descriptor.snapshots;
    if (base != nullptr && made->snapshots_ == Snapshots::by_value)
        made->snapshots_ = base->snapshots_;
    made->id_ = size();
    made->descriptor_ = std::move(descriptor);
    if (made->descriptor_.stem.empty()) made->descriptor_.stem = stem_of(made->descriptor_.name);
    inherit(*made);
    for (Property& property : made->descriptor_.properties)
        add_property(*made, std::move(property));
    made->descriptor_.properties.clear();
    order_initial(*made);
    for (Method& method : made->descriptor_.methods) {
        method.symbol = Symbol(method.name);
        method.owner = made.get();
        method.record_fields = &lasting(method.returns);
        std::erase_if(made->methods_, [&](const Method* m) { return m->symbol == method.symbol; });
        made->methods_.push_back(&method);
        made->method_index_[method.symbol] = &method;
    }
    for (Event& event : made->descriptor_.events) {
        event.symbol = Symbol(event.name);
        event.owner = made.get();
        event.record_fields = &lasting(event.fields);
        made->events_.push_back(&event);
        made->event_index_[event.symbol] = &event;
    }
    pair_events(*made);
    by_name_[made->name()] = made.get();
    return *classes_.emplace_back(std::move(made));
}

std::int64_t ClassRegistry::weight_of(const Class& of) {
    std::size_t text = of.name().size() + of.doc().size();
    for (const Property& property : of.own_properties_)
        text += property.name.size() + property.doc.size();
    const auto members = static_cast<std::int64_t>(of.properties_.size() + of.events_.size());
    return weight_of_class + members * weight_of_inherited + static_cast<std::int64_t>(text);
}

/// Connects each event `*_begin` with its `*_end`.
void ClassRegistry::pair_events(Class& made) {
    constexpr std::string_view begins = "_begin", ends = "_end";
    for (Event& begin : made.descriptor_.events) {
        if (!begin.name.ends_with(begins)) continue;
        const std::string stem = begin.name.substr(0, begin.name.size() - begins.size());
        for (Event& end : made.descriptor_.events) {
            if (end.name != stem + std::string(ends)) continue;
            begin.end = &end;
            end.begin = &begin;
        }
    }
}

void ClassRegistry::inherit(Class& made) {
    made.lifecycle_ = &made.descriptor_.lifecycle;
    if (made.base_ == nullptr) return;
    const Class& base = *made.base_;
    const Lifecycle& own = made.descriptor_.lifecycle;
    if (!own.any()) made.lifecycle_ = base.lifecycle_;
    if (made.descriptor_.weight == 0) made.descriptor_.weight = base.weight();
    made.properties_ = base.properties_;
    made.methods_ = base.methods_;
    made.events_ = base.events_;
    made.property_index_ = base.property_index_;
    made.method_index_ = base.method_index_;
    made.event_index_ = base.event_index_;
    made.stored_ = base.stored_;
    made.observed_ = base.observed_;
    made.initial_ = base.initial_;
}

void ClassRegistry::add_property(Class& made, Property property) {
    property.symbol = Symbol(property.name);
    const Property* inherited = made.property(property.symbol);
    // A service has another property of that name. The tree goes on to store the inherited one.
    const bool instead =
        inherited != nullptr && inherited->sparse && property.binding.kind != BindingKind::stored;
    if (inherited != nullptr && !instead) {
        // The class redeclares the property with its own default. Everything else is inherited.
        Property again = *inherited;
        if (!property.default_value.is_nil()) again.default_value = property.default_value;
        if (!property.doc.empty()) again.doc = property.doc;
        property = std::move(again);
    }
    property.owner = &made;
    // A property without a function that writes it is read-only.
    if (property.binding.kind == BindingKind::accessor && property.binding.set == nullptr)
        property.read_only = true;
    if (property.binding.kind == BindingKind::node && property.binding.node_set == nullptr)
        property.read_only = true;
    // Without a default, nothing could take the place of nil: `Tree::set` and `reset` would call
    // each other without end.
    if (property.any_type && property.default_value.is_nil()) property.nullable = true;
    // A value that does not fit into the memory is refused; it must not wrap around.
    if (property.binding.kind == BindingKind::column && property.binding.native == Native::i32) {
        property.range.min = std::max(property.range.min, -0x1p31);
        property.range.max = std::min(property.range.max, 0x1p31 - 1);
        if (property.range.min > property.range.max)
            throw Error(ErrorKind::out_of_range,
                        "class " + made.name() + ": property \"" + property.name +
                            "\": a column of 32 bits holds nothing of its range");
    }
    property.shortcut = shortcut_to(property);
    property.shortcut.set_interest(0);
    property.enumerator_values.assign(property.enumerators.begin(), property.enumerators.end());
    check_default(made, property);
    Property& kept = made.own_properties_.emplace_back(std::move(property));
    const auto replace = [&](std::vector<const Property*>& list) {
        std::replace(list.begin(), list.end(), inherited, static_cast<const Property*>(&kept));
    };
    if (instead) {
        replace(made.properties_);
        if (kept.simulated || kept.read_only) made.observed_.push_back(&kept);
    } else if (inherited != nullptr) {
        replace(made.properties_);
        replace(made.stored_);
        replace(made.observed_);
        std::erase(made.initial_, inherited);
        if (kept.binding.kind != BindingKind::stored) made.initial_.push_back(&kept);
    } else {
        made.properties_.push_back(&kept);
        if (kept.binding.kind == BindingKind::stored) {
            kept.stored_index = static_cast<std::uint32_t>(made.stored_.size());
            made.stored_.push_back(&kept);
        }
        if (kept.simulated || kept.read_only) made.observed_.push_back(&kept);
    }
    made.property_index_[kept.symbol] = &kept;
}

/// Initial values are set in the order of declaration, because the valid values of a property may
/// depend on properties before it.
void ClassRegistry::order_initial(Class& made) {
    std::vector<const Property*> ordered;
    for (const Property* property : made.properties_)
        if (std::find(made.initial_.begin(), made.initial_.end(), property) != made.initial_.end())
            ordered.push_back(property);
    made.initial_ = std::move(ordered);
}

void ClassRegistry::check_default(const Class& made, Property& property) const {
    if (property.default_value.is_nil()) {
        property.default_value = zero_of(property);
        // A default that the class does not give must be in range only if a reset can write it.
        if (property.read_only || property.binding.reset != nullptr || !property.range.bounded() ||
            property.default_value.is_nil())
            return;
    }
    struct Names {
        const Class& made;
        const Property& property;
    } names{made, property};
    const CoerceContext context{.tree = nullptr,
                                .path =
                                    [](const void* what) {
                                        const auto& n = *static_cast<const Names*>(what);
                                        return "class " + n.made.name() + ": default of " +
                                               n.property.name;
                                    },
                                .what = &names};
    property.default_value = coerce_value(property, property.default_value, context);
}

}  // namespace fettle::property
