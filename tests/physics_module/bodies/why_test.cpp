// `why` explains the mass, the velocity and the pose of a body: the parts that it lists add up.

#include <fettle/property/explaining.h>
#include <limits>

#include "catch.h"
#include "game.h"
#include "patterns.h"

namespace why_test {

using namespace fettle;
using physics_module::testing::Game;
using property::Handle;
using property::Value;
using property::Vec2;

namespace {

std::vector<std::string> lines(Game& game, Handle of, const char* name) {
    std::vector<std::string> all;
    for (const property::Explanation& source :
         game.tree.why(of, game.tree.property(of, name)).from) {
        all.push_back(source.path);
        UNSCOPED_INFO(source.path);
    }
    return all;
}

/// The sum of the first vectors behind the colons.
Vec2 sum_of(const std::vector<std::string>& lines) {
    Vec2 sum(0, 0);
    const std::string vec = ": (\\+ )?vec\\(([^,]+), ([^)]+)\\)";
    for (const std::string& line : lines)
        if (const auto found = patterns::first(line, vec); !found.empty())
            sum += Vec2(std::stod(found[2]), std::stod(found[3]));
    return sum;
}

/// The sum of the first numbers behind the colons.
double turns(const std::vector<std::string>& lines) {
    double sum = 0;
    const std::string number = ": ([-+] )?([-.e0-9]+) rad/s";
    for (const std::string& line : lines)
        if (const auto found = patterns::first(line, number); !found.empty())
            sum += (found[1] == "- " ? -1 : 1) * std::stod(found[2]);
    return sum;
}

bool has(const std::vector<std::string>& lines, const std::string& text) {
    for (const std::string& line : lines)
        if (line.find(text) != std::string::npos) return true;
    return false;
}

/// Checks in each step that the listed parts add up; returns the lines of the last step.
std::vector<std::string> check_sum_of_velocities(Game& game, Handle body, int steps) {
    lines(game, body, "velocity");
    std::vector<std::string> last;
    for (int i = 0; i < steps; ++i) {
        game.step();
        last = lines(game, body, "velocity");
        const Vec2 is = game.vec(body, "velocity");
        CHECK((sum_of(last) - is).length() < 1e-4 * (1 + is.length()));
        CHECK_FALSE(has(last, "about"));
        if (has(last, "the rest")) {
            FAIL_CHECK("step " << i << " has a rest");
        }
    }
    return last;
}

}  // namespace

TEST_CASE("a velocity is the sum of what changed it on a stack") {
    Game game;
    game.floor();
    std::vector<Handle> boxes;
    for (int i = 0; i < 4; ++i) boxes.push_back(game.body("Box", {0, 0.5 + i}));
    game.set(game.world(), "sleeping", false);
    for (const Handle box : {boxes[0], boxes[2]}) {
        const auto told = check_sum_of_velocities(game, box, 30);
        CHECK(has(told, "world.gravity: + vec(0, -0.16"));
        CHECK(has(told, "contact with world."));
    }
    game.set(boxes[1], "velocity", Vec2(0, 3));
    const auto told = check_sum_of_velocities(game, boxes[1], 1);
    CHECK(has(told, "impulse vec("));
}

TEST_CASE("a write between two steps is listed separately") {
    Game game;
    const Handle ball = game.body("Circle", {0, 5});
    check_sum_of_velocities(game, ball, 2);
    game.set(ball, "velocity", Vec2(4, 0));
    CHECK(has(lines(game, ball, "velocity"), "written since the step: + vec(4, "));
    game.step();
    const auto told = lines(game, ball, "velocity");
    CHECK(has(told, "between the steps (writes, edits of shapes): + vec(4, "));
    CHECK((sum_of(told) - game.vec(ball, "velocity")).length() < 1e-4);
}

TEST_CASE("forces and damping are listed separately") {
    Game game;
    const Handle ball = game.body("Circle", {0, 5});
    game.set(ball, "force", Vec2(7, 0));
    game.set(ball, "linear_damping", 2.0);
    game.set(ball, "gravity_scale", 0.5);
    const auto told = check_sum_of_velocities(game, ball, 20);
    CHECK(has(told, ".force: + vec(0.1"));
    CHECK(has(told, "linear_damping): + vec(-"));
    CHECK(has(told, "gravity_scale: + vec(0, -0.08"));
    game.set(ball, "locked_y", true);
    game.step();
    CHECK_FALSE(has(check_sum_of_velocities(game, ball, 3), "gravity"));
}

TEST_CASE("joints and springs and pulleys are in the sum") {
    Game game;
    const Handle left = game.body("Circle", {-2, 0}), right = game.body("Box", {2, 0}),
                 hung = game.body("Circle", {0, -3});
    game.make("RevoluteJoint", game.world(),
              {{"body_a", left}, {"anchor_a", Vec2(2, 1)}, {"anchor_b", Vec2(0, 1)}});
    game.make("DistanceJoint", game.world(),
              {{"body_a", left}, {"body_b", right}, {"hertz", 3.0}, {"length", 3.0}});
    game.make(
        "PulleyJoint", game.world(),
        {{"body_a", right}, {"body_b", hung}, {"ground_a", Vec2(2, 4)}, {"ground_b", Vec2(0, 4)}});
    for (const Handle body : {left, right, hung}) lines(game, body, "velocity");
    for (int i = 0; i < 40; ++i) {
        game.step();
        for (const Handle body : {left, right, hung}) {
            std::string all;
            const auto told = lines(game, body, "velocity");
            for (const std::string& line : told) all += line + "\n";
            INFO(game.tree.path(body) << "\n" << all);
            CHECK((sum_of(told) - game.vec(body, "velocity")).length() < 1e-3);
            if (i < 5) CHECK(has(told, "joint world."));  // later the rope is slack
        }
    }
}

TEST_CASE("an impact that goes through joints is in the sum of every body") {
    for (const double restitution : {0.0, 0.6}) {
        Game game;
        game.floor();
        const Handle hull = game.body("Box", {0, 1.1});
        std::vector<Handle> bodies = {hull};
        for (const double side : {-0.5, 0.5}) {
            const Handle wheel = game.body("Circle", {side, 0.6});
            game.set(game.shape_of(wheel), "restitution", restitution);
            game.set(wheel, "mass", 0.05);
            game.make("RevoluteJoint", game.world(),
                      {{"body_a", hull}, {"body_b", wheel}, {"anchor_a", Vec2(side, -0.5)}});
            bodies.push_back(wheel);
        }
        for (const Handle body : bodies) {
            game.set(body, "velocity", Vec2(1, -8));
            for (const char* name : {"velocity", "angular_velocity"}) lines(game, body, name);
        }
        for (int i = 0; i < 12; ++i) {
            game.step();
            for (const Handle body : bodies) {
                const auto moves = lines(game, body, "velocity"),
                           turns_by = lines(game, body, "angular_velocity");
                const Vec2 is = game.vec(body, "velocity");
                const double turn = game.number(body, "angular_velocity");
                std::string all;
                for (const auto& part : {moves, turns_by})
                    for (const std::string& line : part) all += line + "\n";
                INFO(restitution << ", step " << i << "\n" << all);
                CHECK((sum_of(moves) - is).length() < 1e-3 * (1 + is.length()));
                CHECK(std::abs(turns(turns_by) - turn) < 1e-3 * (1 + std::abs(turn)));
                CHECK_FALSE(has(moves, "the rest"));
                CHECK_FALSE(has(turns_by, "the rest"));
            }
        }
    }
}

TEST_CASE("a conveyor and a bounce and a rolling ellipse are in the sum") {
    Game game;
    const Handle floor = game.floor();
    game.set(game.shape_of(floor), "surface_speed", 2.0);
    const Handle crate = game.body("Box", {0, 0.5});
    CHECK(has(check_sum_of_velocities(game, crate, 20), "contact with world."));
    const Handle ball = game.body("Circle", {6, 1});
    game.set(game.shape_of(ball), "restitution", 0.8);
    game.set(ball, "velocity", Vec2(1, -6));
    check_sum_of_velocities(game, ball, 30);
    const Handle egg = game.body("Ellipse", {-6, 1});
    lines(game, egg, "velocity");
    for (int i = 0; i < 30; ++i) {
        game.step();
        CHECK((sum_of(lines(game, egg, "velocity")) - game.vec(egg, "velocity")).length() < 1e-3);
    }
}

TEST_CASE("many bodies are solved in several blocks and every account adds up") {
    Game game;
    game.floor();
    std::vector<Handle> all;
    for (int column = 0; column < 30; ++column)
        for (int i = 0; i < 20; ++i)
            all.push_back(game.body("Box", {-18.0 + 1.2 * column, 0.5 + 1.01 * i}));
    for (const std::size_t i : {0u, 310u, 599u}) check_sum_of_velocities(game, all[i], 6);
}

/// Checks in each step that the listed parts add up; returns the lines of the last step.
std::vector<std::string> check_sum_of_turns(Game& game, Handle body, int steps) {
    lines(game, body, "angular_velocity");
    std::vector<std::string> last;
    for (int i = 0; i < steps; ++i) {
        game.step();
        last = lines(game, body, "angular_velocity");
        std::string all;
        for (const std::string& line : last) all += line + "\n";
        INFO("step " << i << "\n" << all);
        const double is = game.number(body, "angular_velocity");
        CHECK(std::abs(turns(last) - is) < 1e-4 * (1 + std::abs(is)));
        CHECK_FALSE(has(last, "the rest"));
        CHECK_FALSE(has(last, "not kept"));
    }
    return last;
}

TEST_CASE("an angular velocity is the sum of what changed it") {
    Game game;
    game.floor();
    const Handle box = game.body("Box", {0, 2});
    game.set(box, "angle", 0.4);
    game.set(box, "velocity", Vec2(2, 0));
    game.set(box, "angular_damping", 0.5);
    game.set(box, "torque", 0.7);
    const auto told = check_sum_of_turns(game, box, 60);
    CHECK(has(told, ".torque: + 0.0"));
    CHECK(has(told, "contact with world."));
    CHECK(has(told, "angular impulse"));
    CHECK(has(told, ".angular_damping): "));
    game.set(box, "angular_velocity", 3.0);
    CHECK(has(lines(game, box, "angular_velocity"), "written since the step: + "));
    game.set(box, "locked_rotation", true);
    CHECK(has(lines(game, box, "angular_velocity"), "its rotation is locked"));
}

TEST_CASE("circles and eggs that roll and bounce turn by their contacts") {
    Game game;
    game.set(game.shape_of(game.floor()), "surface_speed", 1.5);
    const Handle ball = game.body("Circle", {0, 1}), egg = game.body("Ellipse", {-8, 1.2});
    game.set(game.shape_of(ball), "rolling_resistance", 0.1);
    game.set(game.shape_of(ball), "restitution", 0.6);
    for (const Handle body : {ball, egg}) game.set(body, "velocity", Vec2(3, -4));
    check_sum_of_turns(game, ball, 50);
    game.set(egg, "angular_velocity", 2.0);
    CHECK(has(check_sum_of_turns(game, egg, 50), "contact with world."));
}

TEST_CASE("the listed turns by joints of every kind are those of their bodies") {
    for (const char* kind : {"RevoluteJoint", "WeldJoint", "DistanceJoint", "PrismaticJoint",
                             "WheelJoint", "PulleyJoint", "MotorJoint", "GrooveJoint",
                             "PinSlotJoint", "GearJoint", "RatchetJoint", "RotaryLimitJoint"}) {
        INFO(kind);
        Game game;
        const Handle a = game.body("Box", {-1, 0}), b = game.body("Box", {1, 0.2}),
                     post = game.body("Box", {-1, 3}, "static");
        game.make("RevoluteJoint", game.world(),
                  {{"body_a", post}, {"body_b", a}, {"anchor_b", Vec2(0.3, 2)}});
        const Handle joint = game.make(kind, game.world(), {{"body_a", a}, {"body_b", b}});
        if (game.tree.find(joint, "anchor_a") != nullptr)
            game.set(joint, "anchor_a", Vec2(0.5, 0.4));
        if (game.tree.find(joint, "hertz") != nullptr) game.set(joint, "hertz", 4.0);
        game.set(a, "angular_velocity", 2.0);
        game.set(b, "angular_velocity", -3.0);
        game.step(2);
        for (const Handle body : {a, b}) check_sum_of_turns(game, body, 8);
        CHECK(has(check_sum_of_turns(game, a, 6), "joint world."));
    }
}

TEST_CASE("an account changes no result") {
    Game plain, asked;
    for (Game* game : {&plain, &asked}) {
        game->floor();
        for (int i = 0; i < 5; ++i) game->body("Box", {0.1 * i, 0.6 + 1.1 * i});
    }
    for (int i = 0; i < 60; ++i) {
        const auto bodies = asked.tree.children(asked.world());
        lines(asked, bodies[bodies.size() - 1], "velocity");
        plain.step();
        asked.step();
    }
    CHECK(plain.physics.hash() == asked.physics.hash());
}

TEST_CASE("the first answer is an estimate and bodies that do not move have a reason") {
    Game game;
    const Handle floor = game.floor(), box = game.body("Box", {0, 0.5});
    game.step(20);
    const auto first = lines(game, box, "velocity");
    CHECK(has(first, "about"));
    CHECK(has(first, "contact with world."));
    CHECK(has(lines(game, floor, "velocity"), "static body does not move"));
    game.set(floor, "type", "kinematic");
    CHECK(has(lines(game, floor, "velocity"), "keeps the velocity that was written"));
    game.set(floor, "type", "static");
    const Handle lost = game.make("Body", game.tree.root());
    CHECK(has(lines(game, lost, "velocity"), "in no world"));
    game.set(lost, "mass", std::numeric_limits<double>::infinity());
    game.tree.move(lost, game.world());
    CHECK(has(lines(game, lost, "velocity"), "infinite mass"));
    REQUIRE(game.falls_asleep(box));
    CHECK(has(lines(game, box, "velocity"), "asleep"));
    property::prepare_explanations(game.tree, box);
    game.set(box, "awake", true);
    game.step();
    CHECK_FALSE(has(lines(game, box, "velocity"), "about"));
}

TEST_CASE("mass and center and inertia are sums over the shapes") {
    Game game;
    const Handle body = game.body("Box", {0, 5});
    const Handle box = game.shape_of(body), ball = game.make("Circle", body);
    game.set(box, "density", 3.0);
    game.set(ball, "center", Vec2(2, 0));
    const auto first_numbers = [](const std::vector<std::string>& told) {
        double sum = 0;
        for (const std::string& line : told) sum += std::stod(line.substr(line.find(": ") + 2));
        return sum;
    };
    const auto mass = lines(game, body, "mass");
    REQUIRE(mass.size() == 2);
    CHECK(mass[0].starts_with(game.tree.path(box) + ": 3 kg = density 3 kg/m² × area 1 m²"));
    CHECK(first_numbers(mass) == Approx(game.number(body, "mass")).epsilon(1e-5));
    CHECK(first_numbers(lines(game, body, "inertia")) ==
          Approx(game.number(body, "inertia")).epsilon(1e-5));
    Vec2 center(0, 0);
    const std::string part = "vec\\(([^,]+), ([^)]+)\\) m, with (\\S+) of";
    for (const std::string& line : lines(game, body, "center")) {
        const patterns::Match found = patterns::first(line, part);
        REQUIRE_FALSE(found.empty());
        center += std::stod(found[3]) * Vec2(std::stod(found[1]), std::stod(found[2]));
    }
    CHECK((center - game.vec(body, "center")).length() < 1e-5);
    game.set(body, "mass", 8.0);
    CHECK(has(lines(game, body, "mass"), "it was set"));
    CHECK(has(lines(game, body, "inertia"), "because the mass was set"));
    const Handle bare = game.make("Body", game.world());
    CHECK(has(lines(game, bare, "mass"), "has 1 kg"));
    game.step();
    REQUIRE_FALSE(lines(game, bare, "center").empty());
    REQUIRE_FALSE(lines(game, bare, "inertia").empty());
}

TEST_CASE("a position is velocity times the length of the step") {
    Game game;
    const Handle ball = game.body("Circle", {0, 5});
    game.set(ball, "angular_velocity", 3.0);
    game.step(10);
    const auto told = lines(game, ball, "position");
    CHECK(has(told, ".velocity × 0.01666"));
    CHECK((sum_of(told) + Vec2(0, 0) - game.vec(ball, "position")).length() < 1e-4);
    CHECK(has(lines(game, ball, "angle"), ".angular_velocity × "));
    game.set(ball, "position", Vec2(1, 9));
    CHECK(has(lines(game, ball, "position"), "put here"));
}

TEST_CASE_METHOD(Game, "a mover walks by itself and a disabled body does not move") {
    floor();
    const Handle hero = make("Mover", world(), {{"position", Vec2(0, 5)}, {"walk", 2.0}});
    step(2);
    CHECK(has(lines(*this, hero, "velocity"), "in the air, with world.mover_1.walk = 2 m/s"));
    CHECK(has(lines(*this, hero, "velocity"), "world.gravity: + vec(0, -0.16"));
    step(120);
    CHECK(has(lines(*this, hero, "velocity"), "on ground, with world.mover_1.walk = 2 m/s"));
    set(hero, "climbing", true);
    CHECK(has(lines(*this, hero, "velocity"), "climbs"));
    set(hero, "enabled", false);
    CHECK(has(lines(*this, hero, "velocity"), "it is disabled (world.mover_1.enabled)"));
    const Handle ball = body("Circle", {3, 4});
    set(ball, "enabled", false);
    CHECK(has(lines(*this, ball, "velocity"), "it is disabled"));
}

}  // namespace why_test
