#include "fit_saved_value.h"

#include <cmath>
#include <optional>
#include <utility>

#include <fettle/property/error.h>
#include <fettle/property/spelling.h>

#include "coerce.h"

namespace fettle::property {
namespace {

bool is_of_its_type(const Property& property, const Value& value) {
    return property.any_type || value.is(property.type) ||
           (property.nullable && value.is(Type::nil));
}

/// The value converted to the type of the property, if that is possible without loss.
std::optional<Value> converted(const Property& property, const Value& saved) {
    Value value = saved;
    if (property.type == Type::number && saved.is(Type::integer))
        value = Value(static_cast<double>(saved.integer()));
    // Every whole number below 2^63 is an integer; 2^63 itself is not.
    constexpr double bound = 9223372036854775808.0;
    if (property.type == Type::integer && saved.is(Type::number) &&
        saved.number() == std::floor(saved.number()) && std::abs(saved.number()) < bound)
        value = Value(static_cast<std::int64_t>(saved.number()));
    if (!value.is(property.type) || value.is(Type::reference)) return std::nullopt;
    try {
        return coerce_value(
            property, value,
            {.tree = nullptr, .path = [](const void*) { return std::string(); }, .what = nullptr});
    } catch (const Error&) {
        return std::nullopt;  // out of its range
    }
}

}  // namespace

Value fit_saved_value(const Property& property, Value saved, UnfitValues& unfit) {
    if (is_of_its_type(property, saved)) return saved;
    if (std::optional<Value> value = converted(property, saved)) return *std::move(value);
    unfit.add(property, std::move(saved));
    return property.default_value;
}

void UnfitValues::add(const Property& property, Value saved) {
    OfProperty& of = all_[property.owner->name() + "." + property.name];
    of.property = &property;
    if (of.count++ == 0) of.first = std::move(saved);
}

void UnfitValues::add_removed(const Class& of, std::string_view property, Value saved,
                              std::size_t count) {
    OfProperty& removed = all_[of.name() + "." + std::string(property)];
    removed.count += count;
    if (removed.count > count) return;
    removed.first = std::move(saved);
    std::vector<std::string> names;
    for (const Property* declared : of.properties()) names.push_back(declared->name);
    removed.hint = suggestion(property, names);
}

std::vector<std::string> UnfitValues::lines() const {
    std::vector<std::string> lines;
    for (const auto& [name, of] : all_) {
        const std::string others =
            of.count == 1 ? "" : " and " + std::to_string(of.count - 1) + " more";
        if (of.property == nullptr) {
            lines.push_back(name + ": the class no longer has this property" + of.hint +
                            "; the saved value " + value_text(of.first) + others +
                            (of.count == 1 ? " is" : " are") + " not restored");
            continue;
        }
        lines.push_back(
            name + ": the saved value " + value_text(of.first) + others + " cannot be " +
            expectation(*of.property) +
            ", as the property now requires: " + (of.count == 1 ? "it is" : "they are") +
            " the default, " + value_text(of.property->default_value));
    }
    return lines;
}

}  // namespace fettle::property
