#include <binding/binding.h>

#include <charconv>
#include <cmath>
#include <stdexcept>

#include <fettle/property/exception_text.h>

#include <widgets/classes.h>

namespace fettle::interface {

using property::List;
using property::Place;
using property::Type;
using property::Value;

namespace {

/// "left_shift" and "gamepad.a" as a person reads them.
std::string readable(std::string name) {
    for (char& c : name)
        if (c == '_' || c == '.') c = ' ';
    return name;
}

/// The names of the keys and buttons of an action. The four keys of a direction belong together.
std::string keys_text(const Value& target, const char* separator = ", ") {
    if (target.is(Type::text)) return readable(target.text());
    std::string all;
    if (target.is(Type::list))
        for (const Value& each : target.list()) {
            const std::string keys = keys_text(each, " ");
            if (!keys.empty()) all += (all.empty() ? "" : separator) + keys;
        }
    return all;
}

bool is_of_gamepad(const Value& name) {
    return name.is(Type::text) && name.text().starts_with("gamepad");
}

std::int64_t index_in(const List& items, const std::string& text) {
    for (std::size_t i = 0; i < items.size(); ++i)
        if (items[i].is(Type::text) && items[i].text() == text)
            return static_cast<std::int64_t>(i) + 1;
    return 0;
}

}  // namespace

Place Binding::place_of(const Widget& widget) const {
    Place place = property::resolve(widgets_.tree(), widget.content.bind);
    if (place.property == nullptr)
        throw std::invalid_argument("\"" + widget.content.bind +
                                    "\" is an instance, not a property");
    return place;
}

namespace {

Value read(const property::Tree& tree, const Place& place) {
    const Value whole = tree.get(place.instance, *place.property);
    return place.part.empty() ? whole : property::part_of(whole, place.part, "bind");
}

[[noreturn]] void refuse(const property::Tree& tree, const std::string& what, const Value& target) {
    throw std::invalid_argument("expected " + what + ", got " + tree.text(target));
}

}  // namespace

void Binding::write(const Place& place, const Value& value) {
    property::Tree& tree = widgets_.tree();
    if (place.part.empty()) {
        tree.set(place.instance, *place.property, value);
    } else {
        const Value whole = tree.get(place.instance, *place.property);
        tree.set(place.instance, *place.property,
                 property::with_part(whole, place.part, value, "bind"));
    }
    preferences_.store(place);
}

/// Converts the value of the property to a value of the widget.
Value Binding::shown(const Widget& widget, const Value& target) const {
    const property::Tree& tree = widgets_.tree();
    switch (widget.kind) {
        case Kind::slider:
        case Kind::progress_bar:
            if (!target.is_numeric()) refuse(tree, "a number", target);
            return target.as_double();
        case Kind::toggle:
            if (!target.is(Type::boolean)) refuse(tree, "true or false", target);
            return target;
        case Kind::button:
            if (!target.is(Type::text) && !target.is(Type::list))
                refuse(tree, "the keys of an action", target);
            return keys_text(target);
        case Kind::list:
            if (target.is(Type::text)) return index_in(widget.content.items, target.text());
            if (!target.is(Type::integer)) refuse(tree, "a text or an integer", target);
            return target;
        case Kind::text_field:
            if (!target.is(Type::text) && !target.is_numeric())
                refuse(tree, "a text or a number", target);
            [[fallthrough]];
        default:
            return target.is(Type::text) ? target : Value(tree.text(target));
    }
}

/// Converts the value of the widget to a value of the property.
Value Binding::wanted(const Widget& widget, const Place& place, const Value& own) const {
    Value target = read(widgets_.tree(), place);
    if (widget.kind == Kind::slider && target.is(Type::integer))
        return static_cast<std::int64_t>(std::llround(own.as_double()));
    if (widget.kind == Kind::list && target.is(Type::text)) {
        const std::int64_t n = own.integer();
        if (n < 1 || static_cast<std::size_t>(n) > widget.content.items.size()) return target;
        return widget.content.items[static_cast<std::size_t>(n - 1)];
    }
    if (widget.kind != Kind::text_field || target.is(Type::text)) return own;
    const std::string& text = own.text();
    double number = 0;
    const auto end = text.data() + text.size();
    const auto got = std::from_chars(text.data(), end, number);
    // The text may become a number when more of it is typed.
    if (got.ec != std::errc() || got.ptr != end || !std::isfinite(number)) return target;
    if (target.is(Type::integer)) return static_cast<std::int64_t>(std::llround(number));
    return number;
}

void Binding::report(Widget& widget, const std::string& why) {
    if (widget.bound.problem == why) return;
    widget.bound.problem = why;
    if (report_) report_(widgets_.tree().path(widget.self) + ".bind: " + why);
}

void Binding::begin(Widget& widget) const {
    if (widget.content.bind.empty() || widget.bound.bound_before) return;
    try {
        const Value value = shown(widget, read(widgets_.tree(), place_of(widget)));
        Content& content = widget.content;
        switch (widget.kind) {
            case Kind::slider:
            case Kind::progress_bar:
                content.value = value.as_double();
                break;
            case Kind::toggle:
                content.on = value.boolean();
                break;
            case Kind::list:
                content.selected = value.integer();
                break;
            default:
                content.text = value.text();
        }
    } catch (const std::exception&) {
        // The property may come. If it does not, `update` reports it.
    }
}

void Binding::update(Widget& widget) {
    if (widget.content.bind.empty() || !*main_property(widget.kind)) return;
    property::Tree& tree = widgets_.tree();
    const property::Handle self = widget.self;
    const char* const name = main_property(widget.kind);
    try {
        const Place place = place_of(widget);
        if (widget.kind == Kind::list && widget.content.items.empty() &&
            !place.property->enumerator_values.empty())
            tree.set(self, "items", Value(List(place.property->enumerator_values)));
        const Value target = read(tree, place), own = tree.get(self, name);
        const bool reads_only = widget.kind == Kind::label || widget.kind == Kind::progress_bar ||
                                widget.kind == Kind::button;
        // While the player types a number, the text of the field is not replaced by the number.
        const bool typing = widget.kind == Kind::text_field && widgets_.board.focus == self;
        if (!widget.bound.bound_before || !(target == widget.bound.target_before)) {
            const Value now = shown(widget, target);
            if (!(now == own) && !(typing && wanted(widget, place, own) == target))
                tree.set(self, name, now);
        } else if (!reads_only && !(own == widget.bound.own_before)) {
            const Value value = wanted(widget, place, own);
            if (!(value == target)) write(place, value);
        }
        widget.bound.target_before = read(tree, place_of(widget));
        if (!typing && !reads_only) {
            // The property may have changed the value, for example to an integer.
            const Value now = shown(widget, widget.bound.target_before);
            if (!(now == tree.get(self, name))) tree.set(self, name, now);
        }
        widget.bound.own_before = tree.get(self, name);
        widget.bound.bound_before = true;
        widget.bound.problem.clear();
    } catch (const std::exception& error) {
        widget.bound.bound_before = false;
        report(widget, property::exception_text(error));
    }
}

void Binding::follow_properties() {
    for (Widget& widget : widgets_) widget.bound.bound_before = false;
}

void Binding::update_all() {
    for (Widget& widget : widgets_)
        if (widget.self && !widget.content.bind.empty()) update(widget);
}

property::Range Binding::range(const Widget& widget) const {
    property::Range range{0, 1};
    if (!widget.content.bind.empty() && !(widget.content.min && widget.content.max)) {
        try {
            const Place place = place_of(widget);
            const property::Range& own = place.property->range;
            if (std::isfinite(own.min) && std::isfinite(own.max) && own.min < own.max) range = own;
        } catch (const std::exception&) {
            // `update` reports the error.
        }
    }
    range.min = widget.content.min.value_or(range.min);
    range.max = widget.content.max.value_or(std::max(range.min, range.max));
    return range;
}

double Binding::step(const Widget& widget) const {
    if (widget.content.bind.empty()) return widget.content.step;
    try {
        if (place_of(widget).property->type == Type::integer)
            return std::max(1.0, widget.content.step);
    } catch (const std::exception&) {
        // `update` reports the error.
    }
    return widget.content.step;
}

void Binding::choose(Widget& widget, const std::string& name) {
    try {
        const Place place = place_of(widget);
        const Value target = read(widgets_.tree(), place);
        Value chosen(name);
        if (target.is(Type::list)) {
            List keys;
            bool placed = false;
            for (const Value& each : target.list()) {
                const bool replaced =
                    each.is(Type::text) && is_of_gamepad(each) == is_of_gamepad(chosen);
                if (replaced && placed) continue;
                keys.push_back(replaced ? chosen : each);
                placed = placed || replaced;
            }
            if (!placed) keys.push_back(chosen);
            chosen = Value(std::move(keys));
        }
        write(place, chosen);
    } catch (const std::exception& error) {
        report(widget, property::exception_text(error));
    }
    update(widget);
}

}  // namespace fettle::interface
