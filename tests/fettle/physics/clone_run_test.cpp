// Copies of whole worlds.

#include <catch.h>

#include "program.h"

namespace clone_run_test {

using namespace program_test;

namespace {

Outcome run(const std::string& script, int steps = 120) {
    return run_script(Folder(), script, steps);
}

}  // namespace

TEST_CASE("a cloned world moves as the original does") {
    const Outcome done = run(R"lua(
        world.gravity = vec(1, -9)
        world.bounds = { vec(-9, -9), vec(9, 9) }
        world.lives = 3
        world.group = Object {}
        world.group.a = Body { position = vec(0, 3), Box { density = 2 }, Circle { center = vec(0, 1) } }
        world.group.b = Body { position = vec(2, 3), color = "red", Polygon {} }
        world.wind = Wind { velocity = vec(3, 0) }
        world.pin = RevoluteJoint { body_a = world.group.a, body_b = world.group.b, anchor_a = vec(1, 0), anchor_b = vec(-1, 0) }
        world.rod = DistanceJoint { body_b = world.group.b, anchor_a = vec(2, 8) }
        world.list = { world.group.a, world.pin, time }
        after(0.5, function()
            twin = world:clone()
            print(twin.parent, twin.lives, twin.gravity, twin.bounds[2], #twin, #world)
            print(twin.pin.body_a == twin.group.a, twin.rod.body_b == twin.group.b, twin.rod.body_a,
                  twin.list[1] == twin.group.a, twin.list[2] == twin.pin, twin.list[3] == time)
            print(twin.rod.length == world.rod.length, twin.step.bodies, twin.group.a.velocity == world.group.a.velocity)
            game.twin = twin
        end)
        after(0.6, function()
            print((twin.group.a.position - world.group.a.position):length() < 0.01, twin.step.bodies, twin.step.joints)
            world.group:delete()
            print(twin.group.a:alive(), twin.group.a[1].density)
        end)
        after(1.5, function() print(twin.group.b.position.x < 9) end)
    )lua");
    CHECK(done.err.empty());
    CHECK(done.out ==
          "nil\t3\tvec(1, -9)\tvec(9, 9)\t5\t5\n"
          "true\ttrue\tnil\ttrue\ttrue\ttrue\n"
          "true\t0\ttrue\n"
          "true\t2\t2\n"
          "true\t2.0\n"
          "true\n");
}

TEST_CASE("cloning an instance that only Fettle can make is refused") {
    const Outcome done = run(R"lua(
        world.a = Body { Circle {} }
        local before = #game:all()
        for _, each in ipairs { game, time, world.step } do
            print(select(2, pcall(function() return each:clone() end)):match("%d: (.*)"))
        end
        print(#game:all() == before)
        print(world:clone().a)
    )lua",
                             1);
    CHECK(
        contains(done.out, "game: cannot be cloned; the framework makes the one there is, game\n"));
    CHECK(
        contains(done.out, "time: cannot be cloned; the framework makes the one there is, time\n"));
    CHECK(
        contains(done.out,
                 "world.step: cannot be cloned; the framework makes the one there is, world.step\n"
                 "true\n"));
}

TEST_CASE("a deep tree is cloned") {
    const Outcome done = run(R"lua(
        local top = Object {}
        local at = top
        for i = 1, 999 do at = at:add(Object { depth = i }) end
        local copy = top:clone()
        local count = 0
        copy:each(function(each) count = count + 1 end)
        print(count)
        local many = Object {}
        local first = many:add(Body {})
        for i = 1, 4000 do many:add(DistanceJoint { body_a = first }) end
        print(#many:clone():children("DistanceJoint"))
    )lua",
                             1);
    CHECK(without_notes(done.err).empty());
    CHECK(done.out == "999\n4000\n");
}

}  // namespace clone_run_test
