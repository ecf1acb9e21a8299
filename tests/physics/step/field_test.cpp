#include "catch.h"
#include "scenes.h"
#include "thorough.h"

#include <distance/distance.h>

namespace field_test {

using namespace scenes;

namespace {

constexpr float pi = 3.14159265f;

struct Form {
    std::vector<Vec2> vertices, normals;
    std::vector<float> offsets;
    float radius;

    explicit Form(std::vector<Vec2> v, float r = 0.0f) : vertices(std::move(v)), radius(r) {
        for (size_t i = 0; i < vertices.size() && vertices.size() > 1; ++i) {
            const Vec2 d = vertices[(i + 1) % vertices.size()] - vertices[i];
            normals.push_back(detail::normalized(detail::right_perp(d)));
            offsets.push_back(normals.back().dot(vertices[i]));
        }
        normals.resize(vertices.size());
        offsets.resize(vertices.size());
    }
    detail::Convex convex() const {
        return {vertices.data(), normals.data(), offsets.data(), int(vertices.size()), radius};
    }
    bool holds(Vec2 p) const {
        float nearest = 1e9f;
        bool inside = vertices.size() > 2;
        for (size_t i = 0; i < vertices.size(); ++i) {
            const Vec2 a = vertices[i], d = vertices[(i + 1) % vertices.size()] - a;
            const float l = d.length_squared();
            const float t = l > 0 ? detail::clamp((p - a).dot(d) / l, 0, 1) : 0;
            nearest = std::min(nearest, (p - (a + t * d)).length());
            inside &= normals[i].dot(p) <= offsets[i];
        }
        return inside || nearest <= radius;
    }
};

/// The same by counting small squares.
detail::AreaPart counted(const Form& form, Vec2 normal, float depth) {
    detail::AreaPart part;
    double x = 0, y = 0;
    const float cell = thorough() ? 0.01f : 0.02f;
    for (float px = -3; px < 3; px += cell) {
        for (float py = -3; py < 3; py += cell) {
            const Vec2 p = {px + cell / 2, py + cell / 2};
            if (normal.dot(p) >= depth || !form.holds(p)) continue;
            part.area += double(cell * cell);
            x += double(p.x * cell * cell);
            y += double(p.y * cell * cell);
        }
    }
    if (part.area > 0) part.centroid = {float(x / part.area), float(y / part.area)};
    return part;
}

}  // namespace

TEST_CASE("the submerged part of any shape has the area and centroid that counting finds") {
    const std::vector<Form> forms = {
        Form({{0.3f, -0.2f}}, 0.9f),
        Form({{-1, 0.2f}, {1, -0.3f}}, 0.5f),
        Form({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}),
        Form({{-1, -0.5f}, {1.2f, -0.7f}, {0.2f, 1.1f}}, 0.4f),
    };
    for (const Form& form : forms) {
        for (const float depth : {-1.2f, -0.4f, 0.0f, 0.3f, 1.0f, 2.5f}) {
            for (const float turn : {0.0f, 0.7f, 2.5f, -1.9f}) {
                const Vec2 normal = {std::sin(turn), std::cos(turn)};
                const detail::AreaPart exact = part_below(form.convex(), normal, double(depth));
                const detail::AreaPart expected = counted(form, normal, depth);
                INFO(form.vertices.size() << " " << depth << " " << turn);
                REQUIRE(exact.area == Approx(expected.area).margin(0.03));
                if (expected.area < 0.1) continue;
                REQUIRE(exact.centroid.x == Approx(expected.centroid.x).margin(0.02));
                REQUIRE(exact.centroid.y == Approx(expected.centroid.y).margin(0.02));
            }
        }
    }
    // Exact where the whole is known.
    REQUIRE(part_below(forms[0].convex(), {0, 1}, 9).area == Approx(pi * 0.81f).epsilon(1e-5));
    REQUIRE(part_below(forms[0].convex(), {0, 1}, -0.2).area == Approx(pi * 0.405f).epsilon(1e-5));
}

TEST_CASE("a box of half the density of water floats half under it and level") {
    World world;
    world.create_field({.force = BuoyancyField{.level = 3.0f, .density = 2.0f}});
    Body box = world.create_body({.position = {0, 4}, .angle = 0.3f});
    box.add(Box{.width = 2, .height = 1});
    Body ball = add_ball(world, {5, 2});
    run(world, 20.0f);
    REQUIRE(box.position().y == Approx(3.0f).margin(0.01));
    REQUIRE(std::fabs(box.angle()) < 0.02f);
    REQUIRE(ball.position().y == Approx(3.0f).margin(0.01));
    REQUIRE_FALSE(box.awake());
    ball.shapes()[0].set_density(3.0f);
    run(world, 3.0f);
    REQUIRE(ball.position().y < 0.0f);
}

TEST_CASE("every property of a field has an effect at once and wakes sleeping bodies") {
    World world;
    Field water = world.create_field({.force = BuoyancyField{.level = 3.0f}});
    Body box = add_box(world, {0, 3});
    run(world, 10.0f);
    REQUIRE_FALSE(box.awake());
    FieldDef def = water.definition();
    std::get<BuoyancyField>(def.force).level = 5.0f;
    water.set(def);
    REQUIRE(box.awake());
    run(world, 10.0f);
    REQUIRE(box.position().y == Approx(5.0f).margin(0.02));
    def.region = Aabb{{10, -100}, {20, 100}};
    water.set(def);
    run(world, 1.0f);
    REQUIRE(box.position().y < 2.0f);
    def.region.reset();
    def.mask = 2;
    water.set(def);
    box.set_position({0, 0});
    box.set_velocity({0, 0});
    run(world, 0.5f);
    REQUIRE(box.velocity().y == Approx(-5.0f).epsilon(0.01));
    box.shapes()[0].set_category(3);
    run(world, 10.0f);
    REQUIRE(box.position().y == Approx(5.0f).margin(0.05));
    def.enabled = false;
    water.set(def);
    run(world, 1.0f);
    REQUIRE(box.position().y < 1.0f);
    water.destroy();
    REQUIRE_FALSE(water.is_valid());
    REQUIRE_THROWS_WITH(water.definition(), contains("field"));
    REQUIRE_THROWS_WITH(world.create_field({.force = BuoyancyField{.normal = {0, 0}}}),
                        contains("normal"));
}

TEST_CASE("wind presses on a plate by its area and the square of the speed") {
    World world({.gravity = {0, 0}});
    Body plate = world.create_body({});
    plate.add(Box{.width = 0.1f, .height = 4});
    plate.set_mass(1e6f);  // it hardly moves
    world.create_field({.force = WindField{.velocity = {6, 0}, .density = 1.5f}});
    world.step(frame);
    // ½ · 1.5 · 36 · 4 m = 108 N
    REQUIRE(plate.velocity().x * 1e6f / frame == Approx(108.0f).epsilon(0.01));
    plate.set_velocity({0, 0});
    plate.set_angle(pi / 2);  // edge on
    world.step(frame);
    REQUIRE(plate.velocity().x * 1e6f / frame == Approx(2.7f).epsilon(0.02));
    Body ball = add_ball(world, {10, 0}, 0.5f);
    run(world, 60.0f);
    REQUIRE(ball.velocity().x == Approx(6.0f).epsilon(0.1));
    REQUIRE(ball.velocity().x < 6.0f);
}

TEST_CASE("drag slows exponentially and quadratic drag to a terminal speed") {
    World world({.gravity = {0, 0}});
    Field air = world.create_field({.force = DragField{.linear = 0.5f}});
    Body box = add_box(world, {0, 0});
    box.set_velocity({4, 0});
    box.set_angular_velocity(3.0f);
    run(world, 2.0f);
    REQUIRE(box.velocity().x == Approx(4 * std::exp(-1.0f)).epsilon(0.01));
    REQUIRE(box.angular_velocity() == Approx(3 * std::exp(-1.0f)).epsilon(0.01));
    air.set({.force = DragField{.linear = 0.0f, .quadratic = 0.1f}});
    world.set_gravity({0, -10});
    run(world, 20.0f);
    REQUIRE(box.velocity().y == Approx(-10.0f).epsilon(0.01));  // 0.1 v² = 10 N
    // However thick, it does not explode.
    air.set({.force = DragField{.flow = {2, 0}, .linear = 1e6f, .quadratic = 1e6f}});
    run(world, 2.0f);
    REQUIRE((box.velocity() - Vec2(2, 0)).length() < 0.5f);
}

namespace {

/// A body of several shapes off its position, which moves and turns relative to what flows around
/// it, without gravity. Its greatest energy in later steps, in shares of the energy before.
float greatest_energy(const FieldDef& field, Vec2 flow) {
    World world({.gravity = {0, 0}});
    world.create_field(field);
    Body body = world.create_body(
        {.position = {0, -300}, .velocity = flow + Vec2(90, 50), .angular_velocity = 30});
    body.add(Box{.width = 4, .height = 0.2f, .center = {3, 1}});
    body.add(Circle{.radius = 0.3f});
    body.add(Ellipse{});
    const auto energy = [&] {
        const float spin = body.angular_velocity();
        return body.mass() * (body.velocity() - flow).length_squared() +
               body.inertia() * spin * spin;
    };
    const float before = energy();
    float greatest = 0.0f;
    for (int i = 0; i < 60; ++i) {
        world.step(frame);
        greatest = std::max(greatest, energy() / before);
    }
    return greatest;
}

}  // namespace

TEST_CASE("no resistance of a field gives a body energy however strong it is") {
    const Vec2 flow = {2, 1};
    for (const float strength : {0.1f, 2.0f, 50.0f, 1e3f, 1e6f, 1e20f, 1e30f}) {
        INFO("strength " << strength);
        CHECK(greatest_energy({.force = BuoyancyField{.drag = strength, .flow = flow}}, flow) <= 1);
        CHECK(greatest_energy({.force = BuoyancyField{.density = strength, .flow = flow}}, flow) <=
              1);
        CHECK(greatest_energy({.force = DragField{.flow = flow, .linear = strength}}, flow) <= 1);
        CHECK(greatest_energy({.force = DragField{.flow = flow, .quadratic = strength}}, flow) <=
              1);
        CHECK(greatest_energy({.force = WindField{.velocity = flow, .density = strength}}, flow) <=
              1);
    }
}

TEST_CASE("a light body rises through a liquid with the speed at which drag holds lift") {
    for (const float drag : {2.0f, 10.0f, 50.0f})
        for (const float density : {10.0f, 100.0f, 1000.0f}) {
            World world;
            world.create_field({.force = BuoyancyField{.density = density, .drag = drag}});
            Body box = add_box(world, {0, -3});
            float fastest = 0.0f;
            for (int i = 0; i < 600; ++i) {
                world.step(frame);
                fastest = std::max(fastest, box.velocity().length());
            }
            INFO("density " << density << ", drag " << drag);
            CHECK(fastest <= 10.0f / drag);
        }
}

TEST_CASE("a body that floats without drag swings for a minute and gains no height") {
    for (const float density : {1.5f, 2.0f, 5.0f})
        for (const float angle : {0.0f, 0.7f})
            for (int kind = 0; kind < 3; ++kind) {
                World world;
                world.create_field({.force = BuoyancyField{.density = density, .drag = 0}});
                Body body = world.create_body({.position = {0, -3}, .angle = angle});
                if (kind == 0) body.add(Box{});
                if (kind == 1) body.add(Circle{});
                if (kind == 2) body.add(Segment{{-0.5f, 0}, {0.5f, 0}, 0.2f});
                float lowest = 0.0f, highest = 0.0f;
                for (int i = 0; i < 3600; ++i) {
                    world.step(frame);
                    lowest = std::min(lowest, float(body.position().y));
                    highest = std::max(highest, float(body.position().y));
                }
                INFO("density " << density << ", kind " << kind << ", angle " << angle);
                CHECK(lowest > -3.03f);
                CHECK(highest < 3.03f * (density - 1));
                CHECK(highest > 2.9f * (density - 1));
            }
}

TEST_CASE("a planet circles an attractor in the time of its orbit") {
    World world({.gravity = {0, 0}, .substeps = 8});
    world.create_field({.force = AttractorField{.center = {1, 2}, .strength = 16.0f}});
    Body planet = add_ball(world, {5, 2}, 0.2f);
    planet.set_velocity({0, 2});  // v² = strength / r
    float farthest = 4.0f, nearest = 4.0f;
    const float period = 2 * pi * 4.0f / 2.0f;
    for (int i = 0; i < int(period * 60); ++i) {
        world.step(frame);
        farthest = std::max(farthest, (planet.position() - Position(1, 2)).length());
        nearest = std::min(nearest, (planet.position() - Position(1, 2)).length());
    }
    REQUIRE(farthest < 4.1f);
    REQUIRE(nearest > 3.9f);
    REQUIRE((planet.position() - Position(5, 2)).length() < 0.3f);
}

TEST_CASE("orbits keep their radius for a minute at any length of the steps") {
    for (const int substeps : {1, 2, 4, 8}) {
        for (const float dt : {1.0f / 30, 1.0f / 60, 1.0f / 144}) {
            World world({.gravity = {0, 0}, .substeps = substeps});
            world.create_field({.force = AttractorField{.center = {1, 2}, .strength = 50.0f}});
            Body planet = add_ball(world, {5, 2}, 0.2f);
            planet.set_velocity({0, std::sqrt(50.0f / 4.0f)});
            float farthest = 4.0f, nearest = 4.0f;
            for (int i = 0; i < int(60 / dt); ++i) {
                world.step(dt);
                const float radius = (planet.position() - Position(1, 2)).length();
                farthest = std::max(farthest, radius);
                nearest = std::min(nearest, radius);
            }
            INFO(substeps << " sub-steps, " << dt << " s");
            CHECK(farthest < 4.0f * 1.03f);
            CHECK(nearest > 4.0f * 0.97f);
        }
    }
}

TEST_CASE("a comet keeps its orbit round an attractor with every solver") {
    // It starts at its greatest distance, with this share of the kinetic energy of a circle, and
    // comes as near as 0.5 m, or 1.1 m with slower steps.
    struct Comet {
        float share, hertz;
        int substeps;
    };
    for (const Solver solver : {Solver::soft_step, Solver::sequential, Solver::direct})
        for (const auto& [share, hertz, substeps] :
             {Comet{0.1f, 60, 4}, Comet{0.2f, 20, 4}, Comet{0.2f, 30, 16}}) {
            World world({.gravity = {0, 0}, .substeps = substeps, .solver = solver});
            world.create_field({.force = AttractorField{.strength = 1000.0f}});
            Body comet = add_ball(world, {10, 0}, 0.3f);
            comet.set_velocity({0, std::sqrt(100.0f * share)});
            float farthest = 0.0f, least = 100.0f;
            bool falls = true;
            float last = 10.0f;
            for (int i = 0; i < int(60 * hertz); ++i) {
                world.step(1 / hertz);
                const float now = Vec2(comet.position()).length();
                if (falls && now > last) falls = false;
                if (!falls && now < last) {  // at its greatest distance
                    falls = true;
                    farthest = std::max(farthest, last);
                    least = std::min(least, last);
                }
                last = now;
            }
            INFO("share " << share << ", " << hertz << " Hz, " << substeps << " sub-steps, solver "
                          << int(solver));
            CHECK(farthest < 10.3f);
            CHECK(least > 9.5f);
        }
}

TEST_CASE("the account of a body contains the pull of an attractor in each sub-step") {
    World world({.gravity = {0, 0}});
    world.create_field({.force = AttractorField{.strength = 1000.0f}});
    Body comet = add_ball(world, {2, 0}, 0.3f);
    comet.set_velocity({-10, 20});
    world.keep_account(comet.id());
    for (int i = 0; i < 20; ++i) {
        const Vec2 before = comet.velocity();
        world.step(frame);
        const auto account = world.account(comet.id());
        REQUIRE(account);
        const Vec2 change = comet.velocity() - before;
        CHECK((account->fields - change).length() < 1e-3f * (1 + change.length()));
    }
}

TEST_CASE("an explosion pushes only bodies in its radius and the nearer ones more") {
    World world({.gravity = {0, 0}});
    Body near = add_ball(world, {1.5f, 0}), far = add_ball(world, {0, 5.5f});
    Body inside = add_ball(world, {0.1f, -0.1f}, 0.4f),
         wall = world.create_body({.type = BodyType::static_body, .position = {-3, 0}});
    wall.add(Box{});
    world.explode({0, 0}, 4.0f, 8.0f);
    REQUIRE(near.velocity().x == Approx(8.0f * 0.75f / near.mass()).epsilon(1e-3));
    REQUIRE(far.velocity().length() == 0.0f);
    REQUIRE(inside.velocity().length() * inside.mass() == Approx(8.0f).epsilon(1e-3));
    world.explode({1.5f, 3}, 4.0f, 8.0f, {.mask = 2});
    REQUIRE(near.velocity().y == 0.0f);
    REQUIRE_THROWS_WITH(world.explode({0, 0}, -1.0f, 1.0f), contains("radius"));
}

}  // namespace field_test
