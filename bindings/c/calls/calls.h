#pragma once

#include <fettle/physics/physics.h>

#include <cmath>
#include <new>
#include <string>
#include <type_traits>

#include <calls/convert.h>
#include <calls/inside.h>

// How a function in C calls the library: arguments are checked, a handle is made of the id, the
// result is converted, and every exception becomes a code and a message.

namespace fettle::physics_c {

/// Stores the message of the exception that is being handled for `fettle_last_error`, and returns
/// its code.
fettle_code code_of_exception(const char* function) noexcept;

/// Runs `act`; `function`: the name of the function in C, for messages.
template <class Act>
fettle_code guarded(const char* function, Act&& act) noexcept {
    try {
        act();
        return FETTLE_DONE;
    } catch (...) {
        return code_of_exception(function);
    }
}

// Arguments that are checked when the call is guarded.
struct Finite {
    const char* name;
    float value;
};
struct FiniteVector {
    float x, y;
};
struct FinitePoint {
    fettle_coordinate x, y;
};
/// Number of a material, which the library stores in 16 bits.
struct Material {
    uint32_t value;
};
template <auto last>
struct Enumerated {
    const char* name;
    int32_t value;
};

float checked(const Finite& number);
physics::Vec2 checked(const FiniteVector& vector);
physics::Position checked(const FinitePoint& point);
uint16_t checked(const Material& material);
template <auto last>
auto checked(const Enumerated<last>& of) {
    return enumerator(of.name, of.value, last);
}
template <class Value>
const Value& checked(const Value& value) {
    return value;
}

template <class Method>
struct ClassOf;
template <class Result, class Class, class... Arguments>
struct ClassOf<Result (Class::*)(Arguments...)> : std::type_identity<Class> {};
template <class Result, class Class, class... Arguments>
struct ClassOf<Result (Class::*)(Arguments...) const> : std::type_identity<Class> {};

/// Calls a method of the object with an id.
template <auto method, class Object, class... Arguments>
decltype(auto) call_on(const fettle_world* world, fettle_id id, const Arguments&... arguments) {
    Object object = handle<Object>(world, id);
    return (object.*method)(checked(arguments)...);
}

template <auto method, class Out>
fettle_code read(const char* function, const fettle_world* world, Out* out) {
    return guarded(function, [&] {
        Out& result = needed("the result", out);
        result = converted((live(world).*method)());
    });
}
template <auto method, class Out, class... Arguments>
fettle_code read(const char* function, const fettle_world* world, fettle_id id, Out* out,
                 const Arguments&... arguments) {
    using Object = typename ClassOf<decltype(method)>::type;
    return guarded(function, [&] {
        Out& result = needed("the result", out);
        result = converted(call_on<method, Object>(world, id, arguments...));
    });
}

/// Writes an optional value: whether there is one, and the value or zeros.
template <class Value, class Out>
void write_optional(const std::optional<Value>& value, bool* is_set, Out* out) {
    bool& set = needed("is_set", is_set);
    Out& result = needed("the result", out);
    set = value.has_value();
    result = value ? converted(*value) : Out{};
}
template <auto method, class Out>
fettle_code read_optional(const char* function, const fettle_world* world, bool* is_set, Out* out) {
    return guarded(function, [&] { write_optional((live(world).*method)(), is_set, out); });
}
template <auto method, class Out>
fettle_code read_optional(const char* function, const fettle_world* world, fettle_id id,
                          bool* is_set, Out* out) {
    using Object = typename ClassOf<decltype(method)>::type;
    return guarded(function,
                   [&] { write_optional(call_on<method, Object>(world, id), is_set, out); });
}

template <auto method, class... Arguments>
fettle_code edit(const char* function, fettle_world* world, const Arguments&... arguments) {
    using Object = typename ClassOf<decltype(method)>::type;
    return guarded(function, [&] {
        physics::World& edited = editable(world);
        if constexpr (std::is_same_v<Object, physics::World>)
            (edited.*method)(checked(arguments)...);
        else
            call_on<method, Object>(world, arguments...);
    });
}

/// Calls `act(object)`. The overload for a world that is not const also checks that the world may
/// be edited.
template <class Object, class Act>
fettle_code on(const char* function, const fettle_world* world, fettle_id id, const Act& act) {
    return guarded(function, [&] { act(handle<Object>(world, id)); });
}
template <class Object, class Act>
fettle_code on(const char* function, fettle_world* world, fettle_id id, const Act& act) {
    return guarded(function, [&] {
        editable(world);
        act(handle<Object>(world, id));
    });
}

template <class List, class Out>
void write_list(const List& list, Out* out, uint32_t room, uint32_t* count) {
    uint32_t& result = needed("count", count);
    if (room > 0) needed("out", out);
    const auto size = uint32_t(list.size());
    for (uint32_t i = 0; i < size && i < room; ++i) out[i] = converted(list[i]);
    result = size;
}
template <auto method, class Out>
fettle_code list(const char* function, const fettle_world* world, Out* out, uint32_t room,
                 uint32_t* count) {
    return guarded(function, [&] { write_list((live(world).*method)(), out, room, count); });
}
template <auto method, class Out>
fettle_code list(const char* function, const fettle_world* world, fettle_id id, Out* out,
                 uint32_t room, uint32_t* count) {
    using Object = typename ClassOf<decltype(method)>::type;
    return guarded(function,
                   [&] { write_list(call_on<method, Object>(world, id), out, room, count); });
}

/// Writes the defaults of a definition.
template <class Def>
fettle_code init(const char* function, Def* def, size_t size, const Def& defaults) {
    return guarded(function, [&] {
        Def& result = needed("the definition", def);
        check_size(size, sizeof(Def));
        result = defaults;
        result.size = sizeof(Def);
    });
}

/// Writes the id of a new object to `out`, unless the caller passed null.
template <class Id>
void store_id(fettle_id* out, Id id) {
    if (out != nullptr) *out = converted(id);
}

}  // namespace fettle::physics_c
