// Actions: commands of the player, from keys, buttons and sticks.

#include <catch.h>

#include <string>

#include <fettle/property/snapshot.h>

#include "game.h"

namespace action_test {

using namespace fettle::app;
using fettle::property::Value;
using fettle::property::Vec2;

namespace {

constexpr std::string_view jumper = R"(
    input.actions.jump = { "space", "mouse.left", "gamepad.a" }
    function step()
        local j = input.jump
        if j.pressed then print("+") end
        if j.released then print("-") end
    end
)";

std::string failure(Game& game, const std::string& chunk) {
    game.errors.clear();
    game.runtime.run(chunk, "test");
    return game.errors.empty() ? "" : game.errors.front().message;
}

}  // namespace

TEST_CASE("an action is held while any of its keys or buttons is held") {
    Game game(jumper);
    CHECK_FALSE(game.get("input.jump.held").boolean());
    game.press("space");
    CHECK(game.get("input.jump.held").boolean());
    game.loop.frame(tick);
    game.set("input.mouse.left", true);
    game.release("space");
    CHECK(game.get("input.jump.held").boolean());
    game.set("input.mouse.left", false);
    CHECK_FALSE(game.get("input.jump.held").boolean());
    game.set("input.gamepad_3.button_1", true);
    CHECK(game.get("input.jump.held").boolean());
    CHECK(game.get("input.jump.strength").number() == 1);
}

TEST_CASE("undo and redo bring back and remove the action with its keys") {
    Game game(R"(
        function names()
            local all = {}
            for _, action in ipairs(input:children("Action")) do all[#all + 1] = action.name end
            table.sort(all)
            print(table.concat(all, ","))
        end
        input.actions.old = "o"
        edit("more", function() input.actions.new = "n" end)
        edit("less", function() input.actions.old = nil end)
    )");
    const auto after = [&](const char* command) {
        game.runtime.run(command, "test");
        game.loop.frame(tick);
        const std::string output = game.new_output();
        CHECK(output.find("any more") == std::string::npos);  // no note about what is missing
        game.runtime.run("names()", "test");
        return game.new_output();
    };
    CHECK(after("") == "new");
    CHECK(after("undo()") == "new,old");
    game.press("o");
    CHECK(game.get("input.old.held").boolean());
    CHECK(after("redo()") == "new");
    CHECK(after("undo()") == "new,old");
    CHECK(after("undo()") == "old");
    CHECK(after("redo()") == "new,old");
    game.press("n");
    CHECK(game.get("input.new.held").boolean());
    CHECK(after("redo()") == "new");
    CHECK(game.errors.empty());
}

TEST_CASE("a press is seen in exactly one step") {
    Game game(jumper);
    game.press("space");
    game.loop.frame(3 * tick);  // several steps in one frame
    CHECK(game.new_output() == "+");
    game.loop.frame(tick);
    CHECK(game.new_output() == "");
    game.release("space");
    game.loop.frame(0.1 * tick);  // frames without a step
    game.loop.frame(0.1 * tick);
    CHECK(game.new_output() == "");
    game.loop.frame(tick);
    CHECK(game.new_output() == "-");
    game.press("space");
    game.release("space");  // in the same frame: it is held in one step
    game.loop.frame(tick);
    CHECK(game.new_output() == "+");
    game.loop.frame(tick);
    CHECK(game.new_output() == "-");
    CHECK_FALSE(game.get("input.jump.pressed").boolean());
}

TEST_CASE("a press within a step is seen in the next one") {
    Game game(R"(input.actions.jump = "space"
        function step()
            if time.step == 2 then input.keys.space = true end
            if input.jump.pressed then print(time.step) end
        end)");
    for (int i = 0; i < 6; ++i) game.loop.turn();
    CHECK(game.new_output() == "3");
}

TEST_CASE("a press is seen in exactly one update as well") {
    Game game(R"(input.actions.jump = "space"
        function update() if input.jump.pressed then print("update") end end
        function step() if input.jump.pressed then print("step") end end)");
    game.press("space");
    game.loop.frame(0.1 * tick);
    game.loop.frame(0.1 * tick);
    CHECK(game.new_output() == "update");
    game.loop.frame(2 * tick);
    CHECK(game.new_output() == "step");
}

TEST_CASE("a press in a paused game is seen by update and not again when the game continues") {
    Game game(R"(input.actions.jump = "space"
        function update() if input.jump.pressed then print("update") end end
        function step() if input.jump.pressed then print("step") end end
        function action_pressed(name) print("pressed " .. name) end)");
    game.set("time.paused", true);
    game.press("space");
    game.loop.frame(tick);
    CHECK(game.new_output() == "pressed jump update");
    game.set("time.paused", false);
    game.loop.frame(2 * tick);
    CHECK(game.new_output() == "");
}

TEST_CASE("actions have events and callbacks and formulas") {
    Game game(R"(input.actions.jump = "space"
        input.jump:on("press", function(e) print("event " .. e.instance.name) end)
        input.jump:on("release", function() print("end") end)
        function action_pressed(name) print("+" .. name) end
        function action_released(name) print("-" .. name) end
        game.up = formula(function() return input.jump.held end))");
    game.press("space");
    game.loop.frame(tick);
    CHECK(game.new_output() == "+jump event jump");
    CHECK(game.get("up").boolean());
    game.release("space");
    game.loop.frame(tick);
    CHECK(game.new_output() == "-jump end");
    CHECK_FALSE(game.get("up").boolean());
}

TEST_CASE("new bindings of an action apply at once in a running game") {
    Game game(jumper);
    game.press("k");
    game.runtime.run("input.actions.jump = { 'k' }", "test");
    CHECK(game.get("input.jump.held").boolean());
    game.loop.frame(tick);
    CHECK(game.new_output() == "");  // k was pressed for another purpose
    game.press("space");
    game.release("k");
    game.loop.frame(tick);
    CHECK(game.new_output() == "-");
    game.press("k");
    game.loop.frame(tick);
    CHECK(game.new_output() == "+");
    game.runtime.run("input.actions.jump = nil function step() end", "test");
    CHECK_THAT(failure(game, "print(input.jump)"), contains("no such name"));
    game.runtime.run("input.actions.jump = 'space'", "test");
    CHECK(game.get("input.jump.held").boolean());
}

TEST_CASE("an action that a script sets as held notifies the game like a key") {
    Game game(jumper);
    game.runtime.run("input.jump.held = true", "test");
    game.loop.frame(tick);
    CHECK(game.new_output() == "+");
    CHECK(game.get("input.jump.held").boolean());
    game.runtime.run("input.jump.held = false", "test");
    game.loop.frame(tick);
    CHECK(game.new_output() == "-");
}

TEST_CASE("input.move is a vec of keys and sticks") {
    Game game;
    CHECK(game.get("input.move").vec2() == Vec2(0, 0));
    game.press("d");
    CHECK(game.get("input.move").vec2() == Vec2(1, 0));
    game.press("up");
    CHECK(game.get("input.move").vec2().length() == Approx(1));
    game.press("w");
    CHECK((game.get("input.move").vec2() - Vec2(1, 1).normalized()).length() < 1e-12);
    game.press("a");
    game.loop.frame(tick);
    game.release("up");
    CHECK(game.get("input.move").vec2() == Vec2(0, 1));
    game.release("a"), game.release("d"), game.release("w");
    game.set("input.gamepad_2.left", Vec2(0.1, 0.1));
    CHECK(game.get("input.move").vec2() == Vec2(0, 0));  // within the dead zone
    game.set("input.gamepad_2.left", Vec2(0.6, 0));
    CHECK(game.get("input.move").vec2().x == Approx(0.5));
    game.set("input.gamepad_2.left", Vec2(1, 1));
    CHECK(game.get("input.move").vec2().length() == Approx(1));
    game.runtime.run("input.actions.move = { { 'j', 'l', 'k', 'i' } }", "test");
    CHECK(game.get("input.move").vec2() == Vec2(0, 0));
    game.press("j");
    CHECK(game.get("input.move").vec2() == Vec2(-1, 0));
    game.runtime.run("input.actions.move = nil", "test");
    CHECK(game.get("input.actions.move").list().size() == 4);
}

TEST_CASE("actions have strength and directions of their own") {
    Game game(
        "input.actions.aim = { 'gamepad.right' } "
        "input.actions.gas = { 'gamepad_1.right_trigger', 'gamepad.left_y+' }");
    game.set("input.gamepad_1.right", Vec2(0, -1));
    CHECK(game.get("input.aim.direction").vec2() == Vec2(0, -1));
    CHECK(game.get("input.aim.held").boolean());
    game.set("input.gamepad_1.right_trigger", 0.25);
    CHECK(game.get("input.gas.strength").number() == 0.25);
    CHECK_FALSE(game.get("input.gas.held").boolean());
    game.set("input.gamepad_2.right_trigger", 1.0);
    CHECK(game.get("input.gas.strength").number() == 0.25);
    game.set("input.gamepad_2.left", Vec2(0, 1));
    CHECK(game.get("input.gas.strength").number() == 1);
    game.set("input.gamepad_2.left", Vec2(0, -1));
    CHECK(game.get("input.gas.strength").number() == 0.25);
}

TEST_CASE("bindings that are assigned again make an action that was deleted") {
    Game game(jumper);
    game.runtime.run(
        "input.jump:delete() input.actions.jump = { 'space', 'mouse.left', "
        "'gamepad.a' } input.jump.held = true",
        "test");
    CHECK(game.errors.empty());
    CHECK(game.get("input.jump.held").boolean());
}

TEST_CASE("impossible bindings are refused with the nearest spelling") {
    Game game;
    CHECK_THAT(failure(game, "input.actions.jump = { 'spcae' }"),
               contains("input.actions.jump: no key, button or axis is called \"spcae\" (did you "
                        "mean \"space\"?)"));
    CHECK_THAT(failure(game, "input.actions.jump = 'gamepad_2.left_sholder'"),
               contains("(did you mean \"gamepad.left_shoulder\"?)"));
    CHECK_THAT(failure(game, "input.actions.jump = 'mouse.lefft'"), contains("\"mouse.left\""));
    CHECK_THAT(failure(game, "input.actions.jump = 'return'"), contains("\"enter\""));
    CHECK_THAT(failure(game, "input.actions.jump = ' '"), contains("\"space\""));
    CHECK_THAT(failure(game, "input.actions.jump = { 'mouse1' }"), contains("\"mouse.left\""));
    for (const char* bad : {"'gamepad_5.a'", "'gamepad.button_17'", "'gamepad.'", "'mouse.'", "''",
                            "'gamepad.left_z+'", "'left_x+'"})
        CHECK_THAT(failure(game, "input.actions.jump = " + std::string(bad)),
                   contains("is called"));
    CHECK_THAT(failure(game, "input.actions.jump = 3"), contains("expected names of keys"));
    CHECK_THAT(failure(game, "input.actions.jump = { 3 }"), contains("expected the name of a key"));
    CHECK_THAT(failure(game, "input.actions.jump = { { 'a', 'd' } }"),
               contains("left, right, down, up"));
    CHECK_THAT(failure(game, "input.actions.mouse = 'a'"),
               contains("input.actions.mouse: input has something else of that name"));
    CHECK_THAT(failure(game, "input.actions.move = { 'spcae' }"), contains("\"space\""));
    CHECK_THAT(failure(game, "input.move = vec(1, 0)"), contains("read-only"));
    CHECK_THAT(failure(game, "print(input.jump)"), contains("no such name"));
    CHECK_THAT(failure(game, "input.actions.jump = 'space' input.actions.jump = { 'spcae' }"),
               contains("spcae"));
    CHECK(game.get("input.actions.jump") == Value("space"));
}

TEST_CASE("actions are restored with a snapshot") {
    Game game("input.actions.jump = 'space'");
    const auto taken = game.tree.snapshot();
    game.runtime.run("input.actions.jump = 'k' input.actions.duck = 'c'", "test");
    game.tree.restore(taken);
    game.loop.frame(tick);
    CHECK_THAT(failure(game, "print(input.duck)"), contains("no such name"));
    game.press("k");
    CHECK_FALSE(game.get("input.jump.held").boolean());
    game.press("space");
    CHECK(game.get("input.jump.held").boolean());
    Game other;
    other.tree.restore(taken);
    other.loop.frame(tick);
    other.press("space");
    CHECK(other.get("input.jump.held").boolean());
}

TEST_CASE("services that end with actions leave their tree in order") {
    fettle::property::Tree tree;
    auto services = std::make_unique<Services>(tree);
    const auto actions = fettle::property::resolve(tree, "input.actions").instance;
    tree.set_or_add(actions, "jump", "space");
    CHECK(fettle::property::get(tree, "input.jump.held") == Value(false));
    services.reset();
    CHECK(tree.size() == 1);
}

}  // namespace action_test
