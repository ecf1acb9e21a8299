#include "coerce.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fettle/property/bound_text.h>
#include <fettle/property/coercion.h>
#include <fettle/property/error.h>
#include <fettle/property/literal_hint.h>
#include <fettle/property/spelling.h>
#include <fettle/property/tree.h>

namespace fettle::property {

namespace {

// 2^63 is exactly representable as a double, INT64_MAX is not.
constexpr double integer_limit = 9223372036854775808.0;

std::string range_text(const Property& property, const Range& range) {
    const bool low = range.min != -std::numeric_limits<double>::infinity();
    const bool high = range.max != std::numeric_limits<double>::infinity();
    const std::string unit = property.unit.empty() ? "" : " " + property.unit;
    if (!low && !high) return property.unit.empty() ? "" : " in" + unit;
    if (!high) return " of at least " + bound_text(range.min, property.precision()) + unit;
    if (!low) return " of at most " + bound_text(range.max, property.precision()) + unit;
    return " from " + bound_text(range.min, property.precision()) + " to " +
           bound_text(range.max, property.precision()) + unit;
}

/// What the elements of a list are called in "a list of numbers".
std::string elements_text(const Property& property) {
    switch (property.element) {
        case Type::vec2:
            return "vec2";
        case Type::reference:
            return property.reference_class.empty() ? "instances"
                                                    : property.reference_class + " instances";
        default:
            return std::string(type_name(property.element)) + "s";
    }
}

/// The type and range that `property`, or an element of its list, accepts.
std::string expectation_in(const Property& property, Type type, const Range& range) {
    if (property.any_type) return "a value";
    const bool takes_nil = property.nullable && type == property.type && type != Type::reference;
    const std::string nil = takes_nil ? " or nil" : "";
    switch (type) {
        case Type::boolean:
            return "true or false" + nil;
        case Type::integer:
            return "an integer" + range_text(property, range) + nil;
        case Type::number:
            return "a number" + range_text(property, range) + nil;
        case Type::vec2:
            return "a vec2" + range_text(property, range) + nil;
        case Type::color:
            return "a color" + nil;
        case Type::reference:
            return property.reference_class.empty()
                       ? "an instance or nil"
                       : with_article(property.reference_class) + " or nil";
        case Type::list:
            return (property.element == Type::nil
                        ? "a list"
                        : "a list of " + elements_text(property) +
                              (range.bounded() ? range_text(property, range) : "")) +
                   nil;
        case Type::text:
            break;
        case Type::nil:
            return "a value";
    }
    if (property.enumerators.empty()) return "a text" + nil;
    // Enumerations may be long (names of keys). Then the message lists only two of them.
    constexpr std::size_t max_listed = 30;
    if (property.enumerators.size() > max_listed)
        return "one of " + std::to_string(property.enumerators.size()) + " texts like \"" +
               property.enumerators.front() + "\" and \"" + property.enumerators.back() + "\"" +
               nil;
    std::string names = "one of ";
    for (std::size_t i = 0; i < property.enumerators.size(); ++i)
        names += (i == 0 ? "\"" : ", \"") + property.enumerators[i] + "\"";
    return names + nil;
}

class Coercion {
  public:
    Coercion(const Property& property, const CoerceContext& context)
        : property_(property), context_(context) {}

    Value run(Type type, const Value& value) const {
        const bool takes_nil = (property_.nullable && !in_list()) || property_.any_type;
        if (value.is_nil() && (takes_nil || type == Type::reference))
            return type == Type::reference && !property_.any_type ? Value(Handle{}) : value;
        switch (type) {
            case Type::nil:
                return any(value);
            case Type::boolean:
                return value.is(Type::boolean) ? value : wrong_type(value);
            case Type::integer:
                return integer(value);
            case Type::number:
                return number(value);
            case Type::text:
                return text(value);
            case Type::vec2:
                return vec2(value);
            case Type::color:
                return color(value);
            case Type::reference:
                return reference(value);
            case Type::list:
                return list(value);
        }
        return wrong_type(value);
    }

    Value run_element(std::size_t index, const Value& value) const {
        element_ = index;
        return property_.any_type ? any(value) : run(property_.element, value);
    }

  private:
    [[noreturn]] void fail(ErrorKind kind, const std::string& reason) const {
        std::string path = context_.path(context_.what);
        if (in_list()) path += "[" + std::to_string(element_) + "]";
        throw Error(kind, path + ": " + reason);
    }
    bool in_list() const { return element_ != 0; }
    std::string expected(const Range& range) const {
        return expectation_in(property_, in_list() ? property_.element : property_.type, range);
    }
    std::string expected() const { return expected(property_.range); }
    [[noreturn]] Value wrong_type(const Value& value) const {
        std::string got(type_name(value.type()));
        if (value.is(Type::reference)) {
            const bool alive = context_.tree != nullptr && context_.tree->alive(value.reference());
            got = alive ? context_.tree->class_of(value.reference()).name() + " " + shown(value)
                        : "an instance that was deleted";
        } else if (value.is(Type::color)) {
            got = shown(value);  // names the type
        } else if (!value.is_nil()) {
            got += " " + shown(value);
        }
        const Type wanted = in_list() ? property_.element : property_.type;
        const bool named = wanted == Type::text && !property_.enumerators.empty();
        Color parsed;
        const bool lone_element =
            wanted == Type::list && (value.is(property_.element) ||
                                     (property_.element == Type::number && value.is_numeric()) ||
                                     (property_.element == Type::color && value.is(Type::text) &&
                                      parse_color(value.text(), parsed)));
        fail(ErrorKind::wrong_type, "expected " + expected() + ", got " + got +
                                        (lone_element ? " (write {" + shown(value) + "})"
                                         : named      ? ""
                                                      : literal_hint(wanted, value)));
    }
    std::string shown(const Value& value) const {
        std::string text =
            context_.tree != nullptr ? context_.tree->text(value) : value_text(value);
        if (text.size() > 60) text = text.substr(0, 57) + "...";
        return text;
    }
    [[noreturn]] void out_of_range(const Value& value) const {
        fail(ErrorKind::out_of_range, "expected " + expected() + ", got " + shown(value));
    }
    /// Reports a finite value that is too large for a float.
    [[noreturn]] void too_large(const Value& value) const {
        constexpr double largest = std::numeric_limits<float>::max();
        const Range fits{.min = std::max(property_.range.min, -largest),
                         .max = std::min(property_.range.max, largest)};
        fail(ErrorKind::out_of_range, "expected " + expected(fits) +
                                          (property_.infinity ? " or infinity" : "") + ", got " +
                                          shown(value));
    }

    // A number of this property: finite unless infinity is allowed, then rounded to what its memory
    // holds, then checked against the range. The bounds are rounded as well, so the number in the
    // declaration or in an error message is accepted as a bound.
    double component(double x, const Value& whole) const {
        if (std::isnan(x))
            fail(ErrorKind::not_finite, "expected " + expected() + ", got " + shown(whole));
        if (std::isinf(x) && !property_.infinity)
            fail(ErrorKind::not_finite, "expected " + expected() + ", got " + shown(whole) +
                                            ": infinity is not allowed here");
        Range range = property_.range;
        if (property_.precision() == Precision::single_precision) {
            range = {.min = narrowed(range.min), .max = narrowed(range.max)};
            const double narrow = narrowed(x);
            if (std::isinf(narrow) && !std::isinf(x)) {
                if (!property_.clamp || !range.bounded()) too_large(whole);
            } else {
                x = narrow;
            }
        }
        if (range.contains(x)) return x;
        if (!property_.clamp) out_of_range(whole);
        return std::clamp(x, range.min, range.max);
    }

    Value number(const Value& value) const {
        if (value.is(Type::integer)) {
            const auto x = static_cast<double>(value.integer());
            const double held =
                property_.precision() == Precision::single_precision ? narrowed(x) : x;
            if (held >= integer_limit || static_cast<std::int64_t>(held) != value.integer())
                fail(ErrorKind::out_of_range,
                     "the integer " + shown(value) + " has no exact value as a number here");
            return component(x, value);
        }
        return value.is(Type::number) ? Value(component(value.number(), value)) : wrong_type(value);
    }

    Value integer(const Value& value) const {
        std::int64_t result = 0;
        if (value.is(Type::integer)) {
            result = value.integer();
        } else if (value.is(Type::number)) {
            const double x = value.number();
            if (std::isnan(x)) fail(ErrorKind::not_finite, "expected " + expected() + ", got nan");
            if (x != std::floor(x) || x < -integer_limit || x >= integer_limit) wrong_type(value);
            result = static_cast<std::int64_t>(x);
        } else {
            wrong_type(value);
        }
        if (!property_.range.contains(static_cast<double>(result))) {
            if (!property_.clamp) out_of_range(value);
            result = static_cast<std::int64_t>(
                std::clamp(static_cast<double>(result), property_.range.min, property_.range.max));
        }
        return result;
    }

    Value text(const Value& value) const {
        if (!value.is(Type::text)) wrong_type(value);
        if (!property_.enumerators.empty() && property_.enumerator_index(value.text()) < 0)
            fail(ErrorKind::out_of_range, "expected " + expected() + ", got " + shown(value) +
                                              suggestion(value.text(), property_.enumerators));
        return value;
    }

    Value vec2(const Value& value) const {
        if (!value.is(Type::vec2)) wrong_type(value);
        return Vec2(component(value.vec2().x, value), component(value.vec2().y, value));
    }

    Value color(const Value& value) const {
        Color parsed;
        if (value.is(Type::text)) {
            if (parse_color(value.text(), parsed)) return parsed;
            fail(ErrorKind::wrong_type, "no color is called " + shown(value) +
                                            suggestion(value.text(), color_names()) +
                                            "; expected a name or \"#rrggbb\"");
        }
        if (!value.is(Type::color)) wrong_type(value);
        parsed = value.color();
        for (float* channel : {&parsed.r, &parsed.g, &parsed.b, &parsed.a}) {
            if (!std::isfinite(*channel))
                fail(ErrorKind::not_finite, "a color's channels must be finite");
            *channel = std::clamp(*channel, 0.0f, 1.0f);
        }
        return parsed;
    }

    Value reference(const Value& value) const {
        if (!value.is(Type::reference)) wrong_type(value);
        if (!value.reference() || context_.tree == nullptr) return value;
        context_.tree->require(value.reference());
        if (!property_.reference_class.empty()) {
            const Class* wanted = context_.tree->find_class(property_.reference_class);
            if (wanted != nullptr && !context_.tree->class_of(value.reference()).is_a(*wanted))
                wrong_type(value);
        }
        return value;
    }

    Value list(const Value& value) const {
        if (!value.is(Type::list)) wrong_type(value);
        if (in_list()) return any(value);  // the type of its own elements is not declared
        List result;
        result.reserve(value.list().size());
        for (const Value& element : value.list()) {
            ++element_;
            result.push_back(run(property_.element, element));
        }
        element_ = 0;
        return result;
    }

    // An untyped property accepts anything but NaN, at any depth.
    Value any(const Value& value) const {
        const auto is_nan = [](double x) { return std::isnan(x); };
        bool nan = false;
        if (value.is(Type::number)) nan = is_nan(value.number());
        if (value.is(Type::vec2)) nan = is_nan(value.vec2().x) || is_nan(value.vec2().y);
        if (value.is(Type::color)) {
            const Color c = value.color();
            nan = is_nan(c.r) || is_nan(c.g) || is_nan(c.b) || is_nan(c.a);
        }
        if (nan) fail(ErrorKind::not_finite, "NaN is never a value of a property");
        if (value.is(Type::reference) && value.reference() && context_.tree != nullptr)
            context_.tree->require(value.reference());
        if (value.is(Type::list))
            for (const Value& element : value.list()) any(element);
        return value;
    }

    const Property& property_;
    const CoerceContext& context_;
    mutable std::size_t element_ = 0;  // index in the list, from 1; 0: not in a list
};

}  // namespace

[[gnu::noinline]] double narrowed(double x) {
    return static_cast<double>(static_cast<float>(x));
}
Vec2 narrowed(const Vec2& v) {
    return {narrowed(v.x), narrowed(v.y)};
}

std::string expectation(const Property& property) {
    return expectation_in(property, property.type, property.range);
}

Property property_like(const Field& field) {
    Property property;
    property.name = field.name;
    property.type = field.type;
    property.any_type = field.type == Type::nil;
    property.unit = field.unit;
    property.reference_class = field.reference_class;
    property.element = field.element;
    property.range = field.range;
    return property;
}

Value coerce_value(const Property& property, const Value& value, const CoerceContext& context) {
    return Coercion(property, context).run(property.any_type ? Type::nil : property.type, value);
}

Value coerce_element(const Property& property, std::size_t index, const Value& value,
                     const CoerceContext& context) {
    return Coercion(property, context).run_element(index, value);
}

Value coerced(const Tree& tree, const Property& property, const Value& value,
              const std::string& path) {
    const auto text = [](const void* what) { return *static_cast<const std::string*>(what); };
    return coerce_value(property, value, {.tree = &tree, .path = text, .what = &path});
}

}  // namespace fettle::property
