#include <fettle/physics/outlines.h>

#include "catch.h"
#include "scenes.h"
#include "thorough.h"

#include <cmath>

namespace messages_test {

using namespace scenes;

template <class Act>
std::string refusal(Act&& act) {
    try {
        act();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "nothing was refused";
}

const float nan = std::nanf("");

TEST_CASE("an error in a list of points names the point that is wrong") {
    World world;
    Body body = world.create_body();
    const std::string expected = ": expected coordinates between -1e+06 and 1e+06";
    CHECK(refusal([&] {
              body.add(Polygon{{{0, 0}, {1, 0}, {nan, 2}}});
          }) == "vertices: vertex 3 = (nan, 2)" + expected);
    CHECK(refusal([&] {
              body.add(Concave{{{0, 0}, {2e6f, 0}, {1, 2}}});
          }) == "vertices: vertex 2 = (2e+06, 0)" + expected);
    CHECK(refusal([&] {
              body.add(Chain{{{0, -infinity}, {1, 0}}});
          }) == "points: point 1 = (0, -inf)" + expected);
    Shape triangle = body.add(Polygon{{{0, 0}, {1, 0}, {0, 1}}});
    CHECK(refusal([&] {
              triangle.set_vertices(std::vector<Vec2>{{0, 0}, {0, nan}, {1, 1}, {1, 0}});
          }) == "vertices: vertex 2 = (0, nan)" + expected);

    CHECK(refusal([&] { triangle.set_vertices(std::vector<Vec2>((1u << 20) + 1)); }) ==
          "vertices = 1048577 points: expected at most 1048576 points");
    // The time to cut a concave outline grows fast.
    const std::string too_many = "vertices = 16385 points: expected at most 16384 points";
    std::vector<Vec2> teeth;
    for (int i = 0; i < 16384; ++i) teeth.push_back({float(i), i % 2 == 0 ? 1.0f : 2.0f});
    teeth.push_back({0, -1});
    CHECK(refusal([&] { body.add(Concave{teeth}); }) == too_many);
    CHECK(refusal([&] { (void)convex_pieces(teeth); }) == too_many);
    Shape corner = body.add(Concave{{{0, 0}, {1, 0}, {0.2f, 0.2f}, {0, 1}}});
    CHECK(refusal([&] { corner.set_vertices(teeth); }) == too_many);
    if (thorough()) {  // it takes some seconds
        teeth.pop_back();
        teeth.front() = {0, -1};
        teeth.back() = {16383, -1};
        CHECK(refusal([&] { corner.set_vertices(teeth); }) == "nothing was refused");
    }

    const std::vector<Vec2> line = {{0, 0}, {nan, 0}};
    CHECK(refusal([&] { (void)without_straight_points(line, false, 0); }) ==
          "points: point 2 = (nan, 0)" + expected);
    CHECK(refusal([&] {
              (void)join_lines(std::vector<std::vector<Vec2>>{{{0, 0}, {1, 0}}, line});
          }) == "lines: line 2: point 2 = (nan, 0)" + expected);
    CHECK(refusal([&] {
              (void)grid_outlines(std::vector<float>{0, 1, 1, nan}, {.columns = 2, .rows = 2});
          }) == "values: value 4 = nan: expected a finite number");
}

TEST_CASE("an error shows a number that is hardly beyond a limit with enough digits") {
    World world;
    CHECK(refusal([&] { world.create_body({.angle = std::nextafter(1e8f, 2e8f)}); }) ==
          "angle = 100000008: expected a number from -1e+08 to 1e+08");
    CHECK(refusal([&] { world.create_body().add(Circle{0.000009999999f}); }) ==
          "radius = 9.99999884e-06: expected a number from 1e-05 to 1e+06");
    CHECK(refusal([&] { world.create_body({.linear_damping = -0.1f}); }) ==
          "linear_damping = -0.1: expected a finite number of at least 0");
}

TEST_CASE("an error in a member of a member names both") {
    const Movement still = {}, far = {.to = {{nan, 0}, 0}}, turned = {.from = {{}, infinity}};
    CHECK(refusal([&] { (void)time_of_impact(Box{}, still, Box{}, far); }) ==
          "movement_b.to.position = (nan, 0): expected coordinates between -1e+08 and 1e+08");
    CHECK(refusal([&] { (void)time_of_impact(Box{}, turned, Box{}, still); }) ==
          "movement_a.from.angle = inf: expected a number from -1e+08 to 1e+08");
    CHECK(refusal([&] {
              (void)time_of_impact(Box{}, {.center = {0, nan}}, Box{}, still);
          }) == "movement_a.center = nan: expected a number from -1e+06 to 1e+06");
}

TEST_CASE("errors say what is missing") {
    World world;
    CHECK(refusal([&] { world.create_body().set_target({}, infinity); }) ==
          "dt = inf: expected a finite number above 0");
    CHECK(refusal([&] { world.restore(std::vector<std::byte>(7)); }) ==
          "the data are not a saved world: they have only 7 bytes");
    CHECK(refusal([&] { world.create_mouse_joint({}); }) ==
          "body: a mouse joint drags a body, got none");
}

}  // namespace messages_test
