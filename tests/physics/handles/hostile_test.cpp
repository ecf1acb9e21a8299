#include <fettle/physics/host_access.h>
#include <cmath>
#include <limits>
#include <random>

#include "catch.h"
#include "scenes.h"
#include "thorough.h"

namespace hostile_test {

using namespace scenes;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

}  // namespace

TEST_CASE("invalid values are refused by name and change nothing") {
    World world;
    Body body = add_box(world, {1, 2});
    Shape shape = body.shapes()[0];
    REQUIRE_THROWS_WITH(body.set_position({not_a_number, 0}), contains("position"));
    REQUIRE_THROWS_WITH(body.set_position({infinity, 0}), contains("position"));
    REQUIRE_THROWS_WITH(body.set_angle(not_a_number), contains("angle"));
    REQUIRE_THROWS_WITH(body.set_velocity({0, not_a_number}), contains("velocity"));
    REQUIRE_THROWS_WITH(body.set_linear_damping(-1), contains("linear_damping = -1"));
    REQUIRE_THROWS_WITH(body.set_mass(0.0f), contains("mass"));
    REQUIRE_THROWS_WITH(body.set_mass(not_a_number), contains("mass"));
    REQUIRE_THROWS_WITH(body.set_inertia(-2.0f), contains("inertia"));
    REQUIRE_THROWS_WITH(body.set_force({not_a_number, not_a_number}), contains("force"));
    REQUIRE_THROWS_WITH(shape.set_width(0), contains("width"));
    REQUIRE_THROWS_WITH(shape.set_rounding(-2), contains("rounding"));
    REQUIRE_THROWS_WITH(shape.set_friction(-1), contains("friction"));
    REQUIRE_THROWS_WITH(shape.set_restitution(1.5f), contains("restitution"));
    REQUIRE_THROWS_WITH(shape.set_density(infinity), contains("density"));
    REQUIRE_THROWS_WITH(shape.set_radius(1), contains("a box has no such property"));
    REQUIRE_THROWS_WITH(world.set_gravity({0, not_a_number}), contains("gravity"));
    REQUIRE_THROWS_WITH(world.set_substeps(0), contains("substeps"));
    REQUIRE_THROWS_WITH(world.set_bounds(Aabb{{1, 0}, {0, 1}}), contains("bounds"));
    REQUIRE_THROWS_WITH(world.create_field({.region = Aabb{{1, 1}, {0, 0}}}), contains("region"));
    REQUIRE_THROWS_WITH(world.create_body({.linear_damping = not_a_number}),
                        contains("linear_damping"));
    REQUIRE_THROWS_WITH(body.add(Circle{.radius = -1}), contains("radius"));
    REQUIRE_THROWS_WITH(body.add(Polygon{.vertices = {{0, 0}, {1, 1}, {2, 2}}}),
                        contains("one line"));
    REQUIRE(body.position() == Vec2(1, 2));
    REQUIRE(body.mass() == Approx(1.0f));
    REQUIRE(body.shape_count() == 1);
    REQUIRE(world.body_count() == 1);
    REQUIRE(world.shape_count() == 1);
}

TEST_CASE("vertices on a line are refused and the polygon stays as it was") {
    World world;
    Body body = world.create_body();
    Shape shape = body.add(Polygon{.vertices = {{0, 0}, {1, 0}, {0, 1}}});
    const std::vector<Vec2> line = {{0, 0}, {1, 1}, {2, 2}};
    REQUIRE(shape.try_set_vertices(line) == HullStatus::collinear);
    REQUIRE_THROWS_WITH(shape.set_vertices(line), contains("one line"));
    REQUIRE(shape.vertices().size() == 3);
    REQUIRE(shape.area() == Approx(0.5f));
}

TEST_CASE("a handle to a destroyed object does not refer to its successor") {
    World world;
    Body a = add_box(world, {0, 0});
    Shape shape = a.shapes()[0];
    a.destroy();
    Body b = add_box(world, {5, 5});
    REQUIRE(b.index() == a.index());
    REQUIRE_FALSE(a.is_valid());
    REQUIRE_FALSE(shape.is_valid());
    REQUIRE_THROWS_WITH(a.position(), contains("was destroyed, or is of another world"));
    REQUIRE_THROWS(a.destroy());
    REQUIRE_THROWS(shape.attach(b));
    REQUIRE_THROWS_WITH(Body().position(), contains("names no body"));
    REQUIRE(b.position() == Vec2(5, 5));
}

TEST_CASE("a step of no or negative or unbounded time does nothing") {
    World world;
    Body ball = add_ball(world, {0, 5});
    for (float dt : {0.0f, -1.0f, not_a_number, infinity}) world.step(dt);
    REQUIRE(ball.position() == Vec2(0, 5));
    world.step(1e6f);
    world.step(1e-30f);
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("extreme but finite values never make the state anything but finite") {
    World world({.bounds = Aabb{{-50, -50}, {50, 50}}});
    add_floor(world);
    const std::vector<float> extremes = {1e-30f, 1e-6f, 1e6f, 1e20f, 3e38f, -3e38f};
    std::vector<Body> bodies;
    for (size_t i = 0; i < extremes.size(); ++i) {
        for (size_t k = 0; k < extremes.size(); ++k) {
            Body body = add_box(world, {float(i) * 2, 1 + float(k) * 2});
            body.set_velocity({extremes[i], extremes[k]});
            body.set_angular_velocity(extremes[k]);
            body.set_force({extremes[k], extremes[i]});
            body.set_torque(extremes[i]);
            body.set_gravity_scale(extremes[k]);
            body.shapes()[0].set_density(std::fabs(extremes[i]));
            body.shapes()[0].set_friction(std::fabs(extremes[k]));
            body.set_linear_damping(std::fabs(extremes[k]));
            body.apply_impulse({extremes[i], extremes[i]}, {extremes[k], 0});
            bodies.push_back(body);
        }
    }
    world.set_gravity({3e38f, -3e38f});
    for (int i = 0; i < 100; ++i) {
        world.step(frame);
        const auto fault = world.validate();
        INFO(fault.value_or(""));
        REQUIRE_FALSE(fault);
    }
}

TEST_CASE("shapes of extreme sizes meet without harm") {
    World world;
    Body giant = world.create_body({.position = {0, -1e6f}});
    giant.add(Circle{.radius = 999999.0f}, {.density = 1e-3f});
    Body speck = world.create_body({.position = {0, 5}});
    speck.add(Circle{.radius = 1e-5f}, {.density = 1e9f});
    Body sliver = world.create_body({.position = {1, 5}});
    sliver.add(Box{.width = 1e6f, .height = 1e-5f});
    Body far = world.create_body({.position = {1e8f, -1e8f}});
    far.add(Box{});
    for (int i = 0; i < 60; ++i) world.step(frame);
    const auto fault = world.validate();
    INFO(fault.value_or(""));
    REQUIRE_FALSE(fault);
}

TEST_CASE("many bodies in the very same place move apart without harm") {
    World world;
    add_floor(world);
    for (int i = 0; i < 30; ++i) {
        if (i % 2 == 0)
            add_ball(world, {0, 1});
        else
            add_box(world, {0, 1});
    }
    run(world, 3.0f);
    REQUIRE_FALSE(world.validate());
}

namespace {

void create_any_joint(World& world, const JointDef& def, std::mt19937& random) {
    switch (random() % 11) {
        case 0:
            world.create_distance_joint(def);
            break;
        case 1:
            world.create_revolute_joint(def).set_max_motor_torque(infinity);
            break;
        case 2:
            world.create_prismatic_joint(def).set_upper_translation(1.0f);
            break;
        case 3:
            world.create_wheel_joint(def).set_max_motor_torque(10.0f);
            break;
        case 4:
            world.create_weld_joint(def).set_break_torque(50.0f);
            break;
        case 5:
            world.create_motor_joint(def).set_max_force(100.0f);
            break;
        case 6:
            world.create_pulley_joint(def).set_ratio(2.0f);
            break;
        case 7:
            world.create_gear_joint(def).set_ratio(-3.0f);
            break;
        case 8:
            world.create_groove_joint(def).set_end({1, 1});
            break;
        case 9:
            world.create_pin_slot_joint(def).set_hertz(5.0f);
            break;
        default:
            world.create_ratchet_joint(def).set_tooth(0.3f);
            break;
    }
}

}  // namespace

TEST_CASE("the world stays consistent while bodies and shapes are destroyed in random sequences") {
    std::mt19937 random(11);
    auto pick = [&](auto& list) { return list[size_t(random()) % list.size()]; };
    World world({.bounds = Aabb{{-8, 0}, {8, 30}}});
    add_floor(world, 5.0f);
    for (int i = 0; i < (thorough() ? 1500 : 500); ++i) {
        auto bodies = world.bodies();
        auto shapes = world.shapes();
        const float x = float(random() % 1000) / 100.0f - 5.0f,
                    y = float(random() % 1000) / 100.0f + 1.0f;
        switch (random() % 21) {
            case 0:
            case 1:
            case 2:
                add_box(world, {x, y}, 0.5f + float(random() % 10) * 0.1f);
                break;
            case 3:
            case 4:
                add_ball(world, {x, y}, 0.3f, {.restitution = 0.5f, .hit_events = true});
                break;
            case 5:
                if (bodies.size() > 25) pick(bodies).destroy();
                break;
            case 6:
                if (shapes.size() > 20) pick(shapes).destroy();
                break;
            case 7:
                if (!shapes.empty()) pick(shapes).detach();
                break;
            case 8:
                if (!shapes.empty() && !bodies.empty()) pick(shapes).attach(pick(bodies));
                break;
            case 9:
                if (!bodies.empty()) pick(bodies).set_type(BodyType(random() % 3));
                break;
            case 10:
                if (!bodies.empty()) pick(bodies).set_position({x, y});
                break;
            case 11:
                if (!shapes.empty()) pick(shapes).set_sensor(random() % 2 == 0);
                break;
            case 12:
                if (!shapes.empty()) pick(shapes).set_mask(random() % 2 == 0 ? ~0ull : 0);
                break;
            case 13:
                if (!bodies.empty()) pick(bodies).set_awake(random() % 2 == 0);
                break;
            case 14:
                if (!bodies.empty()) {
                    pick(bodies).set_mass(random() % 2 == 0 ? std::optional<float>(infinity)
                                                            : std::nullopt);
                }
                break;
            case 15:
                if (!shapes.empty()) {
                    pick(shapes).set_geometry(
                        Polygon{.vertices = {{-0.5f, 0}, {0.5f, -0.3f}, {x * 0.1f, 0.8f}}});
                }
                break;
            case 16:
                if (!bodies.empty())
                    world.create_mouse_joint({.body = pick(bodies).id(), .target = {x, y}});
                break;
            case 17: {
                auto joints = world.joints();
                if (!joints.empty()) pick(joints).destroy();
                break;
            }
            case 18:
            case 19: {
                if (bodies.size() < 2) break;
                JointDef def = {.body_a = pick(bodies).id(), .body_b = pick(bodies).id()};
                def.collide = random() % 2 == 0;
                def.anchor_a = {x, y};
                if (random() % 4 == 0) def.body_a = {};
                if (def.body_a == def.body_b) break;
                create_any_joint(world, def, random);
                break;
            }
            case 20: {
                auto joints = world.joints();
                if (joints.empty()) break;
                Joint joint = pick(joints);
                if (random() % 2 == 0) joint.set_enabled(!joint.enabled());
                if (random() % 4 == 0) joint.set_broken(!joint.broken());
                joint.set_break_force(random() % 2 == 0 ? infinity : 100.0f);
                joint.set_collide(!joint.collide());
                if (joint.type() == JointType::distance) {
                    DistanceJoint distance = world.joint<DistanceJoint>(joint.id());
                    distance.set_hertz(random() % 2 == 0 ? 0.0f : 30.0f);
                    distance.set_max_length(std::fabs(x));
                }
                break;
            }
        }
        for (uint32_t n = random() % 4; n > 0; --n) world.step(frame);
        const auto fault = world.validate();
        INFO("after edit " << i << ": " << fault.value_or(""));
        REQUIRE_FALSE(fault);
    }
    world.clear();
    REQUIRE(world.body_count() == 0);
    REQUIRE(world.shape_count() == 0);
    REQUIRE(world.joint_count() == 0);
    REQUIRE_FALSE(world.validate());
    world.step(frame);
}

TEST_CASE("a shape in the slot of one just destroyed has one contact with the border") {
    World world({.bounds = Aabb{{-5, 0}, {5, 10}}});
    Body first = add_box(world, {0, 0.5f});
    world.step(frame);
    const uint32_t slot = first.index();
    first.set_position({1, 0.5f});  // listed as moved, and gone before the step
    first.destroy();
    REQUIRE(add_box(world, {-1, 0.5f}).index() == slot);
    world.step(frame);
    const auto fault = world.validate();
    INFO(fault.value_or(""));
    REQUIRE_FALSE(fault);
    REQUIRE(world.contacts().size() == 1);
}

TEST_CASE("a fast body is swept against an ellipse that stands still") {
    World world({.gravity = {0, 0}});
    Body egg = world.create_body({.type = BodyType::static_body});
    egg.add(Ellipse{.radius_x = 0.2f, .radius_y = 5.0f});
    Body ball = add_ball(world, {-6.1f, 0}, 0.1f);
    ball.set_velocity({200, 0});
    run(world, 0.2f);
    REQUIRE(ball.position().x < 0.0f);
}

TEST_CASE("a joint whose impulses overflow has finite forces and works again") {
    for (const Solver solver : {Solver::soft_step, Solver::sequential, Solver::direct}) {
        World world({.gravity = {3e38f, -3e38f}, .solver = solver});
        Body heavy = add_box(world, {0, 0}), light = add_box(world, {3, 0});
        heavy.set_mass(3e38f);
        light.set_mass(1e-30f);
        PrismaticJoint joint = world.create_prismatic_joint(
            {.body_a = heavy.id(), .body_b = light.id(), .anchor_b = {3e7f, 1e7f}});
        joint.set_hertz(1e20f);
        for (int i = 0; i < 20; ++i) {
            world.step(frame);
            INFO("solver " << int(solver) << ", step " << i);
            REQUIRE(joint.force().is_finite());
            REQUIRE(std::isfinite(joint.torque()));
            REQUIRE_FALSE(world.validate());
        }
    }
}

TEST_CASE("the new values of a list may be a part of the old list") {
    World world;
    Body body = world.create_body();
    Shape chain = body.add(Chain{{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}, {-1, 2}}});
    chain.set_vertices(chain.vertices().subspan(1));
    REQUIRE(chain.vertices().size() == 5);
    CHECK(chain.vertices().front() == Vec2(4, 0));
    chain.set_vertices(chain.vertices().subspan(1));
    CHECK(chain.vertices().front() == Vec2(4, 4));
    Shape other = body.add(Chain{{{9, 9}, {8, 8}, {7, 9}}});
    other.set_vertices(chain.vertices());
    CHECK(other.vertices().front() == Vec2(4, 4));
    Field field = world.create_field({.force = AttractorField{{1, 2}, 3, 2, 0.5f}});
    for (int i = 0; i < 20; ++i) field = world.create_field(field.definition());
    CHECK(std::get<AttractorField>(field.definition().force).center == Vec2(1, 2));
}

TEST_CASE("reading a shape may compute the parts of other shapes") {
    // The parts of a polygon are made by the first read, which moves the records of all shapes.
    World world;
    Body body = world.create_body({.position = {1, 0}});
    Shape box = body.add(Box{});
    std::vector<Vec2> star;
    for (int i = 0; i < 200; ++i) {
        const float angle = 6.2831853f * float(i) / 200.0f, r = i % 2 ? 1.0f : 0.5f;
        star.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
    for (int i = 0; i < 6; ++i) {
        body.add(Concave{star});
        CHECK(box.contains({1.2f, 0.3f}));
        Shape other = body.add(Concave{star});
        HostAccess::on_refresh(world, [&](const Refresh&) { CHECK(other.area() > 0.0f); });
        box.set_width(1.0f + float(i));
        REQUIRE(box.vertices().size() == 4);
        CHECK(box.vertices()[1].x == Approx(0.5f + 0.5f * float(i)));
        HostAccess::on_refresh(world, {});
    }
    CHECK_FALSE(world.validate());
}

TEST_CASE("a query reports that a refresh callback has destroyed its other world") {
    for (const bool queried : {true, false})
        for (int which = 0; which < 3; ++which) {
            auto first = std::make_unique<World>(), second = std::make_unique<World>();
            Shape circle = first->create_body().add(Circle{});
            Shape box = second->create_body().add(Box{});
            first->step(1 / 60.0f);
            second->step(1 / 60.0f);
            circle.set_radius(2);
            box.set_width(3);
            HostAccess::on_refresh(*(queried ? second : first),
                                   [&](const Refresh&) { (queried ? first : second).reset(); });
            World* const asked = first.get();
            const auto query = [&] {
                if (which == 0)
                    (void)asked->query_overlap(box);
                else if (which == 1)
                    (void)asked->cast_shape(box, Vec2(1, 0));
                else
                    (void)distance(circle, box);
            };
            INFO(queried << which);
            CHECK_THROWS_AS(query(), Locked);
        }
}

TEST_CASE(
    "values that follow from the points of an outline are read at once after the points are set") {
    World world;
    Body body = world.create_body({.position = {1, 0}});
    Shape chain = body.add(Chain{{{0, 0}, {1, 0}, {1, 1}}});
    Shape concave = body.add(Concave{{{0, 0}, {1, 0}, {1, 1}}});
    for (int points = 4; points < 200; points += 30) {
        std::vector<Vec2> line, star;
        for (int i = 0; i < points; ++i) {
            line.emplace_back(float(i), float(i % 2));
            const float angle = 6.2831853f * float(i) / float(points), r = i % 2 ? 1.0f : 0.5f;
            star.emplace_back(r * std::cos(angle), r * std::sin(angle));
        }
        double area = 0.0;
        for (int i = 0; i < points; ++i) {
            const Vec2 a = star[size_t(i)], b = star[size_t((i + 1) % points)];
            area += 0.5 * double(a.x * b.y - a.y * b.x);
        }
        chain.set_vertices(line);
        CHECK(chain.world_vertices().size() == line.size());
        CHECK(chain.world_vertices().back().x == Approx(line.back().x + 1));
        chain.set_vertices(line);
        CHECK(chain.area() == 0.0f);
        concave.set_vertices(star);
        CHECK(concave.area() == Approx(area).epsilon(1e-4));
        concave.set_vertices(star);
        CHECK(concave.mass() == Approx(area).epsilon(1e-4));
        concave.set_vertices(star);
        CHECK(concave.world_vertices().size() == star.size());
        concave.set_vertices(star);
        CHECK(concave.world_center().x == Approx(1).margin(0.3));
    }
}

}  // namespace hostile_test
