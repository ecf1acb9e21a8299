#pragma once
// Checks that bytes from a file can be read as flags: a byte that is neither 0 nor 1 must not be
// read as a bool.

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

/// True if the flag of the optional is valid. Its position is the byte that differs between an
/// optional with a value and one without.
template <class T>
bool has_valid_flag(const std::optional<T>& value) {
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
    std::memcpy(bytes, &value, sizeof value);  // NOLINT: any byte may be examined
    return at == sizeof value || bytes[at] <= 1;
}

}  // namespace fettle::physics_module
