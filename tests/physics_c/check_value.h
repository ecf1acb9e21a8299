#pragma once
// Comparisons of values that functions in C read. They are functions, and not macros: hundreds of
// values are compared, and each CHECK is compiled by itself.

#include <fettle_physics.h>
#include <type_traits>

#include "catch.h"

namespace check_value {

/// `name`: what to report.
template <class Value>
void check_equal(const char* name, const Value& value,
                 const std::type_identity_t<Value>& expected) {
    INFO(name);
    if constexpr (std::is_arithmetic_v<Value>)
        CHECK(value == expected);
    else
        CHECK((value.x == expected.x && value.y == expected.y));
}

/// What `read` reads of an object.
template <class Value>
void check_read(const char* name, fettle_code (*read)(const fettle_world*, fettle_id, Value*),
                const fettle_world* world, fettle_id id,
                const std::type_identity_t<Value>& expected) {
    Value value = {};
    INFO(name);
    REQUIRE(read(world, id, &value) == FETTLE_DONE);
    check_equal(name, value, expected);
}

/// What `read` reads of a world.
template <class Value>
void check_read(const char* name, fettle_code (*read)(const fettle_world*, Value*),
                const fettle_world* world, const std::type_identity_t<Value>& expected) {
    Value value = {};
    INFO(name);
    REQUIRE(read(world, &value) == FETTLE_DONE);
    check_equal(name, value, expected);
}

}  // namespace check_value
