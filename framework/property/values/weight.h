#pragma once
// How much memory things of a tree take, about: estimates that are the same in every run, so that a
// command that makes too much is stopped at the same place when it is recorded and made again.

#include <cstddef>
#include <cstdint>

#include <fettle/property/value.h>

namespace fettle::property {

// Bytes, measured in a game of bodies: an instance with its place in the tables of names, the row
// of its module and what the module makes for it in its world.
constexpr std::int64_t weight_of_instance = 400;
constexpr std::int64_t weight_of_name = 160;          // of its own, and never given back
constexpr std::int64_t weight_of_own_property = 140;  // ad hoc, beside its value
constexpr std::int64_t weight_of_own_descriptor = 1024;
constexpr std::int64_t weight_of_class = 8192;
constexpr std::int64_t weight_of_watcher = 500;
constexpr std::int64_t weight_of_formula = 700;
constexpr std::int64_t weight_of_message = 250;  // that waits for the barrier

/// With what it holds.
std::size_t size_of(const Value& value);
/// What it holds beside itself: the letters of a text, the elements of a list.
inline std::int64_t weight_beside(const Value& value) {
    if (!value.is(Type::text) && !value.is(Type::list)) return 0;
    return static_cast<std::int64_t>(size_of(value));
}

}  // namespace fettle::property
