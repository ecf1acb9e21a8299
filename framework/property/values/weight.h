#pragma once
// Estimated memory of parts of a tree. The estimates are the same in every run, so a command that
// exceeds the limit is stopped at the same place in a replay.

#include <cstddef>
#include <cstdint>

#include <fettle/property/class.h>
#include <fettle/property/value.h>

namespace fettle::property {

// Bytes: an instance with its entries in the tables of names. What its module needs for it is in
// the description of its class.
constexpr std::int64_t weight_of_instance = 400;
constexpr std::int64_t weight_of_name = 160;          // for a name of its own, which is never freed
constexpr std::int64_t weight_of_own_property = 140;  // ad hoc, without its value
constexpr std::int64_t weight_of_own_descriptor = 1024;
constexpr std::int64_t weight_of_class = 8192;
constexpr std::int64_t weight_of_inherited = 150;  // for each property of a class, also of its base
constexpr std::int64_t weight_of_watcher = 500;
constexpr std::int64_t weight_of_formula = 700;
constexpr std::int64_t weight_of_message = 250;  // while it waits for the barrier

/// Includes the content of texts and lists.
std::size_t size_of(const Value& value);
/// Only the content: the letters of a text, the elements of a list.
inline std::int64_t weight_beside(const Value& value) {
    if (!value.is(Type::text) && !value.is(Type::list)) return 0;
    return static_cast<std::int64_t>(size_of(value));
}
/// The content, with what the module of a property needs for it.
inline std::int64_t weight_beside(const Value& value, const Property& property) {
    const std::size_t elements = value.is(Type::list) ? value.list().size() : 0;
    return weight_beside(value) + static_cast<std::int64_t>(elements * property.element_weight);
}

}  // namespace fettle::property
