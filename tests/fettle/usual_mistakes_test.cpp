// What a game does by mistake, with the classes of the whole program.

#include <catch.h>

#include "program.h"

namespace usual_mistakes_test {

using namespace program_test;

TEST_CASE("names that other frameworks use lead to the property of the class") {
    const Folder folder;
    const auto [code, hint] = GENERATE(table<std::string, std::string>({
        {"Segment { a = vec(0, 0), b = vec(1, 1) }",
         "Segment has no property \"a\" (did you mean from?)"},
        {"Segment { point_b = vec(0, 0) }", "did you mean to?"},
        {"DistanceJoint { a = world }", "did you mean body_a?"},
        {"Synth { seconds = 1 }", "did you mean decay?"},
        {"Synth { type = 'square' }", "did you mean wave?"},
        {"Chain { loop = true }", "did you mean closed?"},
        {"RevoluteJoint { pivot = vec(0, 0) }", "did you mean anchor_a?"},
        {"Emitter { max_particles = 5 }", "did you mean limit?"},
        {"Body { friction = 1 }", "; its shapes have it, as in Circle { friction = ... }"},
        {"Body { visible = false }", "; its shapes have it, as in Circle { visible = ... }"},
        {"Body { radius = 1 }", "; its shapes have it, as in "},
        {"Sprite { lives = 3 }", "; a property of your own goes into props = { lives = ... }"},
    }));
    INFO(code);
    const Outcome run = run_script(folder, code, 1);
    INFO(run.err);
    CHECK(run.status == 1);
    CHECK(contains(run.err, hint));
}

TEST_CASE("a joint of bodies in two worlds is noted") {
    const Folder folder;
    const Outcome run =
        run_script(folder,
                   "world.a = Body { Circle {} } game.other = World {} "
                   "game.other.b = Body { Circle {} } "
                   "world.j = DistanceJoint { body_a = world.a, body_b = game.other.b }",
                   2);
    CHECK(run.status == 0);
    CHECK(contains(run.err, "world.j does nothing: other.b is in another World"));
}

TEST_CASE("load_game in the event that it causes ends with an error") {
    const Folder folder;
    const Outcome run = run_script(folder,
                                   "game:on('restored', function() load_game('x') end) "
                                   "after(0.1, function() save_game('x') end) "
                                   "after(0.3, function() load_game('x') end)",
                                   200);
    CHECK(run.status == 1);
    CHECK(contains(run.err, "load_game: a handler of the event restored calls it"));
}

TEST_CASE("a handler of restored may go back once more") {
    const Folder folder;
    const Outcome run = run_script(folder,
                                   "local n = 0 "
                                   "game:on('restored', function() n = n + 1 "
                                   "if n == 1 then load_game('x') end end) "
                                   "after(0.1, function() save_game('x') end) "
                                   "every(0.3, function() if n < 6 then load_game('x') end end) "
                                   "after(2, function() print(n) quit() end, { pauses = false })",
                                   2000);
    INFO(run.err);
    CHECK(run.status == 0);
    CHECK(contains(run.out, "6"));
}

TEST_CASE("an error about what takes the place of another names this place") {
    const Folder folder;
    folder.write("bad.tmj", "{ no map");
    const Outcome run = run_script(folder,
                                   "world.m = Tilemap {} "
                                   "world.m = Tilemap { map = 'bad.tmj' } print(world.m.name)",
                                   1);
    CHECK(contains(run.err, "world.m.map: "));
    CHECK_FALSE(contains(run.err, "replacing"));
    CHECK(contains(run.out, "m"));
}

TEST_CASE("a test that presses what is held down gets an error") {
    const Folder folder;
    folder.write("main.lua", "");
    folder.write("tests/all.lua", R"lua(
test("click", function(t) input.mouse.left = true; t:click(vec(0, 0)) end)
test("right", function(t) input.mouse.left = true; t:click(vec(0, 0), "right") end)
test("tap", function(t) t:press("space"); t:tap("space") end)
test("hold", function(t) t:press("space"); t:hold("space", 2) end)
)lua");
    const Outcome run = fettle(folder, {"test", (folder / "").string()});
    INFO(run.out);
    CHECK(
        contains(run.out, "tests/all.lua:2: t:click: left is held down already; release it first"));
    CHECK(contains(run.out, "tests/all.lua:4: t:tap: space is held down already"));
    CHECK(contains(run.out, "tests/all.lua:5: t:hold: space is held down already"));
    CHECK(contains(run.out, "4 tests, 3 failed"));
}

}  // namespace usual_mistakes_test
