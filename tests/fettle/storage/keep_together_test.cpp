// Tweaks that depend on each other: if one cannot be kept, the other is not kept either, and the
// game starts as before.

#include <catch.h>

#include "keep_run.h"

namespace keep_together_test {

using namespace program_test;

namespace {

struct Game : Folder {
    explicit Game(const std::string& children, const std::string& script = {}) {
        write("main.lua", "scene.load(\"s.json\", world)\n" + script);
        write("s.json",
              "{\"fettle_scene\": 1, \"class\": \"Object\", \"name\": \"top\", \"children\": [\n" +
                  children + "\n]}\n");
    }
};

/// The output of the run; checks that the scene file is unchanged.
std::string kept(const Game& game, std::vector<std::string> commands) {
    const std::string before = game.text("s.json");
    commands.emplace_back("6:keep(\"**\")");
    const std::string out = run(game, commands).out;
    CHECK(game.text("s.json") == before);
    return out;
}

}  // namespace

TEST_CASE("a reference to a new instance that cannot be kept is not kept") {
    for (const char* const last : {R"({"class": "Object"})", R"({"class": "Body"})",
                                   R"({"class": "Object", "name": "last"})"}) {
        const Game game(std::string(R"({"class": "Object", "name": "a"},
            {"class": "Object", "name": "f"}, )") +
                        last);
        const std::string out =
            kept(game, {"1:world.top:add(Object {foo = world.top.f}, \"n\")",
                        "2:world.top.a.foo = world.top.n", "3:world.top.f:move(world.top.n)"});
        CHECK(contains(out, "kept 0 tweaks"));
        CHECK(contains(out, "world.top.a.foo: it depends on world.top.n, which is not kept"));
        CHECK(run(game, {}, "print(world.top.a)").out == "world.top.a\n");
    }
}

TEST_CASE(
    "an instance made below a new instance that cannot be kept is not kept but can be made again") {
    const Game game(R"({"class": "Object", "name": "f"})");
    const std::string out = kept(
        game, {"1:world.top:add(Object {foo = world.top.f}, \"n\")",
               "2:world.top.n:add(Object {v = 7}, \"d\")", "3:world.top.f:move(world.top.n.d)"});
    CHECK(contains(out, "world.top.n.d: it depends on world.top.n, which is not kept"));
    const Outcome again =
        run(game, {"1:reapply_tweaks(\"**\")", "2:print(world.top.n.d.v, world.top.n.foo)"});
    CHECK(contains(again.out, "made again 3 tweaks"));
    CHECK(contains(again.out, "world.top.n.d.f"));
}

TEST_CASE(
    "a name is not kept if it would change the name of an instance that has none in the file") {
    const std::string children = R"({"class": "Object", "name": "object"}, {"class": "Object"})";
    for (const char* const edit :
         {"2:world.top.object.name = \"first\"", "2:world.top.object:move(world.top, \"first\")"}) {
        const Game game(children);
        CHECK(contains(kept(game, {edit}), "an instance beside it has no name in the file"));
    }
    const Game taken(R"({"class": "Object", "name": "a"}, {"class": "Object"})");
    CHECK(contains(kept(taken, {"2:world.top.a.name = \"object_2\""}),
                   "an instance beside it has no name in the file"));
    // An instance of another class never gets this name.
    const Game other(R"({"class": "Object", "name": "a"}, {"class": "Body"})");
    run(other, {"2:world.top.a.name = \"b\"", "3:keep(\"**\")"});
    CHECK(output_of_next_run(other, "print(world.top.b, world.top.body)") ==
          "world.top.b\tworld.top.body\n");
}

TEST_CASE("a name that a script sets is not kept in a file") {
    for (const char* const edit :
         {"2:local t = world.top local a, b = t.a, t.b a.name = \"c\" b.name = \"a\" a.name = "
          "\"b\"",
          "2:world.top.b.name = \"c\" world.top.a.name = \"b\"",
          "2:world.top.b.name = \"c\" world.top:add(Object {v = 9}, \"b\")"}) {
        const Game game(R"({"class": "Object", "name": "a"})",
                        "world.top:add(Object {v = 2}, \"b\")");
        const std::string out = kept(game, {edit});
        CHECK(contains(out, "gives the name to what is"));
        CHECK(run(game, {}, "print(world.top.a, world.top.b.v)").out == "world.top.a\t2\n");
    }
}

}  // namespace keep_together_test
