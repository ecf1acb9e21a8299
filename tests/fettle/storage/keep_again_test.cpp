// Edits that were kept and then undone, moved or replaced: the next run begins with the state of
// the game at the last `keep`.

#include <catch.h>

#include "keep_run.h"

namespace keep_again_test {

using namespace program_test;

namespace {

/// A script that prints the expressions; "-" for an expression with a name that does not exist.
std::string print(const std::vector<std::string>& expressions) {
    std::string script =
        "local all = {} local function add(ok, value) all[#all + 1] = ok and tostring(value) or "
        "\"-\" end ";
    for (const std::string& each : expressions)
        script += "add(pcall(function() return " + each + " end)) ";
    return script + "print(table.concat(all, \" \"))";
}

constexpr const char* loads = "scene.load(\"lvl.json\", world)";
constexpr const char* level =
    "{\"fettle_scene\": 1, \"class\": \"Object\", \"name\": \"lvl\", \"children\": [\n"
    "{\"class\": \"Object\", \"name\": \"d\", \"ad_hoc\": {\"y\": 1}},\n"
    "{\"class\": \"Object\", \"name\": \"e\", \"ad_hoc\": {\"y\": 2}}]}\n";

/// A game that loads the level from a scene file.
struct Level : Folder {
    Level() {
        write("main.lua", loads);
        write("lvl.json", level);
    }
};

/// A game whose script creates the instances.
struct Script : Folder {
    Script() { write("main.lua", "world.n = Object { y = 1, k = Object { y = 2 } }"); }
};

}  // namespace

TEST_CASE("a deletion that was kept can be undone and kept again") {
    const std::string all = print({"world.n.y", "world.n.k.y"});
    SECTION("of an instance of a script with its kept values") {
        const Script folder;
        run(folder, {"2:world.n.k.y=5", "3:keep(\"**\")"});
        const Outcome kept = run(folder, {"2:world.n:delete()", "3:keep(\"**\")", "4:undo()",
                                          "5:tweaks()", "6:keep(\"**\")"});
        INFO(kept.out);
        CHECK(contains(kept.out, "world.n: deleted no longer"));
        CHECK(output_of_next_run(folder, all) == "1 5\n");
        CHECK_FALSE(contains(folder.text("main.tweaks.json"), "deleted"));
    }
    SECTION("of an instance of a scene file which is restored as it was") {
        const Level folder;
        run(folder, {"2:world.lvl.d:delete()", "3:keep(\"**\")", "4:undo()", "5:keep(\"**\")"});
        CHECK(folder.text("lvl.json") == level);
        CHECK(output_of_next_run(folder, print({"world.lvl.d.y", "world.lvl.e.y"})) == "1 2\n");
    }
    SECTION("of an instance made by an edit below an instance of a script or a scene") {
        for (const bool scene : {false, true}) {
            const Level folder;
            const std::string name = scene ? "world.lvl.m" : "world.m";
            run(folder,
                {"2:" + name + "=Object{y=3}", "3:keep(\"**\")", "4:undo()", "5:keep(\"**\")"});
            CHECK(output_of_next_run(folder, print({name})) == "-\n");
            run(folder, {"2:" + name + "=Object{y=3}", "3:keep(\"**\")"});
            run(folder,
                {"2:" + name + ":delete()", "3:keep(\"**\")", "4:undo()", "5:keep(\"**\")"});
            CHECK(output_of_next_run(folder, print({name + ".y"})) == "3\n");
        }
    }
    SECTION("in a later run") {
        const Script folder;
        run(folder, {"2:world.n:delete()", "3:keep(\"**\")", "4:undo()"});
        const Outcome kept = run(folder, {"2:keep(\"**\")"});
        CHECK(contains(kept.out + kept.err, "kept 1 tweak"));
        CHECK(output_of_next_run(folder, all) == "1 2\n");
    }
}

TEST_CASE("a value or name or formula that is set back after it was kept is kept again") {
    for (const char* back : {"undo()", "world.lvl.d.y=1"}) {
        const Level folder;
        run(folder,
            {"2:world.lvl.d.y=5", "3:keep(\"**\")", std::string("4:") + back, "5:keep(\"**\")"});
        CHECK(output_of_next_run(folder, print({"world.lvl.d.y"})) == "1\n");
    }
    for (const char* back : {"undo()", "world.lvl.x.name=\"d\""}) {
        const Level folder;
        run(folder, {"2:world.lvl.d.name=\"x\"", "3:keep(\"**\")", std::string("4:") + back,
                     "5:keep(\"**\")"});
        CHECK(folder.text("lvl.json") == level);
    }
    const Script folder;
    run(folder, {"2:world.n.y is world.n.k.y * 2", "3:keep(\"**\")", "4:undo()", "5:keep(\"**\")"});
    CHECK(output_of_next_run(folder, print({"world.n.y"})) == "1\n");
}

TEST_CASE("an instance that replaces one of a script is kept in its place") {
    const Script folder;
    run(folder, {"2:world.n=Object{u=7}", "3:keep(\"**\")"});
    CHECK(output_of_next_run(folder, print({"world.n.u", "world.n.y", "world.n.k"})) == "7 - -\n");
    // The same if the deletion was kept before.
    const Script other;
    run(other,
        {"2:world.n.k:delete()", "3:keep(\"**\")", "4:world.n.k=Object{u=8}", "5:keep(\"**\")"});
    CHECK(output_of_next_run(other, print({"world.n.y", "world.n.k.y", "world.n.k.u"})) ==
          "1 - 8\n");
}

TEST_CASE("the final names are kept") {
    const std::string ys = print({"world.lvl.d.y", "world.lvl.e.y"});
    SECTION("two instances that exchange their names") {
        const Level folder;
        run(folder, {"2:world.lvl.d.name=\"tmp\"", "3:world.lvl.e.name=\"d\"",
                     "4:world.lvl.tmp.name=\"e\"", "5:keep(\"**\")"});
        CHECK(output_of_next_run(folder, ys) == "2 1\n");
    }
    SECTION("a renaming that was undone") {
        const Level folder;
        const Outcome kept = run(folder, {"2:world.lvl.d.name=\"a\"", "3:world.lvl.a.name=\"b\"",
                                          "4:world.lvl.b.name=\"c\"", "5:undo()", "5:undo()",
                                          "5:undo()", "6:tweaks()", "7:keep(\"**\")"});
        CHECK(contains(kept.out, "nothing was tweaked"));
        CHECK(folder.text("lvl.json") == level);
    }
    SECTION("values set on and below an instance with the new name") {
        const Level folder;
        run(folder, {"2:world.lvl.d.name=\"x\"", "3:world.lvl.x.y=5",
                     "4:world.lvl.x.part=Object{u=1}", "5:world.lvl.x.part.u=2", "6:keep(\"**\")"});
        CHECK(output_of_next_run(folder, print({"world.lvl.x.y", "world.lvl.x.part.u",
                                                "world.lvl.d"})) == "5 2 -\n");
    }
    SECTION("in a later run") {
        const Level folder;
        run(folder, {"2:world.lvl.d.name=\"tmp\"", "3:world.lvl.e.name=\"d\"",
                     "4:world.lvl.tmp.name=\"e\"", "5:world.lvl.e.y=9"});
        const Outcome again = run(folder, {"2:reapply_tweaks(\"**\")"}, ys);
        CHECK(contains(again.out, "made again 3 tweaks"));
        run(folder, {"2:keep(\"**\")"});
        CHECK(output_of_next_run(folder, ys) == "2 9\n");
    }
    SECTION("references in the scene to the renamed instance") {
        const Folder folder;
        folder.write("main.lua", loads);
        folder.write("lvl.json",
                     "{\"fettle_scene\": 1, \"class\": \"Object\", \"name\": \"lvl\", "
                     "\"children\": [\n"
                     "{\"class\": \"Body\", \"name\": \"ball\"},\n"
                     "{\"class\": \"RevoluteJoint\", \"name\": \"j\", \"properties\": "
                     "{\"body_a\": \".ball\"}}]}\n");
        run(folder, {"2:world.lvl.ball.name=\"orb\"", "3:keep(\"**\")"});
        CHECK(output_of_next_run(folder, print({"world.lvl.j.body_a == world.lvl.orb"})) ==
              "true\n");
        CHECK(contains(folder.text("lvl.json"), "\".orb\""));
    }
    SECTION("values set under the new name of an instance of a script") {
        const Script folder;
        const Outcome kept =
            run(folder, {"2:world.n.name=\"m\"", "3:world.m.k.y=6", "4:keep(\"**\")"});
        CHECK(contains(kept.out, "a name or parent that a script gives cannot be kept"));
        CHECK(run(folder, {}, print({"world.n.k.y"})).out == "6\n");
    }
}

TEST_CASE("a new name is not kept if it changes other names in the file or if a script sets it") {
    const Folder folder;
    folder.write("main.lua", "world.boss = scene.load(\"lvl.json\", world, \"own\")");
    const std::string text =
        "{\"fettle_scene\": 1, \"class\": \"Object\", \"name\": \"lvl\", \"children\": [\n"
        "{\"class\": \"Object\"},\n{\"class\": \"Object\"}]}\n";
    folder.write("lvl.json", text);
    const Outcome kept = run(folder, {"2:world.boss.object.name=\"hero\"",
                                      "2:world.boss.name=\"chief\"", "3:keep(\"**\")"});
    INFO(kept.out);
    CHECK(contains(kept.out, "an instance beside it has no name in the file"));
    CHECK(contains(kept.out, "a name or parent that a script gives cannot be kept"));
    CHECK(folder.text("lvl.json") == text);
}

TEST_CASE("instances of earlier runs that are made again can be undone and redone") {
    const Script folder;
    run(folder, {"2:world.m=Object{y=3}", "3:world.n.y=4", "3:world.n.k:delete()"});
    const Outcome undone =
        run(folder, {"2:reapply_tweaks(\"**\")", "3:undo()"},
            "after(0.1, function() " + print({"world.m", "world.n.y", "world.n.k.y"}) + " end)");
    CHECK(contains(undone.out, "- 1 2"));
    const Outcome redone =
        run(folder, {"2:reapply_tweaks(\"**\")", "3:undo()", "4:redo()", "5:keep(\"**\")"});
    CHECK(contains(redone.out, "made again 3 tweaks"));
    CHECK(contains(redone.out, "kept 3 tweaks"));
    CHECK(output_of_next_run(folder, print({"world.m.y", "world.n.y", "world.n.k"})) == "3 4 -\n");
}

TEST_CASE("a reference to an instance that was deleted later is kept as nil") {
    const Script folder;
    run(folder, {"2:world.a=Object{friend=world.n}", "3:world.n:delete()", "4:keep(\"**\")"});
    CHECK(output_of_next_run(folder, print({"world.a.friend", "world.n"})) == "nil -\n");
}

TEST_CASE("an instance made below a kept instance of a scene is kept in that scene") {
    const Folder folder;
    folder.write("main.lua", "after(0.02, function() scene.load(\"lvl.json\", world) end)");
    folder.write("lvl.json", level);
    run(folder, {"4:world.lvl.m=Object{y=3}", "5:keep(\"**\")", "6:world.lvl.m.q=Object{u=4}",
                 "6:world.lvl.m.y=5", "7:keep(\"**\")"});
    INFO(folder.text("lvl.json"));
    const Outcome outcome =
        run(folder, {},
            "after(0.1, function() " + print({"world.lvl.m.y", "world.lvl.m.q.u"}) + " end)");
    CHECK(outcome.out == "5 4\n");
    CHECK(outcome.err.empty());
}

TEST_CASE("a scene that was deleted as a whole is restored by undo") {
    const Level folder;
    run(folder, {"2:world.lvl:delete()", "3:keep(\"**\")", "4:undo()", "5:keep(\"**\")"});
    CHECK(output_of_next_run(folder, print({"world.lvl.d.y", "world.lvl.e.y"})) == "1 2\n");
}

TEST_CASE("an instance that was replaced twice is kept in its final state") {
    const Script folder;
    run(folder, {"2:world.a=Object{y=8}", "3:world.a=Object{y=9}", "4:undo()", "5:keep(\"**\")"});
    CHECK(output_of_next_run(folder, print({"world.a.y"})) == "8\n");
    // The same if the replacement was kept before it was undone.
    for (const char* place : {"world.n", "world.lvl.d"}) {
        const Level other;
        other.write("main.lua", std::string(loads) + " world.n = Object { y = 1 }");
        const std::string name = place;
        run(other, {"2:" + name + "=Object{y=9}", "3:keep(\"**\")", "4:undo()", "5:keep(\"**\")"});
        CHECK(output_of_next_run(other, print({name + ".y"})) == "1\n");
        CHECK(other.text("lvl.json") == level);
    }
}

TEST_CASE("a command that creates and edits and renames is undone and redone as a whole") {
    const Script named;
    run(named, {"2:world.a=Object{} world.a.name=\"w\"", "3:undo()", "4:redo()", "5:keep(\"**\")"});
    CHECK(output_of_next_run(named, print({"world.w", "world.a"})) == "world.w -\n");
    const Script filled;
    run(filled, {"2:world.a=Object{y=1} world.a.b=Object{y=2} world.a.y=11 world.a.b.y=12",
                 "3:undo()", "4:redo()", "5:keep(\"**\")"});
    CHECK(output_of_next_run(filled, print({"world.a.y", "world.a.b.y"})) == "11 12\n");
    const Script deleted;
    const Outcome kept = run(deleted, {"2:world.n.y=5 world.n.k.y=6 world.n:delete()", "3:undo()",
                                       "4:tweaks()", "5:keep(\"**\")"});
    CHECK(contains(kept.out, "nothing was tweaked"));
    CHECK(output_of_next_run(deleted, print({"world.n.y", "world.n.k.y"})) == "1 2\n");
}

TEST_CASE("a later run does not delete an instance that an earlier run has moved out") {
    const Level folder;
    folder.write("main.lua", std::string(loads) + " world.n = Object {}");
    run(folder, {"2:world.lvl.d.part=Object{y=3}", "3:keep(\"**\")"});
    const std::string before = folder.text("lvl.json");
    run(folder, {"2:world.lvl.d.part:move(world.n)", "3:world.lvl.d:delete()"});
    const Outcome kept = run(folder, {"2:keep(\"**\")"});
    INFO(kept.out);
    CHECK(contains(kept.out, "is a part of it in the file, and would go with it"));
    CHECK(folder.text("lvl.json") == before);
}

TEST_CASE("an instance edited after a rewind that restored it is not deleted") {
    const Level folder;
    const Outcome kept = run(folder, {"4:world.lvl.d:delete()", "5:rewind(0.04)",
                                      "6:world.lvl.d.y=5", "7:keep(\"**\")"});
    INFO(kept.out << kept.err);
    CHECK(output_of_next_run(folder, print({"world.lvl.d.y", "world.lvl.e.y"})) == "5 2\n");
}

TEST_CASE("an instance deleted before its parent stays deleted when only the parent is restored") {
    const Script folder;
    run(folder, {"2:world.n.k:delete()", "3:world.n:delete()", "4:keep(\"**\")", "5:undo()",
                 "6:keep(\"**\")"});
    CHECK(output_of_next_run(folder, print({"world.n.y", "world.n.k"})) == "1 -\n");
    // The same for an instance of a script that was replaced by a kept one.
    const Script replaced;
    run(replaced, {"2:world.n=Object{y=3}", "3:keep(\"**\")"});
    run(replaced, {"2:world.n:delete()", "3:keep(\"**\")", "4:undo()", "5:keep(\"**\")"});
    CHECK(output_of_next_run(replaced, print({"world.n.y", "world.n.k"})) == "3 -\n");
}

TEST_CASE(
    "a restored reference has its current target and not the one in the file at its deletion") {
    const char* const names =
        "{\"fettle_scene\": 1, \"class\": \"Object\", \"name\": \"lvl\", \"children\": [\n"
        "{\"class\": \"DistanceJoint\", \"name\": \"j\", \"properties\": {\"body_a\": \".d\"}},\n"
        "{\"class\": \"Body\", \"name\": \"d\"}, {\"class\": \"Body\", \"name\": \"e\"}]}\n";
    const auto named_after = [&](const std::vector<std::string>& between) {
        const Level folder;
        folder.write("lvl.json", names);
        std::vector<std::string> all = {"1:world.lvl.j:delete()", "2:keep(\"**\")"};
        all.insert(all.end(), between.begin(), between.end());
        all.emplace_back("8:keep(\"**\")");
        run(folder, all);
        return output_of_next_run(folder,
                                  print({"world.lvl.j.body_a", "world.lvl.d", "world.lvl.x"}));
    };
    CHECK(named_after({"3:undo()", "4:world.lvl.d.name=\"x\""}) == "world.lvl.x - world.lvl.x\n");
    CHECK(named_after({"3:undo()", "4:world.lvl.d:delete()"}) == "nil - -\n");
    CHECK(named_after({"3:undo()", "4:world.lvl.d=Body{}"}) == "nil world.lvl.d -\n");
}

TEST_CASE(
    "a value of a part of a scene is kept with its new parent and the new name of the former one") {
    const Level folder;
    folder.write("main.lua", std::string(loads) + " world.s = Object {}");
    run(folder, {"1:world.lvl.d.k=Object{}", "2:keep(\"**\")"});
    const Outcome kept =
        run(folder, {"1:world.lvl.d.name=\"n\"", "2:world.lvl.n.k:move(world.lvl.e)",
                     "3:world.lvl.e.k.y=world.s", "4:keep(\"**\")"});
    INFO(kept.out);
    CHECK(output_of_next_run(folder, print({"world.lvl.e.k.y", "#world.lvl.n:children()"})) ==
          "world.s 0\n");
}

TEST_CASE("a new instance with the name of one that was renamed is kept as a different instance") {
    const std::string all = print({"world.n.i.y", "world.n.k.y", "world.n.k.u", "world.n.k.b.y"});
    const Script folder;
    run(folder, {"2:world.n.k.name=\"i\"", "3:world.n.k=Object{y=7}", "4:world.n.k.b=Object{y=8}",
                 "5:world.n.k.u=world.n.k.b"});
    const Outcome again = run(folder, {"2:reapply_tweaks(\"**\")", "3:" + all});
    INFO(again.out);
    CHECK(contains(again.out, "2 7 world.n.k.b 8"));
    const Outcome kept = run(folder, {"2:keep(\"**\")"});
    CHECK(contains(kept.out, "change the script"));
    CHECK(run(folder, {}, print({"world.n.k.y", "world.n.i"})).out == "2 -\n");
    // In a scene both can be kept.
    const Level scene;
    run(scene, {"2:world.lvl.d.name=\"i\"", "3:world.lvl.d=Object{y=7}",
                "4:world.lvl.e.u=world.lvl.d", "5:world.lvl.e.w=world.lvl.i", "6:keep(\"**\")"});
    CHECK(output_of_next_run(scene, print({"world.lvl.i.y", "world.lvl.d.y", "world.lvl.e.u",
                                           "world.lvl.e.w"})) == "1 7 world.lvl.d world.lvl.i\n");
}

TEST_CASE("deletions are made again in any order") {
    const Script folder;
    run(folder, {"2:world.n.k:move(world)", "3:world.n:delete()", "4:world.k:delete()"});
    const Outcome again =
        run(folder, {"2:reapply_tweaks(\"**\")", "3:" + print({"world.n", "world.k"})});
    INFO(again.out << again.err);
    CHECK(contains(again.out, "- -"));
    CHECK(contains(again.out, "made again 2 tweaks"));
    // An instance below a new instance that was deleted and restored.
    const Script made;
    run(made, {"2:world.m=Object{}", "3:world.m.c=Object{y=4}", "4:world.m:delete()", "5:undo()"});
    const Outcome made_again =
        run(made, {"2:reapply_tweaks(\"**\")", "3:" + print({"world.m.c.y"})});
    INFO(made_again.out);
    CHECK(contains(made_again.out, "4\n"));
    CHECK_FALSE(contains(made_again.out, "already"));
}

TEST_CASE("a reference in another file is restored with the instance that it names") {
    const Level folder;
    folder.write("main.lua", std::string(loads) + " world.s = DistanceJoint {}");
    folder.write("lvl.json",
                 "{\"fettle_scene\": 1, \"class\": \"Object\", \"name\": \"lvl\", "
                 "\"children\": [{\"class\": \"Body\", \"name\": \"d\"}]}\n");
    run(folder, {"2:world.s.body_a=world.lvl.d", "3:keep(\"**\")"});
    SECTION("after the instance was replaced") {
        run(folder, {"2:world.lvl.d=Body{}", "3:keep(\"**\")", "4:undo()", "5:keep(\"**\")"});
    }
    SECTION("in a new instance that was kept without the reference") {
        run(folder,
            {"2:edit(\"both\", function() world.j = DistanceJoint { body_a = world.lvl.d } end)",
             "3:world.lvl.d:delete()", "4:keep(\"**\")", "5:undo()", "6:keep(\"**\")"});
        CHECK(output_of_next_run(folder, print({"world.j.body_a"})) == "world.lvl.d\n");
    }
    CHECK(output_of_next_run(folder, print({"world.s.body_a"})) == "world.lvl.d\n");
}

TEST_CASE("new instances that moved into each other are kept in their final places") {
    const Script folder;
    run(folder, {"2:world.a=Object{y=1}", "3:world.b=Object{y=2}", "4:keep(\"**\")"});
    run(folder, {"2:world.a:move(world.b)", "3:world.b:move(world.n)", "4:keep(\"**\")"});
    CHECK(output_of_next_run(folder, print({"world.n.b.y", "world.n.b.a.y", "world.a"})) ==
          "2 1 -\n");
}

}  // namespace keep_again_test
