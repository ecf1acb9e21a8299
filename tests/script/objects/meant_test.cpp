// Messages that say what is probably meant.

#include "stage.h"

namespace meant_test {

using stage::Stage;

TEST_CASE("a value of the wrong type is reported with the form that is probably meant") {
    const auto [code, hint] = GENERATE(table<std::string, std::string>({
        {"Body { position = { 1, 2.5 } }", "got list {1, 2.5} (write vec(1, 2.5))"},
        {"Body { position = 3 }", "got integer 3 (write vec(x, y))"},
        {"Body { position = { x = 1, y = 2 } }", "a vector is vec(x, y)"},
        {"Body { color = { 255, 0, 0 } }", "(write color(\"#ff0000\"))"},
        {"Body { color = 0xff8000 }", "(write color(\"#ff8000\"))"},
        {"Body { color = { 0, 1, 0, 1 } }", "(write color(\"#00ff00\"))"},
        {"Body { color = { 255, 0, 0, 1 } }", "(write color(\"#ff0000\"))"},
        {"color(255, 0, 0)", "color.r: 255 is not between 0 and 1 (write color(\"#ff0000\"))"},
        {"color(0, 128, 0, 255)", "color.g: 128 is not between 0 and 1 (write color(\"#008000\"))"},
        {"color(1, 0.5, 0, 255)", "color.a: 255 is not between 0 and 1 (write color("},
        {"Body { mass = '2.5' }", "got text \"2.5\" (write 2.5 without quotes)"},
        {"Body { awake = 0 }", "expected true or false, got integer 0 (write false)"},
        {"world:add(Body {}):nudge(5, 0)", "expected a vec2, got 5, 0 (write vec(5, 0))"},
        {"world:raycast(0, 0)", "expected a vec2, got 0, 0 (write vec(0, 0))"},
        {"Polygon { vertices = vec(1, 2) }",
         "expected a list of vec2, got vec2 vec(1, 2) (write {vec(1, 2)})"},
    }));
    CAPTURE(code);
    Stage s;
    CHECK_THAT(s.fails(code), contains(hint));
    for (const char* const not_obvious :
         {"Body { type = 1 }", "color(-1, 0, 0)", "color(256, 0, 0)", "color(0/0, 0, 0)"})
        CHECK_THAT(s.fails(not_obvious), !contains("(write"));
}

TEST_CASE("a library that names the property does not make a message name it twice") {
    Stage s;
    CHECK(s.fails("world.hull = Polygon {} world.hull.vertices = {}") ==
          "main.lua:1: world.hull.vertices: needs three vertices");
}

TEST_CASE("an unknown name without a similar one is reported with a way to ask whether it exists") {
    Stage s;
    CHECK_THAT(s.fails("if world.player_one then end"),
               contains("no such name; world:has(\"player_one\") asks whether there is one"));
    s.run("assert(not world:has('player_one'))");
}

TEST_CASE("a class has the methods of its instances as functions") {
    Stage s;
    s.run(
        "local Shot = class('Shot', Body) {}\n"
        "local shot = world:add(Shot {})\n"
        "Shot.nudge(shot, vec(1, 0)) assert(shot.position.x == 1)\n"
        "Shot.delete(shot) assert(not shot:alive())");
    CHECK_THAT(s.fails("Body.nudge(world, vec(1, 0))"), contains("a World has no nudge"));
    CHECK_THAT(s.fails("Body.nugde()"), contains("(did you mean \"nudge\"?)"));
    CHECK_THAT(s.fails("Body.delete(Body)"), contains("needs an instance, not a class"));
}

}  // namespace meant_test
