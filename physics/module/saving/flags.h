#pragma once
// Checks of foreign bytes that are about to be read as flags: a byte that is neither 0 nor 1 must
// not be read as a bool.

#include <cstddef>
#include <cstring>
#include <new>
#include <optional>

namespace fettle::physics_module {

inline bool is_flag(const bool& flag) {
    unsigned char byte = 0;
    std::memcpy(&byte, &flag, sizeof flag);
    return byte <= 1;
}

/// The flag of an optional is at the byte that differs between one with a value and one without.
template <class T>
bool is_optional(const std::optional<T>& value) {
    using Optional = std::optional<T>;
    static const std::size_t at = [] {
        alignas(Optional) unsigned char full[sizeof(Optional)] = {}, empty[sizeof(Optional)] = {};
        new (full) Optional(T{});
        new (empty) Optional();
        std::size_t i = sizeof(T);
        while (i < sizeof(Optional) && !(full[i] == 1 && empty[i] == 0)) ++i;
        return i;
    }();
    unsigned char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);  // NOLINT: any byte may be looked at
    return at == sizeof value || bytes[at] <= 1;
}

}  // namespace fettle::physics_module
