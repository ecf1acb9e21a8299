// Calls with a dot in place of a colon, and the other way around.

#include "stage.h"

namespace call_form_test {

using stage::Stage;

TEST_CASE("the error for a call with a dot in place of a colon has the right form") {
    const auto [call, reported] = GENERATE(table<std::string, std::string>({
        {"world.add(Body {})",
         "add: needs an instance, not nil; call it with a colon: "
         "world:add(...)"},
        {"world.ball.delete()", "; call it with a colon: world.ball:delete(...)"},
        {"world.ball.on('touched', print)", "; call it with a colon: world.ball:on(...)"},
        {"world.raycast(vec(0, 0), vec(1, 1))", "; call it with a colon: world:raycast(...)"},
        {"world['ball'].watch('mass', print)", "; call it with a colon: world['ball']:watch(...)"},
        {"print(vec(1, 2).dot(vec(1, 1)))", "; call it with a colon: vec(1, 2):dot(...)"},
        {"local t = every(1, print) t.stop()", "; call it with a colon: t:stop(...)"},
        {"world:all('Body').set('mass', 3)", "; call it with a colon: world:all('Body'):set(...)"},
        {"world.ball.tween('mass', 2, 1)", "; call it with a colon: world.ball:tween(...)"},
        {"world.cat.hit(3)", "(local 'self'); call it with a colon: world.cat:hit(...)"},
        {"math:floor(1.5)", "; call it with a dot: math.floor(...)"},
        {"string:rep('x', 3)", "; call it with a dot: string.rep(...)"},
        {"scene:load('x.json')", "; call it with a dot: scene.load(...)"},
        {"tween:sequence { 1 }", "tween.sequence: takes one list"},
    }));
    Stage s;
    s.run(
        "Cat = class('Cat', Object) { lives = 9 } "
        "function Cat:hit(n) self.lives = self.lives - n end "
        "world.cat = Cat {} world.ball = Body {}");
    INFO(call);
    CHECK_THAT(s.fails(call), contains(reported));
}

TEST_CASE("other errors of methods have no hint about a dot or a colon") {
    const std::string call =
        GENERATE("world:add(3)", "tween(3, 'mass', 1, 1)", "('x'):rep({})", "scene.load(3)",
                 "world.ball.mass = 'x'", "world.ball:tween('none', 1, 1)");
    Stage s;
    s.run("world.ball = Body {}");
    INFO(call);
    CHECK_THAT(s.fails(call), !contains("call it with"));
}

}  // namespace call_form_test
