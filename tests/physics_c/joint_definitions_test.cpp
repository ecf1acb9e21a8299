#include <fettle/physics/joint_definitions.h>
#include <fettle_physics.h>

#include "catch.h"
#include "check_value.h"

namespace joint_definitions_test {

// Definitions in C have the defaults of the library, and each of their values comes into the joint.

using namespace fettle::physics;
using check_value::check_equal;
using check_value::check_read;

// The members that a type does not have in common with the others, each with a value that is not
// its default. DO is one of CHECK_DEFAULT, SET and CHECK, of which each has a form for each kind.
#define FETTLE_DISTANCE(DO, type)                                                             \
    DO##_OPTIONAL(type, length, 2) DO##_NUMBER(type, min_length, 1)                           \
        DO##_NUMBER(type, max_length, 5) DO##_NUMBER(type, hertz, 3)                          \
            DO##_NUMBER(type, damping_ratio, 0.25f) DO##_NUMBER(type, lower_spring_force, -6) \
                DO##_NUMBER(type, upper_spring_force, 7) DO##_NUMBER(type, motor_speed, 8)    \
                    DO##_NUMBER(type, max_motor_force, 9)
#define FETTLE_REVOLUTE(DO, type)                                                   \
    DO##_OPTIONAL(type, reference_angle, 0.125f) DO##_NUMBER(type, lower_angle, -1) \
        DO##_NUMBER(type, upper_angle, 2) DO##_NUMBER(type, motor_speed, 3)         \
            DO##_NUMBER(type, max_motor_torque, 4) DO##_NUMBER(type, hertz, 5)      \
                DO##_NUMBER(type, damping_ratio, 0.5f) DO##_NUMBER(type, target_angle, 0.75f)
#define FETTLE_PIN_SLOT(DO, type)                                                 \
    DO##_VECTOR(type, axis, 0, 1) DO##_NUMBER(type, lower_translation, -1)        \
        DO##_NUMBER(type, upper_translation, 2) DO##_NUMBER(type, motor_speed, 3) \
            DO##_NUMBER(type, max_motor_force, 4) DO##_NUMBER(type, hertz, 5)     \
                DO##_NUMBER(type, damping_ratio, 0.5f)                            \
                    DO##_NUMBER(type, target_translation, 0.75f)
#define FETTLE_PRISMATIC(DO, type) \
    FETTLE_PIN_SLOT(DO, type) DO##_OPTIONAL(type, reference_angle, 0.125f)
#define FETTLE_WHEEL(DO, type)                                                       \
    DO##_VECTOR(type, axis, 1, 0) DO##_NUMBER(type, lower_translation, -1)           \
        DO##_NUMBER(type, upper_translation, 2) DO##_NUMBER(type, hertz, 5)          \
            DO##_NUMBER(type, damping_ratio, 0.5f) DO##_NUMBER(type, motor_speed, 3) \
                DO##_NUMBER(type, max_motor_torque, 4)
#define FETTLE_WELD(DO, type)                                                      \
    DO##_OPTIONAL(type, reference_angle, 0.125f) DO##_NUMBER(type, hertz, 5)       \
        DO##_NUMBER(type, damping_ratio, 0.5f) DO##_NUMBER(type, angular_hertz, 6) \
            DO##_NUMBER(type, angular_damping_ratio, 0.25f)
#define FETTLE_MOTOR(DO, type)                                                                 \
    DO##_VECTOR(type, linear_velocity, 1, 2) DO##_NUMBER(type, angular_velocity, 3)            \
        DO##_NUMBER(type, max_force, 4) DO##_NUMBER(type, max_torque, 5)                       \
            DO##_VECTOR(type, linear_offset, 6, 7) DO##_OPTIONAL(type, angular_offset, 0.125f) \
                DO##_NUMBER(type, hertz, 8) DO##_NUMBER(type, damping_ratio, 0.5f)
#define FETTLE_PULLEY(DO, type)                                                                   \
    DO##_POINT(type, ground_a, 0, 8) DO##_POINT(type, ground_b, 4, 9) DO##_NUMBER(type, ratio, 2) \
        DO##_OPTIONAL(type, length, 40)
#define FETTLE_GEAR(DO, type) DO##_NUMBER(type, ratio, 2) DO##_OPTIONAL(type, phase, 0.5f)
#define FETTLE_GROOVE(DO, type) DO##_POINT(type, end, 3, 4)
#define FETTLE_RATCHET(DO, type)                                                \
    DO##_OPTIONAL(type, reference_angle, 0.125f) DO##_NUMBER(type, tooth, 0.5f) \
        DO##_FLAG(type, backwards, true)
#define FETTLE_ROTARY_LIMIT(DO, type)                                               \
    DO##_OPTIONAL(type, reference_angle, 0.125f) DO##_NUMBER(type, lower_angle, -1) \
        DO##_NUMBER(type, upper_angle, 2)
#define FETTLE_FILTER(DO, type)

#define CHECK_DEFAULT_NUMBER(type, name, value) \
    check_equal(#type " " #name, def.name, defaults.name);
#define CHECK_DEFAULT_FLAG CHECK_DEFAULT_NUMBER
#define CHECK_DEFAULT_OPTIONAL(type, name, value) \
    check_equal(#type " has_" #name, def.has_##name, defaults.name.has_value());
#define CHECK_DEFAULT_VECTOR(type, name, at_x, at_y)                \
    check_equal(#type " " #name " x", def.name.x, defaults.name.x); \
    check_equal(#type " " #name " y", def.name.y, defaults.name.y);
#define CHECK_DEFAULT_POINT CHECK_DEFAULT_VECTOR

#define SET_NUMBER(type, name, value) def.name = value;
#define SET_FLAG SET_NUMBER
#define SET_OPTIONAL(type, name, value) \
    def.has_##name = true;              \
    def.name = value;
#define SET_VECTOR(type, name, at_x, at_y) def.name = {at_x, at_y};
#define SET_POINT SET_VECTOR

#define CHECK_VALUE(type, name, ...) \
    check_read(#type " " #name, fettle_##type##_##name, world, joint, __VA_ARGS__);
#define CHECK_NUMBER(type, name, given) CHECK_VALUE(type##_joint, name, given)
#define CHECK_OPTIONAL CHECK_NUMBER
#define CHECK_FLAG CHECK_NUMBER
#define CHECK_VECTOR(type, name, at_x, at_y) CHECK_VALUE(type##_joint, name, {at_x, at_y})
#define CHECK_POINT CHECK_VECTOR

#define CHECK_TYPE(type, Def, MEMBERS)                                                    \
    {                                                                                     \
        const Def defaults;                                                               \
        fettle_##type##_joint_def def;                                                    \
        fettle_id joint = 0;                                                              \
        REQUIRE(fettle_##type##_joint_def_init(&def, sizeof def) == FETTLE_DONE);         \
        check_common_defaults(def, defaults);                                             \
        MEMBERS(CHECK_DEFAULT, type)                                                      \
        set_common(def, a, b);                                                            \
        MEMBERS(SET, type)                                                                \
        const fettle_code code = fettle_world_create_##type##_joint(world, &def, &joint); \
        INFO(fettle_last_error());                                                        \
        REQUIRE(code == FETTLE_DONE);                                                     \
        check_common(world, joint, a, b);                                                 \
        MEMBERS(CHECK, type)                                                              \
        def.size -= 1;                                                                    \
        CHECK(fettle_world_create_##type##_joint(world, &def, &joint) == FETTLE_INVALID); \
    }

namespace {

template <class InC, class Def>
void check_common_defaults(const InC& def, const Def& defaults) {
    check_equal("size", def.size, sizeof def);
    check_equal("body_a", def.body_a, 0);
    check_equal("body_b", def.body_b, 0);
    check_equal("user_data", def.user_data, 0);
    check_equal("anchor_a", def.anchor_a, {0, 0});
    check_equal("anchor_b", def.anchor_b, {0, 0});
    check_equal("collide", def.collide, defaults.collide);
    check_equal("enabled", def.enabled, defaults.enabled);
    check_equal("break_force", def.break_force, defaults.break_force);
    check_equal("break_torque", def.break_torque, defaults.break_torque);
    check_equal("report_force", def.report_force, defaults.report_force);
    check_equal("report_torque", def.report_torque, defaults.report_torque);
    check_equal("constraint_hertz", def.constraint_hertz, defaults.constraint_hertz);
    check_equal("constraint_damping_ratio", def.constraint_damping_ratio,
                defaults.constraint_damping_ratio);
}

template <class InC>
void set_common(InC& def, fettle_id a, fettle_id b) {
    def.body_a = a;
    def.body_b = b;
    def.anchor_a = {0.5f, 0.25f};
    def.anchor_b = {-0.5f, 0.125f};
    def.collide = true;
    def.enabled = false;
    def.user_data = 77;
    def.break_force = 11;
    def.break_torque = 12;
    def.report_force = 13;
    def.report_torque = 14;
    def.constraint_hertz = 15;
    def.constraint_damping_ratio = 16;
}

void check_common(const fettle_world* world, fettle_id joint, fettle_id a, fettle_id b) {
    CHECK_VALUE(joint, body_a, a)
    CHECK_VALUE(joint, body_b, b)
    CHECK_VALUE(joint, anchor_a, {0.5f, 0.25f})
    CHECK_VALUE(joint, anchor_b, {-0.5f, 0.125f})
    CHECK_VALUE(joint, collide, true)
    CHECK_VALUE(joint, enabled, false)
    CHECK_VALUE(joint, user_data, 77)
    CHECK_VALUE(joint, break_force, 11)
    CHECK_VALUE(joint, break_torque, 12)
    CHECK_VALUE(joint, report_force, 13)
    CHECK_VALUE(joint, report_torque, 14)
    CHECK_VALUE(joint, constraint_hertz, 15)
    CHECK_VALUE(joint, constraint_damping_ratio, 16)
}

}  // namespace

TEST_CASE("every value of a definition of a joint in C comes into the joint") {
    fettle_world* world = nullptr;
    fettle_id a = 0, b = 0;
    REQUIRE(fettle_world_create(nullptr, &world) == FETTLE_DONE);
    REQUIRE(fettle_world_create_body(world, nullptr, &a) == FETTLE_DONE);
    REQUIRE(fettle_world_create_body(world, nullptr, &b) == FETTLE_DONE);
    CHECK_TYPE(distance, DistanceJointDef, FETTLE_DISTANCE)
    CHECK_TYPE(revolute, RevoluteJointDef, FETTLE_REVOLUTE)
    CHECK_TYPE(prismatic, PrismaticJointDef, FETTLE_PRISMATIC)
    CHECK_TYPE(wheel, WheelJointDef, FETTLE_WHEEL)
    CHECK_TYPE(weld, WeldJointDef, FETTLE_WELD)
    CHECK_TYPE(motor, MotorJointDef, FETTLE_MOTOR)
    CHECK_TYPE(pulley, PulleyJointDef, FETTLE_PULLEY)
    CHECK_TYPE(gear, GearJointDef, FETTLE_GEAR)
    CHECK_TYPE(groove, GrooveJointDef, FETTLE_GROOVE)
    CHECK_TYPE(pin_slot, PinSlotJointDef, FETTLE_PIN_SLOT)
    CHECK_TYPE(ratchet, RatchetJointDef, FETTLE_RATCHET)
    CHECK_TYPE(filter, FilterJointDef, FETTLE_FILTER)
    CHECK_TYPE(rotary_limit, RotaryLimitJointDef, FETTLE_ROTARY_LIMIT)
    REQUIRE(fettle_world_destroy(world) == FETTLE_DONE);
}

TEST_CASE("a definition in C whose limits cross is refused with both numbers") {
    fettle_world* world = nullptr;
    fettle_id body = 0, joint = 0;
    fettle_revolute_joint_def def;
    REQUIRE(fettle_world_create(nullptr, &world) == FETTLE_DONE);
    REQUIRE(fettle_world_create_body(world, nullptr, &body) == FETTLE_DONE);
    REQUIRE(fettle_revolute_joint_def_init(&def, sizeof def) == FETTLE_DONE);
    def.body_b = body;
    def.lower_angle = 2;
    def.upper_angle = 1;
    CHECK(fettle_world_create_revolute_joint(world, &def, &joint) == FETTLE_INVALID);
    CHECK_THAT(fettle_last_error(),
               contains("lower_angle = 2: expected at most upper_angle, which is 1"));
    CHECK(joint == 0);
    REQUIRE(fettle_world_destroy(world) == FETTLE_DONE);
}

TEST_CASE("a rope that a definition in C leaves open is taut over the wheels that it names") {
    fettle_world* world = nullptr;
    fettle_id a = 0, b = 0, rope = 0;
    fettle_pulley_joint_def def;
    float length = 0;
    REQUIRE(fettle_world_create(nullptr, &world) == FETTLE_DONE);
    REQUIRE(fettle_world_create_body(world, nullptr, &a) == FETTLE_DONE);
    REQUIRE(fettle_world_create_body(world, nullptr, &b) == FETTLE_DONE);
    REQUIRE(fettle_pulley_joint_def_init(&def, sizeof def) == FETTLE_DONE);
    def.body_a = a;
    def.body_b = b;
    def.ground_a = {0, 4};
    def.ground_b = {3, 4};
    REQUIRE(fettle_world_create_pulley_joint(world, &def, &rope) == FETTLE_DONE);
    REQUIRE(fettle_pulley_joint_length(world, rope, &length) == FETTLE_DONE);
    CHECK(length == 9);
    REQUIRE(fettle_world_destroy(world) == FETTLE_DONE);
}

}  // namespace joint_definitions_test
