#include <fettle/physics/definitions.h>
#include <fettle_physics.h>

#include <cstring>

#include "catch.h"
#include "header_text.h"

namespace definitions_test {

// Each value of a definition in C comes into the object.

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

bool same(float a, float b) {
    return a == b;
}
bool same(fettle_vec2 a, fettle_vec2 b) {
    return a.x == b.x && a.y == b.y;
}
#ifdef FETTLE_PHYSICS_DOUBLE
bool same(fettle_position a, fettle_position b) {
    return a.x == b.x && a.y == b.y;
}
#endif

/// The number of members of a structure in C. A test compares it with the number that it checks, so
/// that no new member is forgotten.
size_t members_in(const std::string& structure) {
    const std::string& text = header_text::in_c();
    const size_t at = text.find("typedef struct fettle_" + structure + " {");
    const std::string body = text.substr(at, text.find("\n}", at) - at);
    return size_t(std::count(body.begin(), body.end(), ';'));
}

#define CHECK_READ(object, Type, name)                                         \
    {                                                                          \
        INFO(#name);                                                           \
        Type read = {};                                                        \
        REQUIRE(fettle_##object##_##name(in.world, id, &read) == FETTLE_DONE); \
        CHECK(same(read, def.name));                                           \
    }

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
    CHECK_READ(body, int32_t, type)
    CHECK_READ(body, fettle_position, position)
    CHECK_READ(body, fettle_vec2, velocity)
    CHECK_READ(body, fettle_vec2, force)
    CHECK_READ(body, fettle_vec2, center)
    CHECK_READ(body, float, angle)
    CHECK_READ(body, float, angular_velocity)
    CHECK_READ(body, float, torque)
    CHECK_READ(body, float, gravity_scale)
    CHECK_READ(body, float, linear_damping)
    CHECK_READ(body, float, angular_damping)
    CHECK_READ(body, float, sleep_speed)
    CHECK_READ(body, float, max_speed)
    CHECK_READ(body, bool, can_sleep)
    CHECK_READ(body, bool, bullet)
    CHECK_READ(body, bool, locked_x)
    CHECK_READ(body, bool, locked_y)
    CHECK_READ(body, bool, locked_rotation)
    CHECK_READ(body, uint64_t, user_data)
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
    CHECK_READ(body, bool, enabled)
    CHECK_READ(body, bool, awake)
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
    CHECK_READ(shape, float, density)
    CHECK_READ(shape, float, friction)
    CHECK_READ(shape, float, restitution)
    CHECK_READ(shape, float, rolling_resistance)
    CHECK_READ(shape, float, surface_speed)
    CHECK_READ(shape, bool, sensor)
    CHECK_READ(shape, bool, hit_events)
    CHECK_READ(shape, bool, contact_events)
    CHECK_READ(shape, bool, sensor_events)
    CHECK_READ(shape, bool, before_solve)
    CHECK_READ(shape, uint32_t, material)
    CHECK_READ(shape, int32_t, group)
    CHECK_READ(shape, uint64_t, category)
    CHECK_READ(shape, uint64_t, mask)
    CHECK_READ(shape, uint64_t, user_data)
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
#define CHECK_SETTING(Type, name)                                  \
    {                                                              \
        INFO(#name);                                               \
        Type read = {};                                            \
        REQUIRE(fettle_world_##name(world, &read) == FETTLE_DONE); \
        CHECK(same(read, def.name));                               \
    }
    CHECK_SETTING(int32_t, substeps)
    CHECK_SETTING(fettle_vec2, gravity)
    CHECK_SETTING(float, bounds_friction)
    CHECK_SETTING(float, bounds_restitution)
    CHECK_SETTING(float, restitution_threshold)
    CHECK_SETTING(float, hit_threshold)
    CHECK_SETTING(float, sleep_speed)
    CHECK_SETTING(float, sleep_delay)
    CHECK_SETTING(float, contact_hertz)
    CHECK_SETTING(float, contact_damping)
    CHECK_SETTING(float, push_speed)
    CHECK_SETTING(float, max_speed)
    CHECK_SETTING(bool, sleeping)
    CHECK_SETTING(bool, continuous)
    CHECK_SETTING(bool, persist_events)
    CHECK_SETTING(int32_t, friction_mix)
    CHECK_SETTING(int32_t, restitution_mix)
    CHECK_SETTING(int32_t, solver)
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
    CHECK_READ(mouse_joint, fettle_position, target)
    CHECK_READ(mouse_joint, float, hertz)
    CHECK_READ(mouse_joint, float, damping_ratio)
    CHECK_READ(mouse_joint, float, max_force)
    CHECK_READ(joint, bool, enabled)
    CHECK_READ(joint, uint64_t, user_data)
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
#define CHECK_MEMBER(name) CHECK(back.name == def.name)
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
