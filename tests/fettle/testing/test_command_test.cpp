// `fettle test` runs the tests of a game.

#include <catch.h>

#include "program.h"

namespace test_command_test {

using namespace program_test;

namespace {

const char* const game = R"lua(
world.floor = Body { type = "static", position = vec(0, -1), Box { width = 40, height = 2 } }
world.ball = Body { position = vec(0, 4), Circle { radius = 0.5 } }
world.ball.clicks = 0
typed = ""
function key_pressed(key) if key == "space" then world.ball.velocity = vec(0, 5) end end
function mouse_pressed(button, position) if button == "left" then world.ball.clicks = world.ball.clicks + position.x end end
function text_input(text) typed = typed .. text end
store.runs = (store.runs or 0) + 1
)lua";

/// Runs the tests in a file with this text.
Outcome run_tests(const Folder& folder, const std::string& tests,
                  std::vector<std::string> more = {}) {
    folder.write("main.lua", game);
    folder.write("tests/ball.lua", tests);
    std::vector<std::string> arguments = {"test", (folder / "").string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return fettle(folder, arguments);
}

}  // namespace

TEST_CASE("a test that calls wait or test is an error that names its line and the right way") {
    const Folder folder;
    const Outcome run = run_tests(folder, R"lua(
test("waits", function(t) wait(1) end)
test("nests", function(t) test("inner", function() end) end)
test("lets a coroutine wait", function(t)
    local woke = false
    coroutine.wrap(function() wait(0.1) woke = true end)()
    t:wait(0.5)
    expect(woke):truthy()
end)
)lua");
    INFO(run.out << run.err);
    CHECK(contains(run.out, "tests/ball.lua:2: wait: a test waits with t:wait(seconds)"));
    CHECK(contains(run.out, "tests/ball.lua:3: test: a test cannot make another one"));
    CHECK(contains(run.out, "3 tests, 2 failed"));
}

TEST_CASE("tests play the game in fresh runs") {
    const Folder folder;
    const Outcome run = run_tests(folder, R"lua(
test("it falls and lies", function(t)
    t:steps(120)
    expect(time.step):is(120)
    expect(world.ball.position.y):near(0.5, 0.01)
    expect(store.runs):is(1)
    store.runs = 7
    world.ball:delete()
end)
test("keys, mouse and text", function(t)
    expect(store.runs):is(1)
    t:steps(60)
    t:press("space")
    t:steps(1)
    expect(world.ball.velocity.y):above(4)
    expect(input.keys.space):truthy()
    t:release("space")
    t:click(vec(3, 2))
    t:move_mouse(vec(1, 1))
    t:click(vec(2, 2), "right")
    expect(world.ball.clicks):is(3.0)
    t:hold("left", 5)
    t:tap("space")
    t:type("grün €")
    expect(typed):is("grün €")
    expect(time.step):is(73)
end)
test("time and values", function(t)
    t:wait(1)
    local there = world.ball.position
    t:wait(1)
    t:rewind(1)
    expect(time.step):is(60)
    expect(world.ball.position):near(there, 0)
    t:steps(1)
    expect(time.step):is(61)
    t:wait_until(function() return world.ball.position.y < 0.6 end)
    expect({ 1, { x = 2 } }):is({ 1, { x = 2 } })
    expect({ 1, 2 }):contains(2)
    store.rows = { { 1, "a" }, { x = vec(1, 2) } }
    expect(store.rows):is({ { 1, "a" }, { x = vec(1, 2) } })
    expect(store.rows):contains({ 1, "a" })
    expect(store.rows):is_not({ { 1, "a" } })
    game.rows = { { 1, "a" }, { 2, "b" } }
    expect(game.rows):is({ { 1, "a" }, { 2, "b" } })
    expect(game.rows):is_not({ { 1, "a" }, { 2, "c" } })
    expect(game.rows):contains({ 2, "b" })
    expect("abc"):contains("b")
    expect(1):below(2)
    expect(nil):falsy()
    expect(1):is_not(2)
    expect(function() world.bal = world.ball.positon end):fails("did you mean")
end)
)lua");
    INFO(run.out << run.err);
    CHECK(run.status == 0);
    CHECK(run.out ==
          "ok    tests/ball.lua: it falls and lies\n"
          "ok    tests/ball.lua: keys, mouse and text\n"
          "ok    tests/ball.lua: time and values\n"
          "3 tests, 0 failed\n");
    CHECK_FALSE(contains(folder.text("user data/fettle"), "runs"));
}

TEST_CASE("a test may require that the game quits") {
    const Folder folder;
    const Outcome run = run_tests(folder, R"lua(
test("at once", function(t) t:quits(quit) error("not reached") end)
test("by a button", function(t)
    game.menu = Button { text = "Quit", pressed = quit }
    t:steps(1)
    t:quits(function() t:click(game.menu) end)
end)
)lua");
    INFO(run.out << run.err);
    CHECK(run.status == 0);
    CHECK(contains(run.out, "2 tests, 0 failed\n"));
}

TEST_CASE("a failed expectation shows values and line and leaves a recording") {
    const Folder folder;
    const Outcome run = run_tests(folder, R"lua(
test("too high", function(t)
    print("a word")
    t:steps(30)
    expect(world.ball.clicks):is(3)
end)
test("fine", function(t) t:steps(1) end)
)lua");
    INFO(run.out << run.err);
    CHECK(run.status == 1);
    CHECK(contains(run.out,
                   "FAIL  tests/ball.lua: too high\n"
                   "      tests/ball.lua:5: expected 3, got 0\n"));
    CHECK(contains(run.out, "          expect(world.ball.clicks):is(3)\n"));
    CHECK(contains(run.out, "        a word\n"));
    CHECK(contains(run.out, "ok    tests/ball.lua: fine\n2 tests, 1 failed\n"));
    const std::string recording = (folder / ".fettle/tests/ball-too-high.recording").string();
    CHECK(contains(run.out, "fettle run --replay '" + recording + "'"));
    CHECK_FALSE(std::filesystem::exists(folder / ".fettle/tests/ball-fine.recording"));
    const Outcome replay = fettle(folder, {"run", "--replay", recording, "--headless"});
    INFO(replay.out << replay.err);
    CHECK(replay.status == 1);
    CHECK(contains(replay.out, "30 steps, each as it was recorded"));
    CHECK(contains(replay.err, "tests/ball.lua:5: expected 3, got 0"));
}

TEST_CASE("every kind of failure names the line of the test") {
    const Folder folder;
    const auto [body, message] = GENERATE(table<std::string, std::string>({
        {"expect(1):is(2)", ":2: expected 2, got 1"},
        {"expect(0.1 + 0.2):is(0.3)", "expected 0.3, got 0.30000000000000004"},
        {"expect('a'):is({ 1, x = 'b' })", "expected {1, [\"x\"] = \"b\"}, got \"a\""},
        {"expect(1):is_not(1)", "expected anything but 1"},
        {"expect(1):near(2, 0.5)", "expected 2, got 1, which is 1 away; 0.5 is allowed"},
        {"expect('a'):near(2)", "near compares two numbers or two vecs"},
        {"expect(0 / 0):near(0)", "expected 0, got "},
        {"expect(1):above(1)", "expected more than 1, got 1"},
        {"expect('a'):below(1)", "expected less than 1, got \"a\""},
        {"expect(false):truthy()", "expected a value that is true, got false"},
        {"expect(1):falsy()", "expected false or nil, got 1"},
        {"expect('abc'):contains('d')", "expected \"d\" in \"abc\""},
        {"expect(function() end):fails()", "expected an error, and there was none"},
        {"expect(function() error('a') end):fails('zz')", "expected an error with \"zz\", got"},
        {"expect()", "expect: needs the value that is tested"},
        {"expect(1):equals(1)", ":2: expect has no equals; it has above, below"},
        {"t:step(1)", ":2: t has no step; it has click"},
        {"t:steps('x')", ":2: t:steps needs a number of steps, not \"x\""},
        {"t:steps(1.5)", ":2: t:steps needs a number of steps, a whole one, not 1.5"},
        {"t:hold('space', 0.5)", ":2: t:hold needs a key and a number of steps, a whole one"},
        {"expect(1).is(2)", ":2: is: call it with a colon, as in expect(x):is(...)"},
        {"t:press('spce')", ":2: input.keys.spce: no such name (did you mean \"space\"?)"},
        {"t:wait_until(function() end, 1)",
         ":2: what the test waits for did not come true within 1 s"},
        {"world.ball.positon = 1", "did you mean \"position\""},
        {"test('inner', 1)", "test: the second argument is the function of the test"},
        {"t:steps(9) world.b = Body {} local b = world.b t:steps(9) t:rewind(0.2) print(b.mass)",
         ":2: the Body was deleted at step"},
        {"quit()  t:steps(1)", "the game called quit() before the test ended"},
        {"t:quits(function() t:steps(3) end)", "the game did not call quit()"},
        {"t:quits(quit())", "t:quits needs a function after which the game calls quit(), not nil"},
    }));
    const Outcome run = run_tests(folder, "test('it', function(t)\n    " + body + "\nend)\n");
    INFO(body << "\n" << run.out << run.err);
    CHECK(run.status == 1);
    CHECK(contains(run.out, message));
}

TEST_CASE("a click on a widget that the player cannot click is an error") {
    const Folder folder;
    const std::string menu =
        "local pressed = false test('it', function(t) game.menu = Panel { size = vec(400, 300), "
        "Column { Button { name = 'go', text = 'Go', pressed = function() pressed = true end } } }";
    const auto [body, message] = GENERATE(table<std::string, std::string>({
        {"game.menu.column.visible = false t:click(game.menu.column.go)",
         ":2: t:click: menu.column.go cannot be seen: menu.column.visible is false"},
        {"game.menu.offset = vec(5000, 0) t:click(game.menu.column.go)",
         ":2: t:click: menu.column.go cannot be seen: its middle"},
        {"t:click(game.menu.column.children)",
         ":2: t:click: needs a point of the world or a widget, not a function"},
        {"t:move_mouse(nil)", ":2: t:move_mouse: needs a point of the world or a widget, not nil"},
        {"t:move_mouse(Button {})", ":2: t:move_mouse: (detached button) cannot be seen"},
        {"game.over = Panel { modal = true, size = vec(400, 300) } t:click(game.menu.column.go)",
         ":2: t:click: the click did not reach menu.column.go"},
    }));
    const Outcome run = run_tests(folder, menu + "\n    " + body + "\nend)\n");
    INFO(body << "\n" << run.out << run.err);
    CHECK(run.status == 1);
    CHECK(contains(run.out, message));
    const Outcome good =
        run_tests(folder, menu + " t:click(game.menu.column.go) expect(pressed):truthy() end)");
    INFO(good.out << good.err);
    CHECK(good.status == 0);
}

TEST_CASE("an error of the game fails the test with its traceback") {
    const Folder folder;
    folder.write("main.lua", "");
    const Outcome run = run_tests(folder, R"lua(
test("it", function(t)
    after(0.1, function() local none = nil; print(none.x) end)
    t:steps(60)
end)
)lua");
    INFO(run.out << run.err);
    CHECK(run.status == 1);
    CHECK(contains(run.out, "tests/ball.lua:3: attempt to index a nil value"));
    CHECK(contains(run.out, "1 test, 1 failed"));
}

TEST_CASE("a test fails if the game misses a file") {
    const Folder folder;
    const Outcome run = run_tests(folder, R"lua(
test("x", function(t) world.level = Tilemap { map = "none.tmj" } t:steps(2) end)
)lua");
    INFO(run.out << run.err);
    CHECK(run.status == 1);
    CHECK(contains(run.out, "world.level.map: there is no file \"none.tmj\""));
}

TEST_CASE("a native module that ends the process within a test fails the tests") {
    const Folder folder;
    std::filesystem::copy_file(FETTLE_TEST_MODULES "/thrower.so", folder / "own.so");
    folder.write("modules.json", R"({"modules": ["./own.so"]})");
    const Outcome run = run_tests(folder, R"lua(
test("ends", function(t)
    game.one = Fragile { fails = "exit" }
    t:steps(2)
end)
)lua");
    INFO(run.out << run.err);
    CHECK(run.status == 1);
    CHECK(contains(run.err,
                   "tests/ball.lua: ends: the process was ended: a native module or a "
                   "library called exit()"));
}

TEST_CASE("a test that never ends is stopped", "[long]") {
    const Folder folder;
    const Outcome run = run_tests(folder, R"lua(
test("steps", function(t) while true do t:steps(1) end end)
test("loops", function(t) while true do end end)
test("after", function(t) end)
)lua",
                                  {"--timeout", "1"});
    INFO(run.out << run.err);
    CHECK(run.status == 1);
    CHECK(contains(
        run.out,
        "FAIL  tests/ball.lua: steps\n      the test did not end within 1 s of processor time"));
    CHECK(contains(run.out, "FAIL  tests/ball.lua: loops\n"));
    CHECK(contains(run.out, "ok    tests/ball.lua: after\n3 tests, 2 failed\n"));
}

TEST_CASE("tests are chosen by a part of their names") {
    const Folder folder;
    const char* const tests = R"lua(
test("red", function(t) end)
test("green", function(t) expect(1):is(2) end)
)lua";
    const Outcome red = run_tests(folder, tests, {"--filter", "red"});
    CHECK(red.status == 0);
    CHECK(red.out == "ok    tests/ball.lua: red\n1 test, 0 failed\n");
    CHECK(run_tests(folder, tests, {"--filter", "ball"}).status == 1);
    const Outcome none = run_tests(folder, tests, {"--filter", "blue"});
    CHECK(none.status == 1);
    CHECK(contains(none.out, "no test has \"blue\""));
}

TEST_CASE("what a passing test prints is shown on request") {
    const Folder folder;
    const char* const tests = R"lua(
test("good", function(t) print("seen", 1) end)
test("bad", function(t) print("here") error("wrong", 0) end)
test("quiet", function(t) end)
)lua";
    const Outcome usual = run_tests(folder, tests);
    INFO(usual.out);
    CHECK(contains(usual.out, "ok    tests/ball.lua: good\nFAIL  tests/ball.lua: bad\n"));
    CHECK(contains(usual.out, "      it printed\n        here\n"));
    const Outcome all = run_tests(folder, tests, {"--output"});
    INFO(all.out);
    CHECK(
        contains(all.out, "ok    tests/ball.lua: good\n      it printed\n        seen\t1\nFAIL "));
    CHECK(contains(all.out, "      it printed\n        here\n"));
    CHECK(contains(all.out, "ok    tests/ball.lua: quiet\n3 tests, 1 failed\n"));
}

TEST_CASE("a report for build servers names the failed tests") {
    const Folder folder;
    const Outcome run = run_tests(folder, R"lua(
test("a < b & c", function(t) expect("<"):is(">") end)
test("fine", function(t) end)
)lua",
                                  {"--junit", (folder / "report.xml").string()});
    CHECK(run.status == 1);
    const std::string report = folder.text("report.xml");
    INFO(report);
    CHECK(contains(report, "<testsuite name=\"tests/ball.lua\" tests=\"2\" failures=\"1\""));
    CHECK(contains(report, "name=\"a &lt; b &amp; c\""));
    CHECK(contains(report, "expected &quot;&gt;&quot;, got &quot;&lt;&quot;"));
    CHECK(contains(report, "name=\"fine\" time=\""));
    CHECK(run_tests(folder, "", {"--junit", (folder / "none/x.xml").string()}).status == 3);
}

TEST_CASE("a game or a file that cannot be loaded is one failure") {
    const Folder folder;
    const Outcome file = run_tests(folder, "test('a', function(t) end)\nlocal = 3\n");
    INFO(file.out << file.err);
    CHECK(file.status == 1);
    CHECK(contains(file.out, "FAIL  tests/ball.lua\n      tests/ball.lua:2: "));
    folder.write("main.lua", "error('broken')");
    folder.write("tests/ball.lua", "test('a', function(t) end)");
    const Outcome broken = fettle(folder, {"test", (folder / "").string()});
    CHECK(broken.status == 1);
    CHECK(contains(broken.out, "main.lua:1: broken"));
    CHECK(fettle(folder, {"test", (folder / "none").string()}).status == 3);
}

TEST_CASE("files without tests and in folders of tests are named") {
    const Folder folder;
    folder.write("tests/empty.lua", "");
    folder.write("tests/more/deep.lua", "test('x', function() end)");
    const Outcome run = run_tests(folder, "test('a', function(t) end)");
    INFO(run.out);
    CHECK(run.status == 0);
    CHECK(contains(run.out, "note  tests/empty.lua: it has no test\n"));
    CHECK(contains(run.out, "note  tests/more: only the files in tests itself are run"));
    CHECK(contains(run.out, "1 test, 0 failed"));
}

TEST_CASE("a game without tests is an error that says where they are") {
    const Folder folder;
    folder.write("main.lua", "");
    const Outcome run = fettle(folder, {"test", (folder / "").string()});
    CHECK(run.status == 3);
    CHECK(contains(run.err, "they are in files tests/NAME.lua"));
}

TEST_CASE("a picture is compared where there is a display and skipped elsewhere") {
    const Folder folder;
    const Outcome run =
        run_tests(folder, "test('it', function(t) t:steps(3) t:screenshot('start') end)\n");
    INFO(run.out << run.err);
    CHECK(run.status == 0);
    CHECK(run.out ==
          "ok    tests/ball.lua: it\n"
          "      the picture start was not compared: there is no display\n"
          "1 test, 0 failed\n");
}

TEST_CASE("writes of a test reach no file of the game or of the player") {
    const Folder folder;
    const Outcome run = run_tests(folder, R"lua(
test("it", function(t)
    scene.save("level.json", world.ball)
    save_game("a")
    edit("x", function() world.gravity = vec(0, 1) end)
    t:steps(2)
    expect(#scene.load("level.json"):children()):is(1)
    load_game("a")
    t:steps(1)
end)
)lua");
    INFO(run.out << run.err);
    CHECK(run.status == 0);
    CHECK_FALSE(std::filesystem::exists(folder / "level.json"));
    CHECK_FALSE(std::filesystem::exists(folder / "user data"));
    CHECK_FALSE(std::filesystem::exists(folder / ".fettle/main.tweaks.sqlite"));
}

TEST_CASE("a test has its own saved games and none of the player") {
    const Folder folder;
    folder.write("main.lua", game);
    const std::string path = (folder / "").string();
    REQUIRE(fettle(folder, {"run", path, "--headless", "--steps", "3", "--at",
                            "2:save_game('mine') save_game('other')"})
                .status == 0);
    const Outcome run = run_tests(folder, R"lua(
test("it", function(t)
    expect(#saves()):is(0)
    expect(function() load_game("mine") end):fails("there is no saved game \"mine\"")
    expect(function() delete_save("mine") end):fails("there is no saved game \"mine\"")
    save_game("mine")
    t:steps(2)
    expect(saves()[1].slot):is("mine")
    expect(saves()[1].problem):is(nil)
    delete_save("mine")
    expect(#saves()):is(0)
end)
)lua");
    INFO(run.out << run.err);
    CHECK(run.status == 0);
    CHECK(fettle(folder, {"run", path, "--headless", "--steps", "1", "--eval",
                          "for _, s in ipairs(saves()) do print(s.slot, s.step) end"})
              .out == "mine\t1\nother\t1\n");
}

TEST_CASE("tests with similar names have recordings of their own") {
    const Folder folder;
    folder.write("main.lua", "");
    folder.write("tests/hero.lua", "test('jumps!', function() error('x') end)");
    folder.write("tests/hard/hero.lua", "test('jumps?', function() end)");
    const Outcome run = fettle(folder, {"test", (folder / "").string()});
    INFO(run.out << run.err);
    CHECK(run.status == 1);
    const std::size_t at = run.out.find("--replay ");
    REQUIRE(at != std::string::npos);
    const std::size_t begin = at + 10, end = run.out.find("'\n", at);  // quoted: it has a space
    CHECK(std::filesystem::exists(run.out.substr(begin, end - begin)));
}

}  // namespace test_command_test
