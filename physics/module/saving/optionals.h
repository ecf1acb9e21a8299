#pragma once
// Optional values in a snapshot: a flag, and a value that is 0 if there is none. Their bytes in
// memory would contain what the memory held before.

#include <cstdint>
#include <optional>
#include <vector>

#include <fettle/property/bytes.h>

namespace fettle::physics_module {

/// Throws Error(damaged) for another byte than 0 and 1.
inline bool get_flag(property::ByteReader& from) {
    const auto flag = from.get<std::uint8_t>();
    from.require(flag <= 1, "a flag");
    return flag != 0;
}

template <class T>
void put_optional(property::ByteWriter& to, const std::optional<T>& value) {
    to.put(std::uint8_t{value.has_value()});
    to.put(value.value_or(T{}));
}

template <class T>
std::optional<T> get_optional(property::ByteReader& from) {
    const bool has_value = get_flag(from);
    const T value = from.get<T>();
    return has_value ? std::optional(value) : std::nullopt;
}

template <class T>
void put_optionals(property::ByteWriter& to, const std::vector<std::optional<T>>& values) {
    to.put(std::uint64_t{values.size()});
    for (const std::optional<T>& value : values) put_optional(to, value);
}

template <class T>
std::vector<std::optional<T>> get_optionals(property::ByteReader& from) {
    std::vector<std::optional<T>> values;
    for (std::size_t n = from.count(1 + sizeof(T)); n > 0; --n)
        values.push_back(get_optional<T>(from));
    return values;
}

}  // namespace fettle::physics_module
