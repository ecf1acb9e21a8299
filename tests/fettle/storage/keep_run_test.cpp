// Kept edits of the console are present in the next run, without warnings.

#include <catch.h>

#include "keep_run.h"

namespace keep_run_test {

using namespace program_test;

TEST_CASE("instances made in the console that refer to each other are all made again") {
    const Folder folder;
    folder.write("main.lua", "world.b = Body { Circle {} }");
    const Outcome kept =
        run(folder, {"2:world.j=RevoluteJoint{body_a=world.b}",
                     "3:world.c=Body{position=vec(3,0),Circle{}}", "4:world.j.body_b=world.c",
                     "5:world.n=Object{}", "6:world.m=Object{other=world.n}",
                     "7:world.n.other=world.m", "8:keep(\"**\")"});
    CHECK(contains(kept.out + kept.err, "kept 4 tweaks in main.tweaks.json"));
    CHECK(output_of_next_run(folder,
                             "print(world.j.body_a == world.b and world.j.body_b == world.c, "
                             "world.n.other == world.m and world.m.other == world.n)") ==
          "true\ttrue\n");
}

TEST_CASE("a kept value says when the script gives another one than it gave then") {
    const Folder folder;
    const auto gives = [&](const std::string& mass) {
        folder.write("main.lua", "world.ball = Body { Circle {} }\n\nworld.ball.mass = " + mass +
                                     "\nworld.ball.friction = 0.5\n");
    };
    gives("2");
    run(folder, {"4:world.ball.mass=7", "5:world.ball.friction=0.25", "6:keep(\"**\")"});
    const std::string now =
        "main.lua:3 now gives world.ball.mass 3 kg; it gave 2 when 7 was kept, "
        "which main.tweaks.json:4 still sets";
    CHECK_FALSE(contains(run(folder, {}).err, "now gives"));
    gives("3");
    const Outcome outcome = run(folder, {}, "print(world.ball.mass)");
    INFO(outcome.err);
    CHECK(outcome.out == "7.0\n");
    CHECK(contains(outcome.err, now));
    CHECK_FALSE(contains(outcome.err, "friction"));
    // Whoever keeps a value again knows what the script gives.
    run(folder, {"4:world.ball.mass=8", "5:keep(\"**\")"});
    CHECK_FALSE(contains(run(folder, {}).err, "now gives"));
    gives("2");
    CHECK(contains(run(folder, {}).err, "it gave 3 when 8 was kept"));
}

TEST_CASE("a kept value that the script has changed while the game ran is not compared") {
    const Folder folder;
    folder.write("main.lua",
                 "world.ball = Body { Circle {}, friction = 0.9 }\n"
                 "function step() world.ball.friction = world.ball.friction / 2 end\n");
    run(folder, {"4:world.ball.friction=0.5", "5:world.ball.position=vec(1,2)", "6:keep(\"**\")"});
    CHECK_FALSE(contains(run(folder, {}).err, "now gives"));
}

TEST_CASE("a kept reference to an instance that the script makes later is set without a warning") {
    const Folder folder;
    folder.write("main.lua", "world.joint = DistanceJoint {}  world.ball = Body { Circle {} }");
    run(folder, {"2:world.joint.body_b=world.ball", "3:keep(\"**\")"});
    CHECK(output_of_next_run(folder, "print(world.joint.body_b == world.ball)") == "true\n");
    // A reference that still has no target at the end is reported with the path of the property.
    folder.write("main.lua", "world.joint = DistanceJoint {}");
    CHECK(contains(run(folder, {}).err,
                   "world.joint.body_b: refers to \"world.ball\", which does not exist"));
}

TEST_CASE("a kept reference waits for an instance that is made in the same step of the game") {
    const Folder folder;
    folder.write("main.lua",
                 "function make() world.joint = DistanceJoint {} world.ball = Body { Circle {} } "
                 "end after(0.02, make)");
    run(folder, {"4:world.joint.body_b=world.ball", "5:keep(\"**\")"});
    const Outcome outcome =
        run(folder, {}, "after(0.1, function() print(world.joint.body_b == world.ball) end)");
    CHECK(outcome.out == "true\n");
    CHECK_FALSE(contains(outcome.err, "refers to"));
}

TEST_CASE("an instance made directly below the game is kept with everything else") {
    const Folder folder;
    folder.write("main.lua", "world.b = Body { Circle {} }");
    const Outcome kept = run(folder, {"2:game.score=Object{points=3}", "3:world.b.mass=4",
                                      "4:game[\"my x\"]=Object{}", "5:keep(\"**\")"});
    CHECK(contains(kept.out + kept.err, "kept 3 tweaks in main.tweaks.json"));
    CHECK(output_of_next_run(folder, "print(score.points, world.b.mass, game[\"my x\"] ~= nil)") ==
          "3\t4.0\ttrue\n");
}

TEST_CASE("an instance made in the console is kept under its current name and parent") {
    const Folder folder;
    folder.write("main.lua", "world.b = Body {}  game.box = Object {}");
    const Outcome kept =
        run(folder, {"2:world.nb=Body{position=vec(1,2),Circle{name=\"c\"}}",
                     "2:world.j=RevoluteJoint{body_b=world.nb}", "2:box.n=Object{}",
                     "3:world.nb.extra=Object{}", "3:box.friend=world.nb", "4:world.nb.name=\"bb\"",
                     "5:world.bb.mass=7", "5:world.bb.c.name=\"cc\"", "6:world.bb.cc.radius=0.25",
                     "6:box.n:move(world,\"n2\")", "7:keep(\"**\")"});
    INFO(kept.out << kept.err << folder.text("main.tweaks.json"));
    CHECK(contains(kept.out + kept.err, "kept 5 tweaks in main.tweaks.json"));
    CHECK_FALSE(contains(folder.text("main.tweaks.json"), "nb"));
    const std::string all =
        "local b = world.bb print(b.position.x, b.mass, b.cc.radius, b.extra ~= nil, "
        "world.j.body_b == b, box.friend == b, world.n2 ~= nil)";
    CHECK(output_of_next_run(folder, all) == "1.0\t7.0\t0.25\ttrue\ttrue\ttrue\ttrue\n");
    // A later run may change them again.
    const Outcome again = run(
        folder, {"2:world.bb.mass=8", "3:keep(\"**\")", "4:world.bb.name=\"third\"",
                 "5:world.third.cc.name=\"c3\"", "6:world.n2:move(box,\"n3\")", "7:keep(\"**\")"});
    INFO(again.out << again.err << folder.text("main.tweaks.json"));
    CHECK(contains(again.out + again.err, "kept 3 tweaks in main.tweaks.json"));
    const std::string then =
        "local b = world.third print(b.position.x, b.mass, b.c3.radius, b.extra ~= nil, "
        "world.j.body_b == b, box.friend == b, box.n3 ~= nil)";
    CHECK(output_of_next_run(folder, then) == "1.0\t8.0\t0.25\ttrue\ttrue\ttrue\ttrue\n");
}

TEST_CASE("a scene file gets no reference to an instance outside of it") {
    const Folder folder;
    folder.write("main.lua",
                 "scene.load(\"s.json\", world)  world.ball = Body { Circle {} } "
                 "world.sc.own = Body { Circle {} }");
    folder.write("s.json",
                 "{\"fettle_scene\": 1, \"class\": \"Object\", \"name\": \"sc\", \"children\": [\n"
                 "{\"class\": \"RevoluteJoint\", \"name\": \"j\"},\n"
                 "{\"class\": \"Body\", \"name\": \"b\"},\n"
                 "{\"class\": \"Circle\"}]}\n");
    const Outcome kept = run(
        folder,
        {"2:world.sc.j.body_b=world.ball", "2:world.sc.j.body_a=world.sc.b",
         "2:world.sc.b.friend=world.sc.own", "2:world.sc.b.list={world.ball,world.sc.j}",
         "3:world.sc.made=RevoluteJoint{body_a=world.sc.b,body_b=world.ball}",
         "4:world.sc.inner=RevoluteJoint{body_a=world.sc.b}", "4:world.sc.b.late=world.sc.inner",
         "5:world.sc.b.odd=world.sc.made", "6:keep(\"**\")"});
    INFO(kept.out << kept.err << folder.text("s.json") << folder.text("main.tweaks.json"));
    CHECK(contains(kept.out + kept.err, "kept 8 tweaks in "));
    for (const char* inside : {"\"body_a\": \".b\"", "\"inner\"", "\".inner\""})
        CHECK(contains(folder.text("s.json"), inside));
    for (const char* outside : {"ball", "own", "made"})
        CHECK_FALSE(contains(folder.text("s.json"), outside));
    const std::string all =
        "local s = world.sc print(s.j.body_b == world.ball and s.j.body_a == s.b, "
        "s.b.friend == s.own, s.b.list[1] == world.ball and s.b.list[2] == s.j, "
        "s.made.body_a == s.b and s.made.body_b == world.ball, s.inner.body_a == s.b, "
        "s.b.late == s.inner, s.b.odd == s.made)";
    CHECK(output_of_next_run(folder, all) == "true\ttrue\ttrue\ttrue\ttrue\ttrue\ttrue\n");
    // A later value that the scene can contain is kept.
    run(folder, {"2:world.sc.j.body_b=world.sc.b", "3:keep(\"**\")"});
    CHECK(output_of_next_run(folder, "print(world.sc.j.body_b == world.sc.b)") == "true\n");
    CHECK_FALSE(contains(folder.text("main.tweaks.json"), "j.body_b"));
}

}  // namespace keep_run_test
