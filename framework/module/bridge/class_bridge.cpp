#include "class_bridge.h"

#include <algorithm>
#include <stdexcept>

#include <fettle/property/utf8.h>

#include "checked_values.h"
#include "column_cell.h"

namespace fettle::module {

using property::Binding;
using property::BindingKind;
using property::Field;
using property::Handle;
using property::Method;
using property::Property;
using property::Row;
using property::Type;
using property::Value;

namespace {

static_assert(static_cast<int>(property::Native::enumeration) == FETTLE_ENUM8,
              "natives are numbered alike");

Type type_of(std::uint32_t type, const std::string& of) {
    if (type > FETTLE_LIST)
        throw property::Error(property::ErrorKind::wrong_type,
                              of + ": there is no type number " + std::to_string(type));
    return static_cast<Type>(type);
}

std::vector<std::string> texts(const char* const* list) {
    std::vector<std::string> all;
    for (; list != nullptr && *list != nullptr; ++list) all.emplace_back(*list);
    return all;
}

/// An older module leaves both limits 0; then any number is allowed. Limits that are not in order
/// are refused when the class is defined.
property::Range range_of(double min, double max) {
    return min == 0 && max == 0 ? property::Range{} : property::Range{min, max};
}

/// A text for people. `of`: what it belongs to.
std::string shown_text(const char* text, const std::string& of, const char* what) {
    const std::string_view all = view(text);
    for (std::size_t at = 0; at < all.size();) {
        const std::size_t size = property::valid_code_point_size(all.substr(at));
        if (size == 0)
            throw property::Error(property::ErrorKind::wrong_type,
                                  of + ": its `" + what + "` is not UTF-8 from byte " +
                                      std::to_string(at + 1) + " on");
        at += size;
    }
    return std::string(all);
}

void require_known_flags(std::uint32_t flags, std::uint32_t known, const std::string& of) {
    if ((flags & ~known) == 0) return;
    throw property::Error(property::ErrorKind::out_of_range, of + ": expected `flags` of at most " +
                                                                 std::to_string(known) + ", got " +
                                                                 std::to_string(flags));
}

std::vector<Field> fields(const fettle_array& array, const std::string& of) {
    std::vector<Field> all;
    for (const fettle_field& field : elements<fettle_field>(array))
        all.push_back({.name = text_or_empty(field.name),
                       .type = type_of(field.type, of),
                       .unit = shown_text(field.unit, of, "unit"),
                       .doc = shown_text(field.doc, of, "doc"),
                       .reference_class = text_or_empty(field.reference_class),
                       .element = type_of(field.element, of),
                       .nullable = (field.flags & FETTLE_NULLABLE) != 0,
                       .range = range_of(field.min, field.max)});
    return all;
}

Value get(void* context, Row row) {
    const auto& property = *static_cast<BridgedProperty*>(context);
    fettle_value value{};
    const Property& declared = *property.declared;
    if (property.removed || property.native.get == nullptr) return declared.default_value;
    try {
        const Running running(property.named, "get");
        property.host->require(property.native.get(property.native.context, row, &value),
                               "its getter");
        return checked_value(declared, received(value));
    } catch (const std::exception& problem) {
        throw property::Error(property::ErrorKind::rejected,
                              declared.owner->name() + "." + declared.name + ": " + problem.what());
    }
}

void set(void* context, Row row, const Value& value) {
    const auto& property = *static_cast<BridgedProperty*>(context);
    if (property.removed || property.native.set == nullptr)
        throw std::invalid_argument("the module that is loaded now has made it read-only");
    Outgoing outgoing;
    const fettle_value given = outgoing.put(value);
    const Running running(property.named, "set");
    property.host->require(property.native.set(property.native.context, row, &given),
                           property.declared->name);
}

void reset(void* context, Row row) {
    const auto& property = *static_cast<BridgedProperty*>(context);
    if (property.removed || property.native.reset == nullptr) return;
    const Running running(property.named, "reset");
    property.host->require(property.native.reset(property.native.context, row),
                           property.declared->name);
}

bool overridden(void* context, Row row) {
    const auto& property = *static_cast<BridgedProperty*>(context);
    if (property.removed || property.native.overridden == nullptr) return false;
    return property.host->run(property.named, "overridden", [&] {
        return property.native.overridden(property.native.context, row) != 0;
    });
}

void invalidate(void* context, Row row) {
    const auto& property = *static_cast<BridgedProperty*>(context);
    if (property.removed || property.native.invalidate == nullptr) return;
    property.host->run(property.named, "invalidate",
                       [&] { property.native.invalidate(property.native.context, row); });
}

property::Result call(void* context, property::Tree&, Handle self, Row row,
                      std::span<const Value> arguments) {
    const auto& method = *static_cast<BridgedMethod*>(context);
    if (method.removed || method.native.call == nullptr)
        throw std::invalid_argument("the module that is loaded now does not have this method");
    Outgoing outgoing;
    fettle_result result{};
    const Running running(method.named, "call");
    method.host->require(
        method.native.call(method.native.context, sent(self), row, outgoing.put(arguments),
                           static_cast<std::uint32_t>(arguments.size()), &result),
        method.declared->name);
    property::Result answer = received(result, *method.declared->record_fields);
    try {
        require_returned(answer, *method.declared->record_fields);
    } catch (const property::Error& problem) {
        throw std::invalid_argument(problem.what());  // the caller adds the path
    }
    return answer;
}

}  // namespace

BridgedClass::BridgedClass(HostTable& host, const fettle_class& native)
    : host_(host), native_(native) {
    property::ClassDescriptor descriptor;
    descriptor.name = text_or_empty(native.name);
    if (native.base != nullptr) descriptor.base = native.base;
    require_known_flags(native.flags, FETTLE_NOT_CREATABLE | FETTLE_SAVED_NATIVELY,
                        descriptor.name);
    descriptor.doc = shown_text(native.doc, descriptor.name, "doc");
    descriptor.stem = text_or_empty(native.stem);
    descriptor.creatable = (native.flags & FETTLE_NOT_CREATABLE) == 0;
    descriptor.weight = native.weight;
    if ((native.flags & FETTLE_SAVED_NATIVELY) != 0)
        descriptor.snapshots = property::Snapshots::natively;
    for (const auto& property : elements<fettle_property>(native.properties))
        descriptor.properties.push_back(bridged(property));
    for (const auto& method : elements<fettle_method>(native.methods))
        descriptor.methods.push_back(bridged(method));
    for (const auto& event : elements<fettle_event>(native.events))
        descriptor.events.push_back({.name = text_or_empty(event.name),
                                     .fields = fields(event.fields, descriptor.name),
                                     .doc = shown_text(event.doc, descriptor.name, "doc")});
    descriptor.lifecycle = lifecycle_of(native, *this);
    // If the same module makes the rows of the base class, its rows serve both classes.
    const property::Class* const base = host.tree->find_class(descriptor.base);
    descriptor.makes_base_rows = base != nullptr && makes_rows_of(*base);
    declared_ = &host.tree->define(std::move(descriptor));
    named_ = {host.named.module, declared_->name().c_str(), nullptr};
    const auto name = [&](auto& member, const auto* declared) {
        member.declared = declared;
        member.named = {named_.module, named_.class_name, declared->name.c_str()};
    };
    for (BridgedProperty& property : properties_)
        name(property, declared_->property(view(property.native.name)));
    for (BridgedMethod& method : methods_)
        name(method, declared_->method(view(method.native.name)));
    write_tags();
}

Property BridgedClass::bridged(const fettle_property& native) {
    const auto is = [&](std::uint32_t flag) { return (native.flags & flag) != 0; };
    const std::string of = text_or_empty(native_.name) + "." + text_or_empty(native.name);
    Property property;
    property.name = text_or_empty(native.name);
    property.type = type_of(native.type, of);
    property.default_value = received(native.default_value);
    require_known_flags(native.flags, 2 * FETTLE_SINGLE_PRECISION - 1, of);
    property.unit = shown_text(native.unit, of, "unit");
    property.range = range_of(native.min, native.max);
    property.doc = shown_text(native.doc, of, "doc");
    property.read_only = is(FETTLE_READ_ONLY);
    property.transient = is(FETTLE_TRANSIENT);
    property.simulated = is(FETTLE_SIMULATED);
    property.clamp = is(FETTLE_CLAMP);
    property.infinity = is(FETTLE_INFINITY);
    property.nullable = is(FETTLE_NULLABLE);
    property.any_type = is(FETTLE_ANY_TYPE);
    property.hidden = is(FETTLE_HIDDEN);
    property.single_precision = is(FETTLE_SINGLE_PRECISION);
    property.element_weight = native.element_weight;
    property.enumerators = texts(native.enumerators);
    property.derives_from = texts(native.derives_from);
    property.element = type_of(native.element, of);
    property.reference_class = text_or_empty(native.reference_class);
    if (native.binding == FETTLE_STORED) return property;

    const auto lacks = [&](const char* what) {
        return property::Error(property::ErrorKind::bad_structure, of + " has no " + what);
    };
    BridgedProperty& kept = properties_.emplace_back();
    kept.host = &host_;
    kept.native = native;
    Binding& binding = property.binding;
    binding.context = &kept;
    if (native.binding == FETTLE_COLUMN) {
        bind_column(property, kept);
    } else if (native.binding != FETTLE_ACCESSOR) {
        throw property::Error(property::ErrorKind::out_of_range,
                              of + ": there is no binding number " +
                                  std::to_string(native.binding) + ", expected 0 to " +
                                  std::to_string(FETTLE_ACCESSOR));
    } else {
        if (native.get == nullptr) throw lacks("get, which an accessor needs");
        binding.kind = BindingKind::accessor;
        binding.get = get;
        if (native.set != nullptr) binding.set = set;
    }
    if (native.reset != nullptr) binding.reset = reset;
    if (native.overridden != nullptr) binding.overridden = overridden;
    if (native.invalidate != nullptr) binding.invalidate = invalidate;
    return property;
}

Method BridgedClass::bridged(const fettle_method& native) {
    const std::string of = text_or_empty(native_.name) + ":" + text_or_empty(native.name);
    if (native.call == nullptr)
        throw property::Error(property::ErrorKind::bad_structure, of + "() has no call");
    BridgedMethod& kept = methods_.emplace_back();
    kept.host = &host_;
    kept.native = native;
    return {.name = text_or_empty(native.name),
            .parameters = fields(native.parameters, of),
            .required = native.required,
            .returns = fields(native.returns, of),
            .many = native.many != 0,
            .doc = shown_text(native.doc, of, "doc"),
            .context = &kept,
            .call = call,
            .effect = native.effect == FETTLE_CHANGES_NOTHING ? property::Effect::nothing
                      : native.effect == FETTLE_CHANGES_TREE  ? property::Effect::tree
                                                              : property::Effect::memory};
}

void BridgedClass::write_tags() {
    for (const auto& event : elements<fettle_event>(native_.events)) {
        const property::Event* declared = declared_->event(view(event.name));
        if (event.tag != nullptr && declared != nullptr)
            *event.tag = {.id = declared, .listeners = &declared->listeners};
    }
}

// --- Rows

namespace {

Row make_row(void* context, property::Tree&, Handle instance) {
    return Row{static_cast<BridgedClass*>(context)->create(instance)};
}

}  // namespace

bool BridgedClass::makes_rows_of(const property::Class& base) const {
    const property::Lifecycle& rows = base.lifecycle();
    return rows.create == &make_row &&
           &static_cast<const BridgedClass*>(rows.context)->host_ == &host_;
}

property::Lifecycle BridgedClass::lifecycle_of(const fettle_class& native, BridgedClass& self) {
    property::Lifecycle lifecycle;
    if (!native.create && !native.place && !native.destroy && !native.draw && !native.draw_over &&
        !native.pose)
        return lifecycle;
    // Each function uses the current module, which may have been reloaded since; a function that it
    // lacks does nothing.
    lifecycle.context = &self;
    lifecycle.create = make_row;
    lifecycle.place = [](void* context, property::Tree&, Handle instance, Row row) {
        auto& c = *static_cast<BridgedClass*>(context);
        const Running running(c.named_, "place");
        if (c.native_.place != nullptr)
            c.host_.require(c.native_.place(c.native_.context, sent(instance), &row), "place");
        return row;
    };
    lifecycle.destroy = [](void* context, property::Tree&, Handle instance, Row row) {
        auto& c = *static_cast<BridgedClass*>(context);
        c.destroy(instance, row);
        c.instances_.erase({instance.index, instance.generation});
    };
    if (native.draw != nullptr)
        lifecycle.draw = [](void* context, const property::Tree&, Handle instance, Row row,
                            property::Painter& painter, double alpha) {
            auto& c = *static_cast<BridgedClass*>(context);
            if (c.native_.draw == nullptr) return;
            const fettle_painter table = painter_table(painter);
            c.host_.run(c.named_, "draw", [&] {
                c.native_.draw(c.native_.context, sent(instance), row, &table, alpha);
            });
        };
    if (native.draw_over != nullptr)
        lifecycle.draw_over = [](void* context, const property::Tree&, Handle instance, Row row,
                                 property::Painter& painter, double alpha) {
            auto& c = *static_cast<BridgedClass*>(context);
            if (c.native_.draw_over == nullptr) return;
            const fettle_painter table = painter_table(painter);
            c.host_.run(c.named_, "draw_over", [&] {
                c.native_.draw_over(c.native_.context, sent(instance), row, &table, alpha);
            });
        };
    if (native.pose != nullptr)
        lifecycle.pose = [](void* context, const property::Tree&, Handle instance, Row row,
                            double alpha) {
            auto& c = *static_cast<BridgedClass*>(context);
            double m[] = {1, 0, 0, 1, 0, 0};
            if (c.native_.pose != nullptr)
                c.host_.run(c.named_, "pose", [&] {
                    c.native_.pose(c.native_.context, sent(instance), row, alpha, m);
                });
            return property::Transform{{m[0], m[1]}, {m[2], m[3]}, {m[4], m[5]}};
        };
    return lifecycle;
}

fettle_row BridgedClass::create(Handle self) {
    if (abandoned_)
        throw property::Error(property::ErrorKind::rejected,
                              "the module of " + declared_->name() + " is not loaded any more");
    fettle_row row = 0;
    if (native_.create != nullptr) try {
            const Running running(named_, "create");
            host_.require(native_.create(native_.context, sent(self), &row),
                          "create of " + declared_->name());
        } catch (const std::invalid_argument& refused) {
            throw property::Error(property::ErrorKind::rejected, refused.what());
        }
    instances_.insert({self.index, self.generation});
    return row;
}

void BridgedClass::revive(Handle self) {
    fettle_row row = create(self);
    host_.tree->set_row(self, row);
    if (native_.place == nullptr || !host_.tree->parent(self)) return;
    const Running running(named_, "place");
    host_.require(native_.place(native_.context, sent(self), &row), "place");
    host_.tree->set_row(self, row);
}

void BridgedClass::destroy(Handle self, Row row) {
    if (native_.destroy != nullptr)
        host_.run(named_, "destroy", [&] { native_.destroy(native_.context, sent(self), row); });
}

void BridgedClass::retire(Handle self) {
    destroy(self, host_.tree->row(self));
}

void BridgedClass::recount() {
    const property::Tree& tree = *host_.tree;
    std::erase_if(instances_, [&](const auto& is) { return !tree.alive({is.first, is.second}); });
    tree.each_below(tree.root(), [&](Handle instance) {
        if (tree.class_of(instance).lifecycle().context == this)
            instances_.insert({instance.index, instance.generation});
    });
}

const BridgedProperty* BridgedClass::find(const Property& declared) const {
    for (const BridgedProperty& property : properties_)
        if (property.declared == &declared || &property == declared.binding.context)
            return &property;
    return nullptr;
}

void BridgedClass::abandon() {
    abandoned_ = true;
    const std::uint32_t flags = native_.flags;  // a later module must have the same
    native_ = {};
    native_.flags = flags;
    for (BridgedProperty& property : properties_) property.removed = true;
    for (BridgedMethod& method : methods_) method.removed = true;
}

// --- Reload of a module

void BridgedClass::replace(const fettle_class& native, std::vector<std::string>& notes) {
    const std::string name = declared_->name();
    const std::string base = native.base == nullptr ? "Object" : native.base;
    if (declared_->base() == nullptr || declared_->base()->name() != base)
        throw std::runtime_error("class " + name + " derives from " + base + " now, not from " +
                                 (declared_->base() ? declared_->base()->name() : "nothing") +
                                 " as before: that needs a new start of the game");
    if ((native.flags & FETTLE_SAVED_NATIVELY) != (native_.flags & FETTLE_SAVED_NATIVELY))
        throw std::runtime_error(
            "rows of class " + name +
            " are saved in another way than before: that needs a new start of the game");
    const auto given = elements<fettle_property>(native.properties);
    for (BridgedProperty& kept : properties_) {
        const auto same = std::find_if(given.begin(), given.end(), [&](const fettle_property& p) {
            return kept.declared->name == view(p.name);
        });
        kept.removed = same == given.end();
        if (kept.removed) {
            notes.push_back(name + "." + kept.declared->name + " is gone");
            continue;
        }
        if (same->type != static_cast<std::uint32_t>(kept.declared->type) ||
            same->binding != kept.native.binding || same->native != kept.native.native)
            throw std::runtime_error(
                name + "." + kept.declared->name +
                " has another type than before: that needs a new start of the game");
        kept.native = *same;
    }
    const auto is_new = [&](const std::string& member) {
        notes.push_back(name + member + " is new: it comes with the next start");
    };
    for (const fettle_property& property : given)
        if (declared_->property(view(property.name)) == nullptr)
            is_new("." + text_or_empty(property.name));
    const auto calls = elements<fettle_method>(native.methods);
    for (BridgedMethod& kept : methods_) {
        const auto same = std::find_if(calls.begin(), calls.end(), [&](const fettle_method& m) {
            return kept.declared->name == view(m.name);
        });
        kept.removed = same == calls.end();
        if (kept.removed)
            notes.push_back(name + ":" + kept.declared->name + "() is gone");
        else
            kept.native = *same;
    }
    for (const fettle_method& method : calls)
        if (declared_->method(view(method.name)) == nullptr)
            is_new(":" + text_or_empty(method.name) + "()");
    for (const fettle_event& event : elements<fettle_event>(native.events))
        if (declared_->event(view(event.name)) == nullptr) is_new("." + text_or_empty(event.name));
    const property::Lifecycle& known = declared_->lifecycle();
    if (native.create != nullptr && known.create == nullptr) is_new(": create");
    if (native.draw != nullptr && known.draw == nullptr) is_new(": draw");
    if (native.draw_over != nullptr && known.draw_over == nullptr) is_new(": draw_over");
    if (native.pose != nullptr && known.pose == nullptr) is_new(": pose");
    native_ = native;
    abandoned_ = false;
    write_tags();
}

}  // namespace fettle::module
