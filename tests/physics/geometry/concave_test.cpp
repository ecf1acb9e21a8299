#include <fettle/physics/geometry.h>

#include <algorithm>
#include <random>

#include "catch.h"
#include "scenes.h"
#include "thorough.h"

namespace concave_test {

using namespace scenes;

namespace {

const std::vector<Vec2> u_form = {{-1, -1},      {1, -1},        {1, 1},     {0.6f, 1},
                                  {0.6f, -0.6f}, {-0.6f, -0.6f}, {-0.6f, 1}, {-1, 1}};

std::vector<Vec2> star(int points, float outer, float inner) {
    std::vector<Vec2> v;
    for (int i = 0; i < 2 * points; ++i) {
        const float a = 3.14159265f * float(i) / float(points), r = i % 2 ? inner : outer;
        v.push_back({r * std::cos(a), r * std::sin(a)});
    }
    return v;
}

double area_of(const std::vector<Vec2>& v) {
    double twice = 0;
    for (size_t i = 0; i < v.size(); ++i) {
        const Vec2 &a = v[i], &b = v[(i + 1) % v.size()];
        twice += double(a.x) * b.y - double(a.y) * b.x;
    }
    return 0.5 * twice;
}

bool is_convex(const std::vector<Vec2>& v) {
    for (size_t i = 0; i < v.size(); ++i) {
        const Vec2 a = v[i], b = v[(i + 1) % v.size()], c = v[(i + 2) % v.size()];
        if ((b - a).x * (c - b).y - (b - a).y * (c - b).x < -1e-5f) return false;
    }
    return true;
}

std::string refusal(const std::vector<Vec2>& vertices) {
    World world;
    try {
        world.create_shape(Concave{vertices});
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

bool says(const std::string& text, const std::string& part) {
    INFO(text);
    CHECK(text.find(part) != std::string::npos);
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a concave polygon is cut into few convex pieces that fill it") {
    World world;
    const auto pieces_of = [&](const std::vector<Vec2>& v) {
        Shape shape = world.create_shape(Concave{v});
        double sum = 0;
        for (const auto& piece : shape.pieces()) {
            REQUIRE(is_convex(piece));
            REQUIRE(area_of(piece) > 0);
            sum += area_of(piece);
        }
        REQUIRE(sum == Approx(std::fabs(area_of(v))).epsilon(1e-5));
        REQUIRE(shape.area() == Approx(std::fabs(area_of(v))).epsilon(1e-5));
        return shape.pieces().size();
    };
    REQUIRE(pieces_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}}) == 1);
    REQUIRE(pieces_of({{0, 0}, {0, 1}, {1, 1}, {1, 0}}) == 1);  // clockwise
    REQUIRE(pieces_of({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}) == 2);
    REQUIRE(pieces_of(u_form) == 3);
    REQUIRE(pieces_of(star(5, 1.0f, 0.4f)) <= 6);
    // A comb: each gap has two reflex corners, which one cut can mend at best.
    std::vector<Vec2> comb = {{0, 0}, {20, 0}};
    for (int i = 9; i >= 0; --i) {
        comb.push_back({2.0f * float(i) + 1.5f, 3});
        comb.push_back({2.0f * float(i) + 1.0f, 1});
        if (i > 0) comb.push_back({2.0f * float(i) + 0.5f, 1});
    }
    REQUIRE(pieces_of(comb) <= 20);
    // Random simple polygons, star-shaped about the origin.
    std::mt19937 random(7);
    std::uniform_real_distribution<float> radius(0.2f, 2.0f);
    for (int n : {5, 8, 13, 40, 200}) {
        std::vector<Vec2> v;
        int reflex = 0;
        for (int i = 0; i < n; ++i) {
            const float a = 6.2831853f * float(i) / float(n), r = radius(random);
            v.push_back({r * std::cos(a), r * std::sin(a)});
        }
        for (int i = 0; i < n; ++i) {
            const Vec2 a = v[size_t(i)], b = v[size_t(i + 1) % v.size()],
                       c = v[size_t(i + 2) % v.size()];
            reflex += (b - a).x * (c - b).y - (b - a).y * (c - b).x < 0;
        }
        const size_t pieces = pieces_of(v);
        INFO(n << " vertices, " << reflex << " of them reflex: " << pieces << " pieces");
        CHECK(pieces <= size_t(reflex) * 5 / 4 + 2);
        CHECK(pieces >= size_t(reflex + 1) / 2);
    }
}

TEST_CASE("an outline of thousands of corners is cut in a time that does not grow with its cube") {
    // Two seconds; a search among all corners for each cut takes longer than CTest lets a test run.
    const std::vector<Vec2> outline = star(2500, 2, 1);
    World world;
    const auto pieces = world.create_shape(Concave{outline}).pieces();
    CHECK(pieces.size() < 5000);
    double area = 0;
    for (const auto& piece : pieces) area += area_of(piece);
    CHECK(area == Approx(area_of(outline)).epsilon(1e-3));
}

TEST_CASE("a concave polygon with a long round side is cut into parts of few vertices and rolls") {
    // A disc with a slot as narrow as a hair, 2000 vertices round.
    std::vector<Vec2> disc = {{0, 0}};
    constexpr int n = 2000;
    for (int i = 0; i < n; ++i) {
        const float angle = 0.0005f + (6.2831853f - 0.001f) * float(i) / float(n - 1);
        disc.push_back({0.5f * std::cos(angle), 0.5f * std::sin(angle)});
    }
    World world({.sleeping = false});
    add_floor(world);
    // It begins with the slot on top and does not come round to it.
    Body wheel =
        world.create_body({.position = {-10, 0.5f}, .angle = 1.5707963f, .velocity = {2, 0}});
    wheel.set_angular_velocity(-4.0f);
    const Shape shape = wheel.add(Concave{disc});
    double sum = 0;
    for (const auto& piece : shape.pieces()) {
        REQUIRE(piece.size() <= 16);
        REQUIRE(is_convex(piece));
        sum += area_of(piece);
    }
    REQUIRE(sum == Approx(0.7854).epsilon(1e-3));
    float kick = 0.0f;
    for (int i = 0; i < 42; ++i) {
        world.step(frame);
        kick = std::max(kick, std::fabs(wheel.velocity().y));
    }
    CHECK(kick < 0.02f);
    CHECK(wheel.velocity().x == Approx(2).epsilon(0.005));
    CHECK(wheel.position().x == Approx(-8.6).epsilon(0.001));
}

TEST_CASE("outlines that cross or touch themselves are refused and the place is named") {
    REQUIRE(says(refusal({{0, 0}, {2, 2}, {2, 0}, {0, 2}}),
                 "the edge from vertex 1 to 2 crosses the edge from vertex 3 to 4 at (1, 1)"));
    // The bow-tie of a longer outline.
    REQUIRE(says(refusal({{0, 0}, {4, 0}, {4, 4}, {1, -1}, {0, 4}}), "crosses"));
    // A hole, reached through a cut.
    REQUIRE(says(
        refusal({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}}),
        "hole"));
    REQUIRE(says(refusal({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}),
                 "vertex 4 touches the edge from vertex 1 to 2 at (2, 0)"));
    REQUIRE(says(refusal({{0, 0}, {4, 0}, {2, 0}, {2, 2}}), "runs back over"));
    REQUIRE(says(refusal({{0, 0}, {1, 0}}), "at least three"));
    REQUIRE(says(refusal({{0, 0}, {0, 0}, {0, 0}, {1, 0}}), "at least three"));
    REQUIRE(says(refusal({}), "at least three"));
    REQUIRE(says(refusal({{0, 0}, {1, 0}, {std::nanf(""), 1}}), "nan"));
    REQUIRE(says(refusal({{0, 0}, {1, 0}, {3e6f, 1}}), "3e+06"));
    REQUIRE(refusal({{0, 0}, {1, 0}, {1, 0}, {1, 1}}).empty());
}

TEST_CASE("mass and inertia of a concave polygon are those of its area") {
    World world;
    Body body = world.create_body();
    body.add(Concave{u_form}, {.density = 2.0f});
    // The square without the notch.
    const double notch = 1.2 * 1.6, area = 4.0 - notch;
    const double middle = (0.0 - notch * 0.2) / area;
    REQUIRE(body.mass() == Approx(2.0 * area));
    REQUIRE(body.center().x == Approx(0.0).margin(1e-6));
    REQUIRE(body.center().y == Approx(middle));
    const double inertia =
        (4.0 * 8.0 / 12.0) + 4.0 * middle * middle -
        (notch * (1.2 * 1.2 + 1.6 * 1.6) / 12.0 + notch * (0.2 - middle) * (0.2 - middle));
    REQUIRE(body.inertia() == Approx(2.0 * inertia).epsilon(1e-5));
}

TEST_CASE("a ball falls into a concave polygon and stays in it") {
    World world;
    add_floor(world);
    Body cup = world.create_body({.position = {0, 1.0f}});
    Shape shape = cup.add(Concave{u_form});
    Body ball = add_ball(world, {0.05f, 3.0f}, 0.5f);
    run(world, 4.0f);
    REQUIRE(ball.position().y == Approx(0.9f).margin(0.02));
    REQUIRE(cup.position().y == Approx(1.0f).margin(0.01));
    REQUIRE(std::fabs(cup.angle()) < 0.02f);
    REQUIRE(world.shape_count() == 3);
    // Its walls are one shape: one touch.
    REQUIRE(shape.is_touching());
    REQUIRE(shape.contains({0.8f, 1.5f}));
    REQUIRE_FALSE(shape.contains({0.0f, 1.5f}));
    REQUIRE_FALSE(world.validate());
    // Live: the notch is filled.
    ball.destroy();
    shape.set_vertices(std::vector<Vec2>{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
    REQUIRE(shape.pieces().size() == 1);
    REQUIRE(cup.mass() == Approx(4.0f));
    run(world, 1.0f);
    REQUIRE(cup.position().y == Approx(1.0f).margin(0.02));
    REQUIRE_THROWS_AS(shape.set_vertices(std::vector<Vec2>{{0, 0}, {2, 2}, {2, 0}, {0, 2}}),
                      std::invalid_argument);
    REQUIRE(shape.pieces().size() == 1);
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("a body that slides over a concave polygon is not kicked where its pieces meet") {
    // A long table on many legs: cut into many pieces, flat on top with vertices all along.
    std::vector<Vec2> table;
    for (int i = 0; i <= 60; ++i) {
        const float x = -15.0f + 0.5f * float(i);
        table.push_back({x, i % 2 ? -2.0f : -1.0f});
    }
    for (int i = 60; i >= 0; --i) table.push_back({-15.0f + 0.5f * float(i), 0.0f});
    const int kind = GENERATE(0, 1, 2, 3);
    const float speed = GENERATE(0.5f, 3.0f, 10.0f);
    World world({.sleeping = false});
    Body fixed = world.create_body({.type = BodyType::static_body});
    Shape shape = fixed.add(Concave{table}, {.friction = 0.0f});
    REQUIRE(shape.pieces().size() > 10);
    Body slider = world.create_body({.position = {-13, 0.5f}});
    const ShapeDef surface = {.friction = 0.0f};
    if (kind == 0) slider.add(Circle{.radius = 0.5f}, surface);
    if (kind == 1) slider.add(Box{}, surface);
    if (kind == 2) slider.add(Segment{{-0.5f, 0}, {0.5f, 0}, 0.5f}, surface);
    if (kind == 3) slider.add(Ellipse{0.8f, 0.5f}, surface);
    run(world, 0.5f);
    slider.set_velocity({speed, 0});
    float kick = 0.0f;
    const int steps = std::min(200, int(24.0f / speed * 60.0f));
    for (int i = 0; i < steps; ++i) {
        world.step(frame);
        kick = std::max(kick, std::fabs(slider.velocity().y));
    }
    INFO("kind " << kind << " at " << speed << " m/s: kick " << kick);
    CHECK(kick < 0.02f);
    CHECK(slider.velocity().x == Approx(speed).epsilon(1e-3));
}

TEST_CASE("concave polygons pile up without sinking into each other") {
    World world({.bounds = Aabb{{-6, 0}, {6, 40}}});
    std::vector<Body> bodies;
    for (int i = 0; i < 40; ++i) {
        Body body =
            world.create_body({.position = {float(i % 5) * 2.2f - 4.4f, 1.5f + 2.2f * float(i / 5)},
                               .angle = 0.7f * float(i)});
        if (i % 3 == 0)
            body.add(Concave{star(5, 1.0f, 0.4f)});
        else if (i % 3 == 1)
            body.add(Concave{u_form});
        else
            body.add(
                Concave{{{0, 0}, {1.5f, 0}, {1.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, 1.5f}, {0, 1.5f}}});
        bodies.push_back(body);
    }
    run(world, 12.0f);
    double energy = 0;
    float deepest = 0;
    for (Body body : bodies) {
        energy += body.kinetic_energy();
        REQUIRE(body.world_center().y > 0.1f);
    }
    for (const Contact& contact : world.contacts())
        for (int k = 0; k < contact.point_count; ++k)
            deepest = std::min(deepest, contact.points[size_t(k)].separation);
    REQUIRE(energy < 0.5);
    REQUIRE(deepest > -0.05f);
    REQUIRE_FALSE(world.validate());
}

/// The edges of an outline above which shapes find nothing that pushes them out.
int edges_without_push(const std::vector<Vec2>& outline) {
    int found = 0;
    for (size_t i = 0; i < outline.size(); ++i) {
        const Vec2 from = outline[i], along = outline[(i + 1) % outline.size()] - from;
        const Vec2 out = Vec2{along.y, -along.x} * (1.0f / along.length());
        const float size = std::min(0.3f * along.length(), 0.1f);
        const Geometry on[] = {Circle{.radius = size}, Box{.width = size, .height = size},
                               Ellipse{.radius_x = size, .radius_y = 0.5f * size}};
        for (const Geometry& shape : on) {
            const Pose pose = {from + 0.5f * along + (0.3f * size) * out,
                               std::atan2(along.y, along.x)};
            const auto pushes = contact_manifolds(Concave{outline}, {}, shape, pose);
            if (std::none_of(pushes.begin(), pushes.end(), [&](const ContactManifold& m) {
                    return m.normal.dot(out) > 0.9f && m.points[0].separation < 0;
                }))
                ++found;
        }
    }
    return found;
}

TEST_CASE(
    "every edge of a concave polygon pushes bodies even if another edge is on the same line") {
    for (unsigned seed = 0; seed < (thorough() ? 200 : 4); ++seed) {
        std::mt19937 engine(seed);
        const auto random = [&](float low, float high) {
            return low + (high - low) * float(engine()) / 4294967296.0f;
        };
        // Ground with vertices on the lines between others.
        std::vector<Vec2> ground = {{-20, random(-6, -4)}, {20, random(-6, -4)}};
        for (float x = 20; x >= -20; x -= random(2, 8)) {
            const Vec2 p = {x, random(-1, 1)};
            for (int k = int(random(0, 4)); ground.size() > 2 && k > 0; --k)
                ground.push_back(ground.back() + random(0.2f, 0.8f) * (p - ground.back()));
            ground.push_back(p);
        }
        INFO("seed " << seed);
        CHECK(edges_without_push(ground) == 0);
        // A row of spikes on one line.
        std::vector<Vec2> comb = {{0, -random(0.5f, 2)}, {20, -random(0.5f, 2)}};
        const float width = random(0.1f, 0.9f), gap = random(1.0f, 2.0f) - width;
        for (float x = 20; x - width > 0; x -= width + gap) {
            comb.push_back({x, 0});
            comb.push_back({x - random(0, width), random(0.5f, 3)});
            comb.push_back({x - width, 0});
        }
        CHECK(edges_without_push(comb) == 0);
    }
}

}  // namespace concave_test
