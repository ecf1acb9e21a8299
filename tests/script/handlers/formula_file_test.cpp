// Formulas of scripts in scene files.

#include <filesystem>
#include <fstream>
#include <iterator>

#include <fettle/property/storage/scene.h>

#include "stage.h"

namespace formula_file_test {

using stage::Stage;

namespace {

std::string saved(Stage& s, const std::string& name, std::vector<std::string>* warnings = nullptr) {
    return fettle::property::scene_text(*s.tree, s.tree->child(s.world, name), warnings);
}

void load(Stage& s, const std::string& text, const std::string& name) {
    fettle::property::load_scene_text(*s.tree, text, "level.json", s.world, name);
}

}  // namespace

TEST_CASE("the text of a formula function is found and defines the same formula again") {
    Stage s;
    s.run("world.ball = Body { mass = 2 }");
    s.run(
        "-- function() return 'not me' end\n"
        "local text = [[ function() return 1 end ]]\n"
        "world.shadow = Body {}\n"
        "world.shadow.mass = formula(function()\n"
        "  if world.ball.mass > 3 then return 3 end -- end\n"
        "  for i = 1, 2 do local _ = \"end\" end\n"
        "  return world.ball.mass\n"
        "end)\n");
    std::vector<std::string> warnings;
    const std::string text = saved(s, "shadow", &warnings);
    CHECK(warnings.empty());
    CHECK_THAT(text, contains(R"({"is": "function()\n  if world.ball.mass > 3)") &&
                         contains(R"(\nend", "value": 2})"));
    load(s, text, "copy");
    CHECK(s.prints("world.ball.mass = 7 print(world.copy.mass)") == "3.0");
    s.run("world.copy2 = nil");
    CHECK_THAT(s.console("why('world.copy.mass')"),
               contains("is function() if world.ball.mass > 3 then return 3 end"));
}

TEST_CASE("several functions on one line are distinguished") {
    Stage s;
    s.run(
        "world.ball = Body { mass = 2 } world.shadow = Body {} "
        "world.shadow.a = formula(function() return world.ball.mass end) "
        "world.shadow.b = formula(function() return world.ball.mass + 1 end) "
        "local function named() return 30 end world.shadow.c = formula(named)");
    const std::string text = saved(s, "shadow");
    CHECK_THAT(text,
               contains(R"("a": {"is": "function() return world.ball.mass end", "value": 2.0)"));
    CHECK_THAT(text, contains(R"("b": {"is": "function() return world.ball.mass + 1 end")"));
    CHECK_THAT(text, contains(R"("c": {"is": "function() return 30 end", "value": 30})"));
}

TEST_CASE("the text of a formula is found that has a string over several lines") {
    Stage s;
    s.run(
        "world.shadow = Body {}\n"
        "world.shadow.mass = formula(function() return #'a\\z\n   end' end)");
    CHECK_THAT(saved(s, "shadow"), contains(R"("is": "function() return #'a\\z\n   end' end")"));
}

TEST_CASE("the text of a formula made inside other functions is found") {
    Stage s;
    s.run(
        "world.ball = Body { mass = 2 } world.shadow = Body {}\n"
        "local a, b, c = 1, 2, 3\n"
        "local function make() local _ = a + b + c\n"
        "  return formula(function() return world.ball.mass end) end\n"
        "world.shadow.mass = make()");
    CHECK_THAT(saved(s, "shadow"), contains(R"({"is": "function() return world.ball.mass end")"));
}

TEST_CASE("a formula that uses local variables is saved as its value and names them") {
    Stage s;
    s.run(
        "world.shadow = Body {}\nlocal speed, gain = 3, 2\n"
        "world.shadow.mass = formula(function() return speed * gain end)\n"
        "world.shadow.b = formula(math.random)");
    std::vector<std::string> warnings;
    const std::string text = saved(s, "shadow", &warnings);
    CHECK_THAT(text, contains("\"mass\": 6"));
    REQUIRE(warnings.size() == 2);
    CHECK(warnings[0] ==
          "world.shadow.mass: its formula uses the local variables \"speed\", \"gain\" "
          "of main.lua:3, so it cannot be saved; its value 6 is saved instead");
    CHECK_THAT(warnings[1], contains("is built in"));
}

TEST_CASE("a later text is never used for an older function") {
    Stage s;
    s.run("world.shadow = Body {}");
    s.run("keep_it = function() return 1 end");
    s.run("world.shadow.a = formula(keep_it) other = function() return 2 end");
    std::vector<std::string> warnings;
    const std::string text = saved(s, "shadow", &warnings);
    CHECK_THAT(text, contains("\"a\": 1"));
    REQUIRE(warnings.size() == 1);
    CHECK_THAT(warnings[0], contains("has no text that could be found"));
}

TEST_CASE("a formula with a function of an earlier command is saved with its text") {
    Stage s;
    s.run("world.shadow = Body {}");
    s.console("keep_it = function() return 1 end");
    s.console("world.shadow.a = formula(keep_it) other = function() return 2 end");
    CHECK_THAT(saved(s, "shadow"), contains(R"({"is": "function() return 1 end", "value": 1})"));
}

TEST_CASE("a formula of the console is saved as typed") {
    Stage s;
    s.run("world.ball = Body { mass = 2 } world.shadow = Body {}");
    s.console("world.shadow.mass is world.ball.mass  *  2");
    s.console("world.shadow.serial is function() return 4 end");
    const std::string text = saved(s, "shadow");
    CHECK_THAT(text, contains(R"({"is": "world.ball.mass  *  2", "value": 4})"));
    CHECK_THAT(text, contains(R"({"is": "function() return 4 end", "value": 4})"));
    load(s, text, "copy");
    CHECK(s.console("world.ball.mass = 5") == "world.ball.mass: 2 → 5 kg");
    CHECK(s.console("world.copy.mass") == "10 kg");
    CHECK(s.console("world.copy.serial") == "4");
}

TEST_CASE("a formula text that does not compile is refused with its place in the file") {
    Stage s;
    const auto refusal = [&](const std::string& is) -> std::string {
        try {
            load(s,
                 "{\"fettle_scene\": 1, \"class\": \"Body\",\n \"properties\": {\"mass\": {\"is\": "
                 "\"" +
                     is + "\"}}}",
                 "b");
        } catch (const fettle::property::SceneError& error) {
            return error.what();
        }
        return "";
    };
    CHECK_THAT(refusal("2 *"), contains("level.json:2:32: world.b.mass: the formula ends "
                                        "too early"));
    CHECK_THAT(refusal("function()\\n return ) end"), contains("does not compile: line 2: "));
    CHECK_THAT(refusal(" "), contains("has no text"));
    CHECK(s.prints("print(world:has('b'))") == "false");
}

}  // namespace formula_file_test
