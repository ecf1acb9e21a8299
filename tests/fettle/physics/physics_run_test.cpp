// Physics in Lua games: questions in a step, joints that break, the two demos.

#include <catch.h>
#include <fstream>
#include <sstream>

#include "program.h"

namespace physics_run_test {

using namespace program_test;

namespace {

const std::string ground =
    "world.floor = Body { type = 'static', position = vec(0, -1), Box { width = 60, height = 2 } "
    "} ";

Outcome run(const std::string& script, int steps, const std::string& ask) {
    return run_script(Folder(), script, steps, {"--at", std::to_string(steps) + ":" + ask});
}

}  // namespace

TEST_CASE("a script makes a platform that bodies can pass from below") {
    const Outcome done =
        run(ground +
                "world.platform = Body { type = 'static', position = vec(0, 2), "
                "Box { width = 10, height = 0.2 } } "
                "world.ball = Body { position = vec(0, 0.5), velocity = vec(0, 9), "
                "Circle { radius = 0.3 } } "
                "world.platform:on('before_solve', function(contact) "
                "if contact.normal.y < 0.5 or contact.other.velocity.y > 0.01 then "
                "contact.enabled = false end end)",
            240, "print(string.format('%.2f', world.ball.position.y))");
    CHECK(done.err.empty());
    CHECK(done.out == "2.40\n");
}

TEST_CASE("a class of a script answers questions about its bodies") {
    const Outcome done =
        run(ground +
                "Ice = class('Ice', Body) {} "
                "function Ice:before_solve(contact) contact.friction = 0 end "
                "world.ice = Ice { position = vec(-5, 0.5), velocity = vec(3, 0), Box {} } "
                "world.box = Body { position = vec(5, 0.5), velocity = vec(3, 0), Box {} } ",
            120, "print(world.ice.velocity.x > 2.9, math.abs(world.box.velocity.x) < 0.01)");
    CHECK(done.err.empty());
    CHECK(done.out == "true\ttrue\n");
}

TEST_CASE("a world mixes surfaces with a function of the script and with its own rules") {
    const Outcome done = run(ground +
                                 "world:on('mix_surfaces', function(contact) "
                                 "contact.restitution = contact.point.x < 0 and 0.9 or 0 end) "
                                 "world.left = Body { position = vec(-5, 4), Circle {} } "
                                 "world.right = Body { position = vec(5, 4), Circle {} } "
                                 "rise = { left = 0, right = 0 } "
                                 "function step() for name, y in pairs(rise) do "
                                 "rise[name] = math.max(y, world[name].velocity.y) end end",
                             120, "print(rise.left > 5, rise.right < 0.5)");
    CHECK(done.err.empty());
    CHECK(done.out == "true\ttrue\n");
}

TEST_CASE("a handler in a step that writes to the tree is refused with the place of the call") {
    const Outcome done = run(ground +
                                 "world.ball = Body { position = vec(0, 0.5), Circle {} }\n"
                                 "world.ball:on('before_solve', function(contact)\n"
                                 "world.ball.mass = 3 end)",
                             30, "print(1)");
    CHECK(done.status == 1);
    CHECK(contains(done.err, "before_solve"));
    CHECK(contains(done.err, "main.lua:3"));
}

TEST_CASE("a joint that breaks notifies the script") {
    const Outcome done =
        run("world.ball = Body { position = vec(0, 5), Circle {} } "
            "world.rope = DistanceJoint { body_b = world.ball, anchor_a = vec(0, 8), "
            "break_force = 7 } "
            "world.rope:on('broke', function(event) "
            "print(string.format('%.1f', event.force.y), event.instance.broken) end)",
            30, "print(world.ball.velocity.y < -3)");
    CHECK(done.err.empty());
    CHECK(done.out == "7.9\ttrue\ntrue\n");
}

TEST_CASE("queries use only shapes that a function of the script accepts") {
    const Outcome done =
        run("world.near = Body { position = vec(3, 0), Box {} } "
            "world.far = Body { position = vec(6, 0), Box {} } "
            "world.gravity = vec(0, 0) "
            "function no_near(shape) return shape.parent ~= world.near end",
            2,
            "local hit = world:raycast(vec(0, 0), vec(9, 0), nil, nil, no_near) "
            "print(hit.body.name, world:closest(vec(0, 0), 9, nil, nil, no_near).body.name, "
            "world:raycast(vec(0, 0), vec(9, 0)).body.name, "
            "#world:overlap(Circle { radius = 9 }, nil, nil, function() return false end), "
            "#world:overlap(Circle { radius = 9 }))");
    CHECK(done.err.empty());
    CHECK(done.out == "far\tfar\tnear\t0\t2\n");
}

TEST_CASE("the car of the demo drives over the hills and the bridge") {
    const Folder folder;
    const Outcome done =
        fettle(folder, {"run", "scripts/car", "--headless", "--steps", "2400", "--at",
                        "1:drive.autopilot = true", "--at",
                        "2400:print(world.car.chassis.position.x > 90, world.car.coins > 5)"});
    CHECK(done.err.empty());
    CHECK(done.out == "true\ttrue\n");
}

TEST_CASE("a scene of every shape and joint loads and is saved unchanged") {
    const Folder folder;
    for (const char* name : {"main.lua", "shapes.json"}) {
        std::ifstream file(std::string("scripts/shapes/") + name);
        std::stringstream text;
        text << file.rdbuf();
        REQUIRE(text.str().size() > 100);
        folder.write(name, text.str());
    }
    const Outcome done =
        fettle(folder, {"run", (folder / "").string(), "--headless", "--steps", "300", "--at",
                        "1:scene.save('again.json', world.shapes)", "--at",
                        "299:print(world.step.joints, world.shapes.marble.position.y > 0, "
                        "world.shapes.ellipse.position.y > 0)"});
    CHECK(done.err.empty());
    CHECK(done.out == "15\ttrue\ttrue\n");
    CHECK(folder.text("again.json") == folder.text("shapes.json"));
    for (const char* shape :
         {"Circle", "Box", "Capsule", "Segment", "Polygon", "Ellipse", "Concave", "Chain"})
        CHECK(contains(folder.text("shapes.json"), std::string("\"class\": \"") + shape + "\""));
    for (const char* joint : {"Distance", "Revolute", "Prismatic", "Wheel", "Weld", "Mouse",
                              "Motor", "Pulley", "Gear", "Groove", "PinSlot", "Ratchet"})
        CHECK(
            contains(folder.text("shapes.json"), std::string("\"class\": \"") + joint + "Joint\""));
}

TEST_CASE("the ragdolls of the demo fall and come to rest in one piece") {
    const Folder folder;
    const Outcome done = fettle(
        folder, {"run", "scripts/ragdoll", "--headless", "--steps", "700", "--at",
                 "690:worst = 0 world:each('RevoluteJoint', function(pin) if pin.body_a then "
                 "worst = math.max(worst, (pin.body_a:to_world(pin.anchor_a) - "
                 "pin.body_b:to_world(pin.anchor_b)):length()) end end)",
                 "--at", "691:print(worst < 0.05, world.step.joints >= 50)"});
    CHECK(done.err.empty());
    CHECK(done.out == "true\ttrue\n");
}

}  // namespace physics_run_test
