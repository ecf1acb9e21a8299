#include "catch.h"
#include "scenes.h"

namespace standing_test {

using namespace scenes;

namespace {

constexpr double pi = 3.14159265358979323846;

}  // namespace

TEST_CASE("an arch of seventeen blocks stands") {
    World world({.sleeping = false});
    add_floor(world);
    std::vector<Body> blocks;
    std::vector<Vec2> places;
    constexpr int count = 17;
    for (int i = 0; i < count; ++i) {
        const double from = pi * i / count, to = pi * (i + 1) / count, between = 0.5 * (from + to);
        const Vec2 center(float(10 * std::cos(between)), float(10 * std::sin(between)));
        Polygon wedge;
        for (const auto& [radius, angle] :
             {std::pair{9.0, from}, std::pair{11.0, from}, std::pair{11.0, to}, std::pair{9.0, to}})
            wedge.vertices.push_back(
                Vec2(float(radius * std::cos(angle)), float(radius * std::sin(angle))) - center);
        blocks.push_back(world.create_body({.position = center}));
        blocks.back().add(wedge);
        places.push_back(center);
    }
    run(world, 10.0f);
    for (size_t i = 0; i < blocks.size(); ++i) {
        INFO(i);
        CHECK((blocks[i].position() - Position(places[i])).length() < 0.1f);
        CHECK(std::fabs(blocks[i].angle()) < 0.05f);
    }
}

TEST_CASE("a row of dominoes falls in order and to the last") {
    World world;
    add_floor(world);
    std::vector<Body> slabs;
    constexpr int count = 15;
    for (int i = 0; i < count; ++i) {
        slabs.push_back(world.create_body({.position = {float(i) - 7.0f, 0.5f}}));
        slabs.back().add(Box{.width = 0.25f, .height = 1.0f});
    }
    slabs[0].set_velocity({0.8f, 0});
    slabs[0].set_angular_velocity(-4.5f);
    std::vector<int> fell(count, -1);
    for (int step = 0; step < 900; ++step) {
        world.step(frame);
        for (size_t i = 0; i < slabs.size(); ++i)
            if (fell[i] < 0 && std::fabs(slabs[i].angle()) > 0.25f * float(pi)) fell[i] = step;
    }
    for (size_t i = 0; i < slabs.size(); ++i) {
        INFO(i);
        REQUIRE(fell[i] >= 0);
        if (i > 0) CHECK(fell[i] >= fell[i - 1]);
    }
}

TEST_CASE("625 circles that overlap at first come to rest in their box") {
    World world({.gravity = {0, 0}, .sleeping = false});
    Body box = world.create_body({.type = BodyType::static_body});
    const float half = 10.5f;
    for (float side : {-1.0f, 1.0f}) {
        box.add(Box{.width = 2, .height = 2 * half + 4, .center = {side * (half + 1), 0}});
        box.add(Box{.width = 2 * half + 4, .height = 2, .center = {0, side * (half + 1)}});
    }
    std::vector<Body> balls;
    for (int i = 0; i < 25; ++i)
        for (int k = 0; k < 25; ++k)
            balls.push_back(add_ball(world, {0.72f * float(i - 12), 0.72f * float(k - 12)}, 0.42f));
    run(world, 20.0f);
    double sum = 0.0;
    for (Body ball : balls) {
        sum += double(ball.velocity().length_squared());
        REQUIRE(Vec2(ball.position()).abs().largest() < half);
    }
    REQUIRE(std::sqrt(sum / 625.0) < 0.05);
}

}  // namespace standing_test
