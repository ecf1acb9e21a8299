#pragma once

#include <fettle/physics_c/basics.h>

#include <string>

// Refuses arguments of a caller in C. Used by this library and by that of a whole game
// (bindings/host).

namespace fettle::physics_c {

/// An error of a caller in C.
struct Failure {
    fettle_code code;
    std::string message;
};

/// What a pointer refers to, which must not be null. `name`: for the message.
template <class Value>
Value& needed(const char* name, Value* pointer) {
    if (pointer == nullptr)
        throw Failure{FETTLE_INVALID, std::string(name) + ": expected a pointer, got null"};
    return *pointer;
}

/// A byte that should be 0 or 1: a caller may have left it uninitialized.
inline bool flag(const bool& byte) {
    return *reinterpret_cast<const unsigned char*>(&byte) != 0;
}

}  // namespace fettle::physics_c
