#pragma once

#include <calls/calls.h>

// The functions in C that read and write one property of an object, a line for each property. The
// headers for C declare and explain them; a function of another type than there does not compile.
//
//     FETTLE_PROPERTY(wheel_joint, WheelJoint, hertz, float)
//
// defines fettle_wheel_joint_hertz, which calls WheelJoint::hertz, and
// fettle_wheel_joint_set_hertz, which calls WheelJoint::set_hertz.

// A type cannot be in parentheses.
// NOLINTBEGIN(bugprone-macro-parentheses)

/// A property that is only read. `Type`: its type in C.
#define FETTLE_READING(object, Class, property, Type)                                 \
    fettle_code fettle_##object##_##property(const fettle_world* world, fettle_id id, \
                                             Type* property) {                        \
        return read<&Class::property>(__func__, world, id, property);                 \
    }

#define FETTLE_PROPERTY(object, Class, property, Type)                              \
    FETTLE_READING(object, Class, property, Type)                                   \
    fettle_code fettle_##object##_set_##property(fettle_world* world, fettle_id id, \
                                                 Type property) {                   \
        return edit<&Class::set_##property>(__func__, world, id, property);         \
    }

/// A vector, which is written as two numbers.
#define FETTLE_VECTOR(object, Class, property)                                                 \
    FETTLE_READING(object, Class, property, fettle_vec2)                                       \
    fettle_code fettle_##object##_set_##property(fettle_world* world, fettle_id id, float x,   \
                                                 float y) {                                    \
        return edit<&Class::set_##property>(__func__, world, id, fettle::physics::Vec2(x, y)); \
    }

/// A position, which is written as two coordinates.
#define FETTLE_POSITION(object, Class, property)                                                   \
    FETTLE_READING(object, Class, property, fettle_position)                                       \
    fettle_code fettle_##object##_set_##property(fettle_world* world, fettle_id id,                \
                                                 fettle_coordinate x, fettle_coordinate y) {       \
        return edit<&Class::set_##property>(__func__, world, id, fettle::physics::Position(x, y)); \
    }

// NOLINTEND(bugprone-macro-parentheses)
