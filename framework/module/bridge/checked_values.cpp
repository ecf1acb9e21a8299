#include "checked_values.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fettle/property/error.h>
#include <fettle/property/spelling.h>

namespace fettle::module {

using property::Field;
using property::Property;
using property::Type;
using property::Value;

namespace {

/// False for NaN, and for infinity unless it is allowed.
bool is_finite(const Value& value, bool infinity) {
    const auto good = [&](double x) { return !std::isnan(x) && (infinity || !std::isinf(x)); };
    if (value.is(Type::number)) return good(value.number());
    if (value.is(Type::vec2)) return good(value.vec2().x) && good(value.vec2().y);
    if (!value.is(Type::list)) return true;
    return std::ranges::all_of(value.list(),
                               [&](const Value& v) { return is_finite(v, infinity); });
}

/// Throws Error unless the value is of the kind of the field.
void require_fitting(const Value& value, const Field& field) {
    const auto who = [&] {
        return std::string("the module") + (field.name.empty() ? "" : ", for " + field.name + ",");
    };
    if (!is_finite(value, true))
        throw property::Error(property::ErrorKind::not_finite,
                              who() + " gave " + property::value_text(value));
    const auto fits = [](const Value& v, Type type) {
        return type == Type::nil || v.is(type) || (type == Type::number && v.is(Type::integer));
    };
    const auto require = [&](const Value& v, Type type) {
        if (!fits(v, type))
            throw property::Error(property::ErrorKind::wrong_type,
                                  who() + " gave " + property::value_text(v) + ", expected " +
                                      property::with_article(property::type_name(type)));
    };
    if (value.is_nil() && field.nullable) return;
    require(value, field.type);
    if (value.is(Type::list))
        for (const Value& element : value.list()) require(element, field.element);
}

}  // namespace

void require_returned(const property::Result& result, const std::vector<Field>& fields) {
    const auto require = [&](const property::Record& record) {
        for (std::size_t i = 0; i < record.values.size() && i < fields.size(); ++i)
            require_fitting(record.values[i], fields[i]);
    };
    if (const auto* value = std::get_if<Value>(&result)) {
        if (fields.size() == 1) require_fitting(*value, fields.front());
    } else if (const auto* record = std::get_if<property::Record>(&result)) {
        require(*record);
    } else {
        for (const auto& each : std::get<std::vector<property::Record>>(result)) require(each);
    }
}

Value checked_value(const Property& declared, Value value) {
    if (!is_finite(value, declared.infinity)) return declared.default_value;
    if (declared.any_type || value.type() == declared.type) return value;
    if (value.is_nil() && declared.nullable) return value;
    if (declared.type == Type::number && value.is(Type::integer)) return value.as_double();
    return declared.default_value;
}

}  // namespace fettle::module
