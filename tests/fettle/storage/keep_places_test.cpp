// Files that refer to other files, to instances of scripts, and to scenes that are loaded several
// times.

#include <catch.h>

#include "keep_run.h"

namespace keep_places_test {

using namespace program_test;

namespace {

constexpr const char* two =
    "{\"fettle_scene\": 1, \"class\": \"Object\", \"name\": \"l\", \"children\": [\n"
    "  {\"class\": \"Body\", \"name\": \"a\"},\n"
    "  {\"class\": \"Body\", \"name\": \"c\"},\n"
    "  {\"class\": \"WeldJoint\", \"name\": \"j\", \"properties\": {\n"
    "    \"body_a\": \".a\", \"body_b\": \"world.l.c\"}}\n"
    "]}\n";

struct Game : Folder {
    explicit Game(const std::string& script = {}) {
        write("main.lua", "scene.load(\"l.json\", world)\n" + script);
        write("l.json", two);
    }
};

}  // namespace

TEST_CASE("a scene file that refers to its instances from the root gets their new names") {
    const auto joined = [](const std::string& edit, const std::string& joint) {
        const Game game;
        run(game, {"2:" + edit, "3:keep(\"**\")"});
        return output_of_next_run(game, "print(" + joint + ".body_a, " + joint + ".body_b)");
    };
    CHECK(joined("world.l.name=\"m\"", "world.m.j") == "world.m.a\tworld.m.c\n");
    CHECK(joined("world.l.c.name=\"cc\"", "world.l.j") == "world.l.a\tworld.l.cc\n");
    CHECK(joined("world.l.c:delete()", "world.l.j") == "world.l.a\tnil\n");
    CHECK(joined("world.l.a.name=\"x\" world.l.c.name=\"a\" world.l.x.name=\"c\"", "world.l.j") ==
          "world.l.c\tworld.l.a\n");
}

TEST_CASE("a scene file that refers to instances of another one gets their new names") {
    const Game game("scene.load(\"b.json\", world)");
    game.write("b.json",
               "{\"fettle_scene\": 1, \"class\": \"WeldJoint\", \"name\": \"b\",\n"
               "  \"properties\": {\"body_a\": \"world.l.a\"}}\n");
    const std::string before = game.text("b.json");
    const std::string joint = "print(world.b.body_a)";
    SECTION("renamed") {
        run(game, {"2:world.l.a.name=\"aa\"", "3:keep(\"**\")"});
        CHECK(output_of_next_run(game, joint) == "world.l.aa\n");
    }
    SECTION("deleted and not restored") {
        run(game, {"2:world.l.a:delete()", "3:keep(\"**\")", "4:print(1)"});
        CHECK(output_of_next_run(game, joint) == "nil\n");
    }
    SECTION("deleted and restored in one run") {
        run(game, {"2:world.l.a:delete()", "3:keep(\"**\")", "4:undo()", "5:keep(\"**\")"});
        CHECK(game.text("b.json") == before);
        CHECK(output_of_next_run(game, joint) == "world.l.a\n");
    }
}

TEST_CASE("a kept deletion does not delete another instance that gets the name") {
    const Game game("world.ball = Body {}");
    const Outcome kept =
        run(game, {"1:world.ball:delete()", "3:world.l.name=\"ball\"", "6:keep(\"**\")"});
    CHECK(contains(kept.out, "a script gives the name to what was deleted: choose another one"));
    CHECK(run(game, {}, "print(world.l, world:has(\"ball\"))").out == "world.l\tfalse\n");
}

TEST_CASE("of two contradictory moves of two runs one is kept and the other is reported") {
    const Game game;
    run(game, {"1:world.a = Object {}", "1:world.b = Object {}", "3:keep(\"**\")"});
    run(game, {"1:world.a:move(world.b)"});
    run(game, {"1:world.b:move(world.a)"});
    const Outcome kept = run(game, {"2:keep(\"**\")"});
    CHECK(kept.status == 0);
    CHECK(contains(kept.out, "would be moved below itself"));
    CHECK(contains(kept.out, "kept 1"));
}

TEST_CASE("any name can be kept and none has a special meaning") {
    const auto kept = [](const std::string& script, const std::vector<std::string>& edits,
                         const std::string& look) {
        const Game game(script);
        const Outcome first = run(game, edits);
        INFO(first.out << first.err);
        return output_of_next_run(game, look);
    };
    // Instances in the place of a renamed one, and below an instance with an unusual name.
    for (const char* const name : {"my_new_ball", "_new_", "_deleted_3", "_in_between_1",
                                   "\\\\000x", "a.b", "[1]", "[\\\"\\\"]"}) {
        const std::string n = name;
        INFO(n);
        const std::string l = "local l = world.l local n = \"" + n + "\" ";
        CHECK(kept("",
                   {"2:" + l + "l.a.name = n", "3:" + l + "l[n].angle = 1 l.a = Body {mass = 3}",
                    "4:" + l + "l.j.body_b = l.a", "5:keep(\"**\")"},
                   l + "print(l[n].angle, l.a.mass, l.j.body_a == l[n], l.j.body_b == l.a)") ==
              "1.0\t3.0\ttrue\ttrue\n");
        CHECK(kept("world[\"" + n + "\"] = Object {} world[\"" + n + "\"].b = Body {}",
                   {"2:" + l + "local top = world[n] top.b.mass = 5 top.c = Body {mass = 7}",
                    "3:keep(\"**\")"},
                   l + "print(world[n].b.mass, world[n].c.mass)") == "5.0\t7.0\n");
        CHECK(kept("world[\"" + n + "\"] = Body {} world.j = WeldJoint {}",
                   {"2:" + l + "world.j.body_a = world[n]", "3:" + l + "world.l.j.body_a = nil",
                    "4:keep(\"**\")"},
                   l + "print(world.j.body_a == world[n], world.l.j.body_a)") == "true\tnil\n");
    }
    // Two instances that exchange their names while others have the names that could be used in
    // between.
    CHECK(kept("",
               {"2:world.l._in_between_1 = Body {}", "3:keep(\"**\")",
                "4:world.l.a.name = \"x\" world.l.c.name = \"a\" world.l.x.name = \"c\"",
                "5:keep(\"**\")"},
               "print(world.l.j.body_a, world.l.j.body_b, world.l:has(\"_in_between_1\"))") ==
          "world.l.c\tworld.l.a\ttrue\n");
}

TEST_CASE("a scene that is loaded by an edit is kept as a copy with the instances made in it") {
    const Game game;
    run(game, {"1:world.k = scene.load(\"l.json\")", "2:world.k.a.c = Circle {}",
               "3:world.k.q = Body {}", "4:keep(\"**\")"});
    CHECK(game.text("l.json") == two);
    CHECK(output_of_next_run(game, "print(world.k.a.c, world.k.q, world.l:has(\"q\"))") ==
          "world.k.a.c\tworld.k.q\tfalse\n");
}

TEST_CASE("keeping a value of a scene that is loaded twice reports that it has one value") {
    const Game game("scene.load(\"l.json\", world, \"m\")");
    const Outcome kept =
        run(game, {"1:world.l.a.angle=1", "2:world.m.a.angle=2", "3:keep_for_all(\"**\")"});
    INFO(kept.out);
    CHECK(contains(kept.out, "world.m.a.angle: l.json is the scene of world.l.a.angle as well"));
}

TEST_CASE("a value that another value of the file forbids is not kept and reported") {
    const Game game;
    run(game, {"1:world.l.a.velocity=vec(1, 0)", "2:keep(\"**\")", "3:world.l.a.type=\"static\"",
               "4:keep(\"**\")"});
    const Outcome next_run = run(game, {}, "print(world.l.a.type, world.l.c)");
    CHECK(next_run.status == 0);
    CHECK(contains(next_run.out, "static\tworld.l.c"));
    CHECK(contains(next_run.out + next_run.err, "a static body does not move"));
}

TEST_CASE("a child followed by a comma on the next line is deleted") {
    const Game game;
    game.write("l.json",
               "{\"fettle_scene\": 1, \"class\": \"Object\", \"name\": \"l\", \"children\": "
               "[\n  {\"class\": \"Body\", \"name\": \"a\"}\n, {\"class\": \"Body\", "
               "\"name\": \"c\"}\n, {\"class\": \"Body\", \"name\": \"d\"}\n]}\n");
    run(game, {"1:world.l.a:delete()", "2:keep(\"**\")", "3:world.l.d:delete()", "4:keep(\"**\")"});
    CHECK(output_of_next_run(game, "print(#world.l:children(), world.l.c)") == "1\tworld.l.c\n");
}

TEST_CASE("a value derived from a kept formula is right before the first step") {
    const Folder game;
    game.write("main.lua",
               "time.paused = true world.s = Body { Circle { radius = 0.5 } } "
               "world.foo = Body { Box {} }");
    run(game, {"2:world.foo.box.density is world.s.mass", "3:keep(\"**\")"});
    CHECK(contains(run(game, {"1:world.foo.mass"}).out, "0.7853982 kg"));
}

TEST_CASE("an instance that was deleted below another one stays deleted when that is restored") {
    const Game game("world.s = Object { h = Object {} }");
    run(game, {"1:world.s.h:delete()", "2:world.s:delete()", "3:keep(\"**\")", "4:undo()",
               "5:keep(\"**\")"});
    CHECK(output_of_next_run(game, "print(world.s, world.s:has(\"h\"))") == "world.s\tfalse\n");
    // The same for an instance that was made by an edit in an earlier run.
    run(game, {"1:world.s.k = Object {}", "2:keep(\"**\")"});
    run(game, {"1:world.s.k:delete()", "2:world.s:delete()", "3:keep(\"**\")", "4:undo()",
               "5:keep(\"**\")"});
    CHECK(output_of_next_run(game, "print(world.s, world.s:has(\"k\"))") == "world.s\tfalse\n");
}

TEST_CASE("a kept deletion below one of two instances of a scene file leaves the other as it is") {
    const Folder folder;
    const std::string level =
        "{\"fettle_scene\": 1, \"class\": \"Object\", \"name\": \"lvl\", \"children\": [\n"
        "{\"class\": \"Object\", \"name\": \"d\", \"ad_hoc\": {\"k\": 1}},\n"
        "{\"class\": \"Object\", \"name\": \"e\", \"ad_hoc\": {\"k\": 2}}]}\n";
    folder.write("lvl.json", level);
    folder.write(
        "main.lua",
        "for i = 1, 2 do scene.load('lvl.json', world) end "
        "function all() local names = {} for _, top in ipairs({world.lvl, world.lvl_1}) do "
        "for _, each in ipairs(top:children()) do names[#names + 1] = top.name .. '.' .. "
        "each.name end end return table.concat(names, ' ') end");
    SECTION("of one") {
        const Outcome kept = run(folder, {"2:world.lvl_1.d:delete()", "3:keep('**')"});
        INFO(kept.out);
        CHECK(folder.text("lvl.json") == level);
        CHECK(output_of_next_run(folder, "print(all())") == "lvl.d lvl.e lvl_1.e\n");
        // It is brought back and kept again.
        run(folder, {"2:world.lvl_1.e:delete()", "3:keep('**')", "4:undo()", "5:keep('**')"});
        CHECK(output_of_next_run(folder, "print(all())") == "lvl.d lvl.e lvl_1.e\n");
    }
    SECTION("of both while a value of another is kept, too") {
        const Outcome kept = run(folder, {"2:world.lvl.d:delete()", "3:world.lvl_1.d:delete()",
                                          "4:world.lvl_1.e.k = 5", "5:keep('**')"});
        INFO(kept.out);
        CHECK(contains(kept.out, "kept 3 tweaks"));
        CHECK(output_of_next_run(folder, "print(all(), world.lvl_1.e.k)") == "lvl.e lvl_1.e\t5\n");
    }
    SECTION("of a new instance") {
        run(folder, {"2:world.lvl.f = Object {}", "3:keep('**')"});
        CHECK(folder.text("lvl.json") == level);
        CHECK(output_of_next_run(folder, "print(all())") == "lvl.d lvl.e lvl.f lvl_1.d lvl_1.e\n");
    }
    SECTION("in a later run") {
        run(folder, {"2:world.lvl.d:delete()"});
        run(folder, {"2:keep('**')"});
        CHECK(folder.text("lvl.json") == level);
        CHECK(output_of_next_run(folder, "print(all())") == "lvl.e lvl_1.d lvl_1.e\n");
    }
}

TEST_CASE("a value that was edited on one of several instances of a scene is kept for this one") {
    const Game game("scene.load(\"l.json\", world, \"m\") scene.load(\"l.json\", world, \"n\")");
    const std::string angles = "print(world.l.a.angle, world.m.a.angle, world.n.a.angle)";
    SECTION("and the answer says so") {
        const Outcome kept = run(game, {"1:world.m.a.angle=1", "3:keep(\"**\")"});
        INFO(kept.out);
        CHECK(contains(kept.out, "kept 1 tweak in main.tweaks.json"));
        CHECK(contains(kept.out,
                       "world.m.a.angle: for one of 3 instances of l.json only; keep_for_all "
                       "writes into l.json, for all of them"));
        CHECK(game.text("l.json") == two);
        CHECK(output_of_next_run(game, angles) == "0.0\t1.0\t0.0\n");
    }
    SECTION("two of them with two values") {
        const Outcome kept =
            run(game, {"1:world.m.a.angle=1", "2:world.l.a.angle=2", "3:keep(\"**\")"});
        INFO(kept.out);
        CHECK(contains(kept.out, "kept 2 tweaks in main.tweaks.json"));
        CHECK(contains(kept.out, "world.m.a.angle and 1 more: each for one of 3 instances"));
        CHECK(output_of_next_run(game, angles) == "2.0\t1.0\t0.0\n");
    }
    SECTION("of the topmost instance") {
        run(game, {"1:world.m.k = 3", "3:keep(\"**\")"});
        CHECK(game.text("l.json") == two);
        CHECK(output_of_next_run(game, "print(world.m.k, world.l:has(\"k\"))") == "3\tfalse\n");
    }
    SECTION("a formula") {
        run(game, {"1:world.m.a.angle is world.l.c.angle + 2", "3:keep(\"**\")"});
        CHECK(game.text("l.json") == two);
        CHECK(output_of_next_run(game, angles) == "0.0\t2.0\t0.0\n");
    }
    SECTION("a reference within the scene") {
        run(game, {"1:world.m.j.body_b = world.m.a", "3:keep(\"**\")"});
        CHECK(game.text("l.json") == two);
        CHECK(output_of_next_run(game, "print(world.m.j.body_b, world.l.j.body_b)") ==
              "world.m.a\tworld.l.c\n");
    }
    SECTION("an edit of an earlier run") {
        run(game, {"1:world.m.a.angle=1"});
        run(game, {"3:keep(\"**\")"});
        CHECK(output_of_next_run(game, angles) == "0.0\t1.0\t0.0\n");
    }
    SECTION("and taken back by undo") {
        run(game, {"1:world.m.a.angle=1", "3:keep(\"**\")", "4:undo()", "5:keep(\"**\")"});
        CHECK(output_of_next_run(game, angles) == "0.0\t0.0\t0.0\n");
    }
    SECTION("but in the file if the others were deleted") {
        const Outcome kept = run(game, {"1:world.l:delete() world.n:delete()",
                                        "2:world.m.a.angle=1", "3:keep(\"world.m.**\")"});
        INFO(kept.out);
        CHECK(contains(kept.out, "kept 1 tweak in l.json"));
        CHECK_FALSE(contains(kept.out, "keep_for_all"));
    }
}

TEST_CASE("keep_for_all writes an edit of one instance of a scene into its file") {
    const Game game("scene.load(\"l.json\", world, \"m\") scene.load(\"l.json\", world, \"n\")");
    const std::string angles = "print(world.l.a.angle, world.m.a.angle, world.n.a.angle)";
    SECTION("a value") {
        const Outcome kept = run(game, {"1:world.m.a.angle=1", "3:keep_for_all world.m.**"});
        INFO(kept.out);
        CHECK(contains(kept.out, "kept 1 tweak in l.json"));
        CHECK(contains(kept.out,
                       "2 other instances come from l.json, and have the change when the file is "
                       "loaded again"));
        CHECK(output_of_next_run(game, angles) == "1.0\t1.0\t1.0\n");
    }
    SECTION("a value that was kept for one instance before") {
        run(game, {"1:world.m.a.angle=1", "3:keep(\"**\")", "4:keep_for_all(\"**\")"});
        CHECK_FALSE(contains(game.text("main.tweaks.json"), "angle"));
        CHECK(output_of_next_run(game, angles) == "1.0\t1.0\t1.0\n");
    }
    SECTION("a deletion and a new instance") {
        run(game, {"1:world.m.a:delete()", "2:world.m.d = Body {}", "3:keep_for_all(\"**\")"});
        CHECK(output_of_next_run(game, "print(world.l:has(\"a\"), world.n.d)") ==
              "false\tworld.n.d\n");
    }
    SECTION("a name") {
        const Outcome kept = run(game, {"1:world.m.a.name=\"arm\"", "5:keep_for_all(\"**\")"});
        INFO(kept.out);
        CHECK(contains(kept.out, "kept 1 tweak in l.json"));
        CHECK(output_of_next_run(game, "print(world.l.arm, world.n.arm)") ==
              "world.l.arm\tworld.n.arm\n");
    }
    SECTION("another parent, which a file can only give one of them") {
        const Outcome kept = run(game, {"1:world.m.a:move(world)", "5:keep_for_all(\"**\")"});
        INFO(kept.out);
        CHECK(contains(kept.out, "world.m.a: another parent cannot be kept for all"));
        CHECK(game.text("l.json") == two);
    }
}

TEST_CASE("a new name or parent of one of several instances of a scene is kept for it alone") {
    const Game game("scene.load(\"l.json\", world, \"m\") scene.load(\"l.json\", world, \"n\")");
    SECTION("a name, with a value of it and another instance in its old place") {
        const Outcome kept = run(game, {"1:world.m.a.name=\"arm\" world.m.arm.angle = 1",
                                        "2:world.m.a = Body {mass = 3}", "3:keep(\"**\")"});
        INFO(kept.out);
        CHECK(contains(kept.out, "kept 3 tweaks in main.tweaks.json"));
        CHECK(contains(kept.out, "and 1 more: each for one of 3 instances of l.json only\n"));
        CHECK(contains(kept.out, "world.m.a: for one of 3 instances of l.json only; keep_for_all"));
        CHECK(game.text("l.json") == two);
        CHECK(contains(game.text("main.tweaks.json"), "\"world.m.a\": \"world.m.arm\""));
        CHECK(output_of_next_run(game,
                                 "print(world.m.arm.angle, world.m.a.mass, world.m.j.body_a, "
                                 "world.l.a.angle, world.n.a.angle)") ==
              "1.0\t3.0\tworld.m.arm\t0.0\t0.0\n");
    }
    SECTION("names that two of its parts exchange") {
        run(game,
            {"1:world.m.a.angle = 1",
             "2:world.m.a.name=\"x\" world.m.c.name=\"a\" world.m.x.name=\"c\"", "3:keep(\"**\")"});
        CHECK(
            output_of_next_run(game, "print(world.m.c.angle, world.m.a.angle, world.m.j.body_a)") ==
            "1.0\t0.0\tworld.m.c\n");
    }
    SECTION("a parent that is new") {
        run(game, {"1:world.g = Object {}", "2:world.m.a:move(world.g, \"arm\")",
                   "3:world.g.arm.angle = 1", "4:keep(\"**\")"});
        CHECK(game.text("l.json") == two);
        CHECK(output_of_next_run(game, "print(world.g.arm.angle, world.m:has(\"a\"), world.l.a)") ==
              "1.0\tfalse\tworld.l.a\n");
    }
    SECTION("a parent that is in no file") {
        const Outcome kept = run(
            game, {"1:world.g = Object {}", "2:world.m.a:move(world.g)", "3:keep(\"world.m.a\")"});
        INFO(kept.out);
        CHECK(contains(kept.out, "world.m.a: it depends on world.g, which is not kept"));
    }
    SECTION("and the name of the next run in place of the first") {
        run(game, {"1:world.m.a.name=\"arm\"", "3:keep(\"**\")"});
        run(game, {"1:world.m.arm.name=\"leg\" world.m.leg.angle = 1", "3:keep(\"**\")"});
        CHECK(output_of_next_run(game, "print(world.m.leg.angle, world.m:has(\"arm\"))") ==
              "1.0\tfalse\n");
        CHECK_FALSE(contains(game.text("main.tweaks.json"), "arm"));
    }
    SECTION("and taken back by undo") {
        run(game, {"1:world.m.a.name=\"arm\"", "3:keep(\"**\")", "4:undo()", "5:keep(\"**\")"});
        CHECK(game.text("main.tweaks.json") == "{\n  \"fettle_tweaks\": 1\n}\n");
        CHECK(output_of_next_run(game, "print(world.m.a)") == "world.m.a\n");
    }
    SECTION("of an earlier run") {
        run(game, {"1:world.m.a.name=\"arm\""});
        run(game, {"3:keep(\"**\")"});
        CHECK(output_of_next_run(game, "print(world.m.arm, world.n.a)") ==
              "world.m.arm\tworld.n.a\n");
    }
    SECTION("and deleted in the next run") {
        run(game, {"1:world.m.a.name=\"arm\"", "3:keep(\"**\")"});
        run(game, {"1:world.m.arm:delete()", "3:keep(\"**\")"});
        CHECK(output_of_next_run(game, "print(#world.m:children(), #world.l:children())") ==
              "2\t3\n");
    }
    SECTION("but no name that the script gives") {
        const Outcome kept = run(game, {"1:world.m.name=\"o\"", "3:keep(\"**\")"});
        INFO(kept.out);
        CHECK(contains(kept.out, "a name or parent that a script gives cannot be kept"));
    }
}

TEST_CASE("another parent of a part of a scene is kept beside the script") {
    const Game game("world.s = Object {}");
    run(game, {"1:world.l.a:move(world.s)", "3:keep(\"**\")"});
    CHECK(game.text("l.json") == two);
    run(game, {"2:world.s.a.angle = 1", "3:keep(\"**\")"});
    CHECK(game.text("l.json") == two);
    CHECK(output_of_next_run(game, "print(world.s.a.angle, world.l.j.body_a)") ==
          "1.0\tworld.s.a\n");
    SECTION("which its former parent may not take with it when that is deleted") {
        run(game, {"1:world.l:delete()", "3:keep(\"**\")"});
        CHECK(output_of_next_run(game, "print(world:has(\"l\"), world.s.a.angle)") ==
              "false\t1.0\n");
    }
    SECTION("which is deleted with its new parent, and another one has its place") {
        run(game, {"1:world.s:delete()", "2:world.l.a = Body {mass = 3}", "3:keep(\"**\")",
                   "4:world.l.a.mass = 4", "5:keep(\"**\")"});
        CHECK(game.text("l.json") == two);
        CHECK(output_of_next_run(game, "print(world:has(\"s\"), world.l.a.mass)") ==
              "false\t4.0\n");
    }
    SECTION("and the game is loaded again with it") {
        const Outcome again =
            run(game, {"1:world.s.a.angle = 2", "3:keep(\"**\")", "4:print(world.s.a.angle)"});
        CHECK(contains(again.out, "kept 1 tweak in main.tweaks.json"));
        CHECK(output_of_next_run(game, "print(world.s.a.angle)") == "2.0\n");
    }
}

TEST_CASE("moves in the file of kept tweaks that are not possible are reported with their lines") {
    const Game game;
    const auto said = [&](const std::string& moved) {
        game.write("main.tweaks.json", "{\"fettle_tweaks\": 1, \"moved\": {\n" + moved + "\n}}\n");
        const Outcome outcome = run(game, {}, "print(#world.l:children(), world.l.a, world.l.c)");
        INFO(moved << "\n" << outcome.out << outcome.err);
        CHECK(contains(outcome.out, "3\tworld.l.a\tworld.l.c"));
        return outcome.out + outcome.err;
    };
    CHECK(contains(said("\"world.l.b\": \"world.l.d\""),
                   "main.tweaks.json:2:1: world.l.b: there is no world.l.b"));
    CHECK(contains(said("\"world.l.a\": \"world.z.a\""), "world.l.a: there is no world.z"));
    CHECK(contains(said("\"world.l.a\": \"world.l.c\""), "world.l.a: "));
    CHECK(contains(said("\"world.l\": \"world.l.c.l\""), "world.l: "));
    CHECK(contains(said("\"world.l.a\": 3"), "expected a path"));
    CHECK(contains(said("\"world.l.a\": \"world.l.x\", \"world.l.c\": \"world.l.x\""),
                   "main.tweaks.json:2:"));
    CHECK(contains(said("\"world.l.a\": \"game\""), "is not a path of names"));
    game.write("main.tweaks.json",
               "{\"fettle_tweaks\": 1, \"moved\": {\"world.l.a\": \"world.l.c.a\", "
               "\"world.l.c\": \"world.l.a.c\"}}\n");
    CHECK(contains(run(game, {}).err, "main.tweaks.json:1:"));
}

TEST_CASE("a new name that was kept is listed with the old and the new name") {
    const Game game;
    const Outcome kept = run(game, {"1:world.l.a.name=\"arm\"", "3:keep(\"**\")", "4:tweaks()"});
    INFO(kept.out);
    CHECK(contains(kept.out, "kept 1 tweak in l.json"));
    CHECK(contains(kept.out, "  world.l.a: moved to world.l.arm   step 0"));
    CHECK(contains(kept.out, "   kept in l.json"));
}

}  // namespace keep_places_test
