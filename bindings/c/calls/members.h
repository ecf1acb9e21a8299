#pragma once

#include <calls/calls.h>

#include <optional>

// Conversion between definitions in C and those of the library. The members have the same names in
// both, and a value that may be missing has a `has_...` in C. A definition has one list of its
// members,
//
//     template <class InC, class Each>
//     void each_member(InC& c, physics::ShapeDef& def, const Each& each);
//
// which calls `each` with every member in C and that of the library: `ToC` copies it to C, `FromC`
// from there. `InC` is const for `FromC`.

namespace fettle::physics_c {

/// A member that is an enumerator, with its name for messages and the last enumerator.
template <class Value, class Enum>
struct EnumeratorMember {
    Value& value;
    const char* name;
    Enum last;
};
template <class Value, class Enum>
EnumeratorMember(Value&, const char*, Enum) -> EnumeratorMember<Value, Enum>;
#define FETTLE_ENUMERATOR(member, last) (EnumeratorMember{c.member, #member, last})

struct ToC {
    template <class InC, class Value>
    void operator()(InC& result, const Value& value) const {
        result = InC(converted(value));
    }
    template <class Enum>
    void operator()(const EnumeratorMember<int32_t, Enum>& result, Enum value) const {
        result.value = converted(value);
    }
    template <class InC, class Value>
    void operator()(bool& has, InC& result, const std::optional<Value>& value) const {
        has = value.has_value();
        result = value ? InC(converted(*value)) : InC{};
    }
};

struct FromC {
    template <class Value>
    void operator()(const Value& given, Value& result) const {
        result = from_c(given);
    }
    void operator()(const uint32_t& given, uint16_t& result) const {
        result = checked(Material{given});
    }
    void operator()(const fettle_vec2& given, physics::Vec2& result) const {
        result = vector_of(given);
    }
#ifdef FETTLE_PHYSICS_DOUBLE
    void operator()(const fettle_position& given, physics::Position& result) const {
        result = position_of(given);
    }
#endif
    void operator()(const fettle_aabb& given, physics::Aabb& result) const {
        result = box_of(given);
    }
    template <class Enum>
    void operator()(const EnumeratorMember<const int32_t, Enum>& given, Enum& result) const {
        result = enumerator(given.name, given.value, given.last);
    }
    template <class InC, class Value>
    void operator()(const bool& has, const InC& given, std::optional<Value>& result) const {
        if (!flag(has)) return;
        result.emplace();
        (*this)(given, *result);
    }

  private:
    static bool from_c(const bool& given) {
        return flag(given);
    }
    template <class Value>
    static Value from_c(const Value& given) {
        return given;
    }
};

/// A definition of the library in C. Members that are no part of the list are zero.
template <class InC, class Def>
InC in_c(Def def) {
    InC result{};
    each_member(result, def, ToC());
    result.size = sizeof result;
    return result;
}

/// A definition in C, whose size is checked, for the library.
template <class Def, class InC>
Def from_c(const InC& given) {
    check_size(given.size, sizeof given);
    Def result;
    each_member(given, result, FromC());
    return result;
}

/// As `from_c`; null stands for the defaults.
template <class Def, class InC>
Def from_c_or_defaults(const InC* given) {
    return given == nullptr ? Def() : from_c<Def>(*given);
}

/// Writes the defaults of the library.
template <class Def, class InC>
fettle_code init_as(const char* function, InC* def, size_t size) {
    return init(function, def, size, in_c<InC>(Def()));
}

}  // namespace fettle::physics_c
