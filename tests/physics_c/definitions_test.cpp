#include <fettle/physics/definitions.h>
#include <fettle_physics.h>

#include <cstring>

#include "catch.h"
#include "check_value.h"
#include "header_text.h"

namespace definitions_test {

// Each value of a definition in C comes into the object.

using check_value::check_equal;
using check_value::check_read;

namespace {

/// Values that are no defaults; those of one definition differ from each other.
class Values {
  public:
    float number() { return next_ += 0.0625f; }
    fettle_vec2 vector() { return {number(), number()}; }
    fettle_position point() { return {number(), number()}; }

  private:
    float next_ = 0.0625f;
};

struct World {
    World() { REQUIRE(fettle_world_create(nullptr, &world) == FETTLE_DONE); }
    ~World() { fettle_world_destroy(world); }
    World(const World&) = delete;
    World& operator=(const World&) = delete;
    fettle_world* world = nullptr;
};

/// The number of members of a structure in C. A test compares it with the number that it checks, so
/// that no new member is forgotten.
size_t members_in(const std::string& structure) {
    const std::string& text = header_text::in_c();
    const size_t at = text.find("typedef struct fettle_" + structure + " {");
    const std::string body = text.substr(at, text.find("\n}", at) - at);
    return size_t(std::count(body.begin(), body.end(), ';'));
}

#define CHECK_READ(object, name) \
    check_read(#name, fettle_##object##_##name, in.world, id, def.name);

}  // namespace

TEST_CASE("each value of the definition of a body in C comes into the body") {
    REQUIRE(members_in("body_def") == 29);  // those below
    World in;
    Values values;
    fettle_body_def def;
    REQUIRE(fettle_body_def_init(&def, sizeof def) == FETTLE_DONE);
    def.type = FETTLE_BODY_KINEMATIC;
    def.position = values.point();
    def.velocity = values.vector();
    def.force = values.vector();
    def.center = values.vector();
    def.has_mass = def.has_inertia = def.has_center = def.has_sleep_speed = true;
    for (float* number :
         {&def.angle, &def.angular_velocity, &def.torque, &def.gravity_scale, &def.linear_damping,
          &def.angular_damping, &def.mass, &def.inertia, &def.sleep_speed})
        *number = values.number();
    def.max_speed = 50;
    def.can_sleep = false;
    def.bullet = def.locked_x = def.locked_y = def.locked_rotation = true;
    def.name = "crate";
    def.user_data = 77;
    fettle_id id = 0;
    REQUIRE(fettle_world_create_body(in.world, &def, &id) == FETTLE_DONE);
    CHECK_READ(body, type)
    CHECK_READ(body, position)
    CHECK_READ(body, velocity)
    CHECK_READ(body, force)
    CHECK_READ(body, center)
    CHECK_READ(body, angle)
    CHECK_READ(body, angular_velocity)
    CHECK_READ(body, torque)
    CHECK_READ(body, gravity_scale)
    CHECK_READ(body, linear_damping)
    CHECK_READ(body, angular_damping)
    CHECK_READ(body, sleep_speed)
    CHECK_READ(body, max_speed)
    CHECK_READ(body, can_sleep)
    CHECK_READ(body, bullet)
    CHECK_READ(body, locked_x)
    CHECK_READ(body, locked_y)
    CHECK_READ(body, locked_rotation)
    CHECK_READ(body, user_data)
    bool is_set = false;
    float value = 0;
    REQUIRE(fettle_body_mass_override(in.world, id, &is_set, &value) == FETTLE_DONE);
    CHECK((is_set && value == def.mass));
    REQUIRE(fettle_body_inertia_override(in.world, id, &is_set, &value) == FETTLE_DONE);
    CHECK((is_set && value == def.inertia));
    const char* name = nullptr;
    REQUIRE(fettle_body_name(in.world, id, &name) == FETTLE_DONE);
    CHECK(std::strcmp(name, "crate") == 0);
    // These two change what the others are.
    def.enabled = def.awake = false;
    def.type = FETTLE_BODY_DYNAMIC;
    def.can_sleep = true;
    def.velocity = {};
    def.angular_velocity = 0;
    REQUIRE(fettle_world_create_body(in.world, &def, &id) == FETTLE_DONE);
    CHECK_READ(body, enabled)
    CHECK_READ(body, awake)
}

TEST_CASE("each value of the definition of a shape in C comes into the shape") {
    REQUIRE(members_in("shape_def") == 16);
    World in;
    Values values;
    fettle_shape_def def;
    REQUIRE(fettle_shape_def_init(&def, sizeof def) == FETTLE_DONE);
    for (float* number : {&def.density, &def.friction, &def.restitution, &def.rolling_resistance,
                          &def.surface_speed})
        *number = values.number();
    def.sensor = def.hit_events = true;
    def.contact_events = def.sensor_events = def.before_solve = false;
    def.material = 65535;
    def.group = -3;
    def.category = 6;
    def.mask = 9;
    def.user_data = 77;
    fettle_geometry circle;
    REQUIRE(fettle_geometry_init(&circle, sizeof circle, FETTLE_SHAPE_CIRCLE) == FETTLE_DONE);
    fettle_id id = 0;
    REQUIRE(fettle_world_create_shape(in.world, &circle, &def, &id) == FETTLE_DONE);
    CHECK_READ(shape, density)
    CHECK_READ(shape, friction)
    CHECK_READ(shape, restitution)
    CHECK_READ(shape, rolling_resistance)
    CHECK_READ(shape, surface_speed)
    CHECK_READ(shape, sensor)
    CHECK_READ(shape, hit_events)
    CHECK_READ(shape, contact_events)
    CHECK_READ(shape, sensor_events)
    CHECK_READ(shape, before_solve)
    CHECK_READ(shape, material)
    CHECK_READ(shape, group)
    CHECK_READ(shape, category)
    CHECK_READ(shape, mask)
    CHECK_READ(shape, user_data)
}

TEST_CASE("each value of the definition of a world in C comes into the world") {
    REQUIRE(members_in("world_def") == 21);
    Values values;
    fettle_world_def def;
    REQUIRE(fettle_world_def_init(&def, sizeof def) == FETTLE_DONE);
    def.substeps = 7;
    def.gravity = values.vector();
    def.has_bounds = true;
    def.bounds = {{-3, -4}, {5, 6}};
    for (float* number :
         {&def.bounds_friction, &def.bounds_restitution, &def.restitution_threshold,
          &def.hit_threshold, &def.sleep_speed, &def.sleep_delay, &def.contact_hertz,
          &def.contact_damping, &def.push_speed, &def.max_speed})
        *number = values.number();
    def.sleeping = def.continuous = false;
    def.persist_events = true;
    def.friction_mix = FETTLE_MIX_MULTIPLY;
    def.restitution_mix = FETTLE_MIX_MINIMUM;
    def.solver = FETTLE_SOLVER_DIRECT;
    fettle_world* world = nullptr;
    REQUIRE(fettle_world_create(&def, &world) == FETTLE_DONE);
#define CHECK_SETTING(name) check_read(#name, fettle_world_##name, world, def.name);
    CHECK_SETTING(substeps)
    CHECK_SETTING(gravity)
    CHECK_SETTING(bounds_friction)
    CHECK_SETTING(bounds_restitution)
    CHECK_SETTING(restitution_threshold)
    CHECK_SETTING(hit_threshold)
    CHECK_SETTING(sleep_speed)
    CHECK_SETTING(sleep_delay)
    CHECK_SETTING(contact_hertz)
    CHECK_SETTING(contact_damping)
    CHECK_SETTING(push_speed)
    CHECK_SETTING(max_speed)
    CHECK_SETTING(sleeping)
    CHECK_SETTING(continuous)
    CHECK_SETTING(persist_events)
    CHECK_SETTING(friction_mix)
    CHECK_SETTING(restitution_mix)
    CHECK_SETTING(solver)
#undef CHECK_SETTING
    bool is_set = false;
    fettle_aabb bounds;
    REQUIRE(fettle_world_bounds(world, &is_set, &bounds) == FETTLE_DONE);
    CHECK((is_set && bounds.min.x == -3 && bounds.min.y == -4 && bounds.max.x == 5));
    fettle_world_destroy(world);
}

TEST_CASE("each value of the definition of a mouse joint in C comes into the joint") {
    REQUIRE(members_in("mouse_joint_def") == 10);
    World in;
    Values values;
    fettle_id body = 0, id = 0;
    REQUIRE(fettle_world_create_body(in.world, nullptr, &body) == FETTLE_DONE);
    fettle_mouse_joint_def def;
    REQUIRE(fettle_mouse_joint_def_init(&def, sizeof def) == FETTLE_DONE);
    def.body = body;
    def.has_anchor = true;
    def.anchor = values.vector();
    def.target = values.point();
    def.hertz = values.number();
    def.damping_ratio = values.number();
    def.max_force = values.number();
    def.enabled = false;
    def.user_data = 77;
    REQUIRE(fettle_world_create_mouse_joint(in.world, &def, &id) == FETTLE_DONE);
    fettle_position anchor = {};
    REQUIRE(fettle_mouse_joint_anchor(in.world, id, &anchor) == FETTLE_DONE);
    CHECK((anchor.x == def.anchor.x && anchor.y == def.anchor.y));
    CHECK_READ(mouse_joint, target)
    CHECK_READ(mouse_joint, hertz)
    CHECK_READ(mouse_joint, damping_ratio)
    CHECK_READ(mouse_joint, max_force)
    CHECK_READ(joint, enabled)
    CHECK_READ(joint, user_data)
}

TEST_CASE("each value of the definition of a field in C comes back") {
    World in;
    for (int32_t type = FETTLE_FIELD_WIND; type <= FETTLE_FIELD_ATTRACTOR; ++type) {
        INFO(type);
        fettle_field_def def, back;
        REQUIRE(fettle_field_def_init(&def, sizeof def, type) == FETTLE_DONE);
        CHECK(def.type == type);
        def.has_region = true;
        def.region = {{-3, -4}, {5, 6}};
        def.enabled = false;
        def.mask = 9;
        def.user_data = 77;
        // A type uses the members that are not zero in its defaults, and a few more.
        Values values;
        const auto set = [&](auto& number) {
            if (number != 0) number = decltype(number + 0)(values.number());
        };
        for (float* number :
             {&def.velocity.x, &def.density, &def.linear, &def.drag, &def.strength, &def.core})
            set(*number);
        if (type == FETTLE_FIELD_DRAG) def.quadratic = values.number();
        if (type == FETTLE_FIELD_DRAG || type == FETTLE_FIELD_BUOYANCY) def.flow = values.vector();
        if (type == FETTLE_FIELD_BUOYANCY) {
            def.level = values.number();
            def.normal = {1, 0};
        }
        if (type == FETTLE_FIELD_ATTRACTOR) {
            def.center = values.point();
            def.falloff = 3;
        }
        fettle_id id = 0;
        REQUIRE(fettle_world_create_field(in.world, &def, &id) == FETTLE_DONE);
        REQUIRE(fettle_field_def_init(&back, sizeof back, type) == FETTLE_DONE);
        REQUIRE(fettle_field_definition(in.world, id, &back) == FETTLE_DONE);
#define CHECK_MEMBER(name) check_equal(#name, back.name, def.name)
        CHECK_MEMBER(type);
        CHECK_MEMBER(has_region);
        CHECK_MEMBER(region.min.x);
        CHECK_MEMBER(region.max.y);
        CHECK_MEMBER(enabled);
        CHECK_MEMBER(mask);
        CHECK_MEMBER(user_data);
        CHECK_MEMBER(velocity.x);
        CHECK_MEMBER(density);
        CHECK_MEMBER(linear);
        CHECK_MEMBER(quadratic);
        CHECK_MEMBER(drag);
        CHECK_MEMBER(flow.x);
        CHECK_MEMBER(flow.y);
        CHECK_MEMBER(level);
        CHECK_MEMBER(normal.x);
        CHECK_MEMBER(center.x);
        CHECK_MEMBER(center.y);
        CHECK_MEMBER(strength);
        CHECK_MEMBER(falloff);
        CHECK_MEMBER(core);
#undef CHECK_MEMBER
    }
}

#ifdef FETTLE_PHYSICS_DOUBLE
TEST_CASE("the level of a liquid has in C the precision of a position") {
    World in;
    fettle_field_def def;
    REQUIRE(fettle_field_def_init(&def, sizeof def, FETTLE_FIELD_BUOYANCY) == FETTLE_DONE);
    def.level = 1e7 + 0.25;
    fettle_id id = 0;
    REQUIRE(fettle_world_create_field(in.world, &def, &id) == FETTLE_DONE);
    REQUIRE(fettle_field_definition(in.world, id, &def) == FETTLE_DONE);
    CHECK(def.level == 1e7 + 0.25);
}
#endif

}  // namespace definitions_test
