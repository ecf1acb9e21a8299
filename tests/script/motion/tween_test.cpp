// Tweens: values over time, groups, and their end.

#include <fettle/property/path.h>
#include <fettle/property/snapshot.h>

#include "stage.h"

namespace tween_test {

using stage::Handle;
using stage::Stage;
using stage::Value;
using stage::Vec2;

namespace {

/// A stage with `ball`, a body in the world.
struct Game : Stage {
    Game() { run("world.ball = Body {}  ball = world.ball"); }
    double mass() const { return get("world.ball.mass").as_double(); }
    std::size_t tweens() const {
        const Handle all = tree->child(tree->root(), "tweens");
        return all ? tree->child_count(all) : 0;
    }
};

}  // namespace

TEST_CASE("undo of a deletion says that tweens of the instance ended with it") {
    Game s;
    const auto undone = [&] {
        std::string lines;
        for (const std::string& line : s.runtime->evaluate("undo").lines) lines += line + "\n";
        return lines;
    };
    const std::string note =
        "tweens of world.ball ended when it was deleted; they are not brought back";
    s.run("tween(ball, 'mass', 4, 1) tween(ball, 'position', vec(1, 2), 1)");
    s.step(2);
    s.runtime->evaluate("world.ball:delete()");
    s.step(2);
    CHECK(s.tweens() == 0);
    const std::string lines = undone();
    INFO(lines);
    REQUIRE(lines.find(note) != std::string::npos);
    CHECK(lines.find(note) == lines.rfind(note));
    s.runtime->evaluate("world.ball.mass = 7");
    CHECK(undone().find("tweens") == std::string::npos);
}

TEST_CASE("a tween moves a number from its value to another in the given time") {
    Game s;
    s.run("ball.mass = 2 tween(ball, 'mass', 4, 1)");
    CHECK(s.mass() == 2);
    s.step(15);
    CHECK(s.mass() == Approx(2.5));
    s.step(15);
    CHECK(s.mass() == Approx(3));
    s.step(30);
    CHECK(s.mass() == 4);
    CHECK(s.tweens() == 1);
    s.step();
    CHECK(s.tweens() == 0);
}

TEST_CASE("a tween of one component says how the whole value is tweened") {
    Game s;
    const std::string whole =
        "tween the whole value, such as tween(world.ball, \"position\", "
        "vec(3, world.ball.position.y), 1)";
    CHECK_THAT(s.fails("tween(ball, 'position.x', 3, 1)"), contains(whole));
    CHECK_THAT(s.fails("ball:tween('position:x', 3, 1)"), contains(whole));
    CHECK_THAT(s.fails("tween(ball, 'positon.x', 3, 1)"), contains("no property"));
    CHECK_THAT(s.fails("tween(ball.position, 'x', 3, 1)"),
               contains("needs an instance, not a vec: tween(ball, \"position\""));
}

TEST_CASE("a tween takes options after its ease or in the place of it") {
    Game s;
    CHECK(s.prints("local a = tween(ball, 'mass', 3, 1, 'out_quad', { pauses = false, loops = 0 }) "
                   "local b = ball:tween('friction', 0, 1, { alternate = true }) "
                   "print(a.pauses, a.loops, a.ease, b.alternate, b.pauses, b.ease)") ==
          "false\t0\tout_quad\ttrue\ttrue\tlinear");
    const std::size_t before = s.tweens();
    CHECK_THAT(s.fails("tween(ball, 'mass', 3, 1, { loop = 2 })"),
               contains("tween: there is no option \"loop\" (did you mean \"loops\"?)"));
    CHECK_THAT(s.fails("tween(ball, 'mass', 3, 1, 'linear', { loops = 'x' })"),
               contains("loops: expected an integer"));
    CHECK(s.tweens() == before);
}

TEST_CASE("thousands of tweens begin in one step and the last one of a property stays") {
    Game s;
    s.run(
        "for i = 1, 5000 do world:add(Body {}, 'b_' .. i) end "
        "for i = 1, 5000 do tween(world['b_' .. i], 'mass', 3, 1) end "
        "for i = 1, 5000 do tween(ball, 'mass', i, 1) end "
        "tween.sequence { tween(world.b_7, 'mass', 5, 1) }");
    s.step(60);
    CHECK(s.mass() == 5000);
    CHECK(s.get("world.b_5000.mass").as_double() == 3);
    CHECK(s.get("world.b_7.mass").as_double() == 5);
    CHECK(s.tweens() == 5001);
    s.step();
    CHECK(s.tweens() == 0);
}

TEST_CASE("a tween in real time goes on while no step is made") {
    Game s;
    s.run(
        "tween(ball, 'mass', 3, 1).pauses = false "
        "tween.sequence { 0.5, tween(ball, 'friction', 0, 0.5) }.pauses = false "
        "tween(ball, 'color', 'red', 1)");
    for (int i = 0; i < 60; ++i) s.runtime->advance(1.0 / 60);
    CHECK(s.mass() == Approx(3));
    CHECK(s.get("world.ball.friction").as_double() == Approx(0));
    CHECK(s.get("world.ball.color").color().g == Approx(1));
    s.runtime->advance(1.0 / 60);
    CHECK(s.tweens() == 1);
    s.step(30);
    CHECK(s.get("world.ball.color").color().g == Approx(0.5f));
}

TEST_CASE("a tween moves vectors and colors and rounds integers") {
    Game s;
    s.run(
        "ball.position = vec(0, 2) ball.color = color(0, 0, 0, 1) "
        "Cat = class('Cat', Object) { lives = 1, marks = {0.0, vec(0, 0)} } "
        "world.cat = Cat {} "
        "tween(ball, 'position', vec(1, 4), 1) tween(ball, 'color', 'white', 1) "
        "tween(world.cat, 'lives', 9, 1, 'out_quad') tween(world.cat, 'marks', {1, vec(2, 4)}, 1)");
    s.step(30);
    CHECK((s.get("world.ball.position").vec2() - Vec2(0.5, 3)).length() < 1e-12);
    CHECK(s.get("world.ball.color").color().g == Approx(0.5f));
    CHECK(s.get("world.cat.lives") == Value(7));
    const auto marks = s.get("world.cat.marks").list();
    CHECK(marks[0].number() == Approx(0.5));
    CHECK((marks[1].vec2() - Vec2(1, 2)).length() < 1e-12);
    s.step(30);
    CHECK(s.get("world.ball.position").vec2() == Vec2(1, 4));
    CHECK(s.get("world.cat.lives") == Value(9));
}

TEST_CASE("an added property takes numbers between integers") {
    Game s;
    s.run("ball.glow = 0 tween(ball, 'glow', 1, 1)");
    s.step(30);
    CHECK(s.get("world.ball.glow").as_double() == Approx(0.5));
    s.step(30);
    CHECK(s.get("world.ball.glow") == Value(1));
}

TEST_CASE("an added color takes the name of a color") {
    Game s;
    s.run("ball.paint = color('black') tween(ball, 'paint', 'white', 1)");
    s.step(60);
    CHECK(s.prints("print(ball.paint)") == "color(\"#ffffff\")");
    CHECK_THAT(s.fails("tween(ball, 'paint', 'whiter', 1)"),
               contains("there are no values between"));
}

TEST_CASE("every ease begins at 0 and ends at 1") {
    Game s;
    const std::string names = s.prints(
        "for _, name in ipairs(Tween.properties.ease.enumerators) do "
        "ball.mass = 1 local t = tween(ball, 'mass', 2, 1, name ~= 'curve' and name or nil) "
        "print(name) t:stop() end");
    CHECK(std::count(names.begin(), names.end(), '|') == 31);
    for (std::size_t at = 0; at < names.size();) {
        const std::size_t end = std::min(names.find('|', at), names.size());
        const std::string name = names.substr(at, end - at);
        at = end + 1;
        if (name == "curve") continue;
        CAPTURE(name);
        Game game;
        game.run("ball.position = vec(0, 0) tween(ball, 'position', vec(1, 0), 1, '" + name + "')");
        double last = 0, largest = 0;
        for (int i = 0; i < 60; ++i) {
            game.step();
            const double now = game.get("world.ball.position").vec2().x;
            largest = std::max(largest, std::abs(now - last));
            last = now;
        }
        CHECK(last == 1);
        CHECK(largest < 0.3);  // no ease jumps
    }
}

TEST_CASE("each ease follows the curve of its name") {
    const auto half_way = [](const std::string& name, int steps) {
        Game s;
        s.run("ball.position = vec(0, 0) tween(ball, 'position', vec(1, 0), 1, '" + name + "')");
        s.step(steps);
        return s.get("world.ball.position").vec2().x;
    };
    CHECK(half_way("in_quad", 30) == Approx(0.25));
    CHECK(half_way("out_quad", 30) == Approx(0.75));
    CHECK(half_way("in_out_quad", 15) == Approx(0.125));
    CHECK(half_way("in_cubic", 30) == Approx(0.125));
    CHECK(half_way("out_quint", 30) == Approx(1 - 1.0 / 32));
    CHECK(half_way("in_sine", 30) == Approx(1 - std::sqrt(0.5)));
    CHECK(half_way("in_circ", 30) == Approx(1 - std::sqrt(0.75)));
    CHECK(half_way("in_back", 15) < 0);
    CHECK(half_way("out_back", 45) > 1);
    CHECK(half_way("out_bounce", 30) == Approx(0.765625));
    CHECK(half_way("out_elastic", 9) > 1.2);
}

TEST_CASE("an ease may be a function or a list of numbers") {
    Game s;
    s.run(
        "ball.mass = 1 tween(ball, 'mass', 2, 1, function(t) return t * t * t end) "
        "ball.friction = 0 tween(ball, 'friction', 1, 1, {0, 1, 0, 1})");
    s.step(30);
    CHECK(s.mass() == Approx(1.125).epsilon(1e-4));
    CHECK(s.get("world.ball.friction").as_double() == Approx(0.5));
    CHECK_THAT(s.fails("tween(ball, 'mass', 2, 1, function(t) return 'x' end)"),
               contains("tween: an ease gives numbers, not a text"));
    CHECK_THAT(s.fails("tween(ball, 'mass', 2, 1, {1})"), contains("two numbers at least"));
}

TEST_CASE("a tween that is impossible is an error at once") {
    Game s;
    CHECK_THAT(s.fails("tween(ball, 'mass', 2, 1, 'out_qaud')"),
               contains("tween: no ease \"out_qaud\" (did you mean \"out_quad\"?)"));
    CHECK_THAT(s.fails("tween(ball, 'mass', 2, 1, 'elastic')"),
               contains("tween: no ease \"elastic\" (did you mean \"out_elastic\"?)"));
    CHECK_THAT(s.fails("tween(ball, 'mass', 2, 1, 'smoothly')"),
               contains("tween: no ease \"smoothly\"; there are \"linear\", and in_, out_ or "
                        "in_out_ before quad, cubic,"));
    CHECK_THAT(s.fails("tween(ball, 'mas', 2, 1)"), contains("(did you mean \"mass\"?)"));
    CHECK_THAT(s.fails("tween(ball, 'class', 2, 1)"), contains("is read-only"));
    CHECK_THAT(s.fails("tween(ball, 'awake', false, 1)"),
               contains("tween: world.ball.awake: there are no values between true and false"));
    CHECK_THAT(
        s.fails("local w = tween(ball, 'mass', 2, 1) local _, why = pcall(tween, w, 'from', 2, 1) "
                "w:stop() error(why)"),
        contains(".from is nil; assign the value at which the tween begins first"));
    CHECK_THAT(s.fails("tween(ball, 'mass', vec(1, 2), 1)"), contains("expected a number"));
    CHECK_THAT(s.fails("tween(ball, 'mass', 2, -1)"), contains("from 0 to 1e9 s, got -1"));
    CHECK_THAT(s.fails("tween(ball, 'mass', 2, 0/0)"), contains("from 0 to 1e9 s"));
    CHECK_THAT(s.fails("tween('ball', 'mass', 2, 1)"), contains("needs an instance, not a text"));
    CHECK_THAT(s.fails("ball.mass = formula(function() return 3 end) tween(ball, 'mass', 2, 1)"),
               contains("world.ball.mass has a formula"));
    CHECK_THAT(s.fails("tween.sequnce {}"), contains("nil"));
    CHECK(s.tweens() == 0);
}

TEST_CASE("an impossible tween made by its class is an error at the line that makes it") {
    Game s;
    CHECK_THAT(s.fails("Tween { target = ball, property = 'mas', to = 2 }"),
               contains("Tween: world.ball has no property \"mas\" (did you mean \"mass\"?)"));
    CHECK_THAT(s.fails("Tween { target = ball, property = 'mas' }"), contains("\"mas\""));
    CHECK_THAT(s.fails("Tween { target = ball, property = 'class', to = 2 }"),
               contains("is read-only"));
    CHECK_THAT(s.fails("Tween { target = ball, property = 'awake', to = false }"),
               contains("Tween: world.ball.awake: there are no values between true and false"));
    CHECK_THAT(s.fails("Tween { target = ball, property = 'mass', from = vec(1, 2), to = 2 }"),
               contains("expected a number"));
    CHECK_THAT(s.fails("ball.mass = formula(function() return 3 end) "
                       "Tween { target = ball, property = 'mass', to = 2 }"),
               contains("world.ball.mass has a formula"));
    CHECK(s.tweens() == 0);
    // What is not known yet may be assigned later; a pause moves nothing.
    s.run(
        "ball.mass = 1 tween(ball, 'mass', 2, 1):stop() "
        "local t = Tween { property = 'mass', to = 2 } t.target = ball game.tweens:add(t) "
        "game.tweens:add(Tween { seconds = 2 })");
    CHECK(s.tweens() == 2);
}

TEST_CASE("of two tweens of a property the one that begins later wins") {
    Game s;
    s.run("ball.mass = 1 tween(ball, 'mass', 2, 1):on('finished', function() print('first') end)");
    s.step(30);
    s.run("tween(ball, 'mass', 0.5, 0.5):on('finished', function() print('second') end)");
    s.step();
    CHECK(s.tweens() == 1);
    s.step(29);
    CHECK(s.mass() == 0.5);
    s.step(60);
    CHECK(s.mass() == 0.5);
    CHECK(stage::joined(s.printed) == "second");
}

TEST_CASE("a formula that is assigned later ends the tween") {
    Game s;
    s.run("ball.mass = 1 tween(ball, 'mass', 2, 1)");
    s.step(30);
    s.run("ball.mass = formula(function() return 7 end)");
    s.step(2);
    CHECK(s.mass() == 7);
    CHECK(s.tweens() == 0);
    CHECK(s.errors.empty());
}

TEST_CASE("a tween ends with its target") {
    Game s;
    s.run("t = ball:tween('mass', 2, 1) t:on('finished', function() print('finished') end)");
    s.step(10);
    s.run("ball:delete()");
    s.step(100);
    CHECK(s.prints("print(t:alive())") == "false");
    CHECK(s.errors.empty());
}

TEST_CASE("finished is emitted once in the step in which the value is reached") {
    Game s;
    s.run(
        "ball.mass = 1 t = tween(ball, 'mass', 2, 0.5) "
        "t:on('finished', function(e) print(ball.mass, e.instance == t, e.step) end)");
    s.step(29);
    CHECK(s.printed.empty());
    s.step(10);
    CHECK(stage::joined(s.printed) == "2.0\ttrue\t30");
}

TEST_CASE("a tween can be paused and moved and stopped while it runs") {
    Game s;
    s.run("ball.mass = 1 t = tween(ball, 'mass', 2, 1)");
    s.step(15);
    s.run("t.paused = true");
    s.step(15);
    CHECK(s.mass() == Approx(1.25));
    s.run("t.progress = 0.75");
    s.step();
    CHECK(s.mass() == Approx(1.75));
    s.run("ball.mass = 9");
    s.step();
    CHECK(s.mass() == 9);  // it stands still, so it writes nothing
    s.run("t.paused = false t.to = 3 t.seconds = 10");
    s.step();
    CHECK(s.mass() == Approx(2.5 + 0.2 / 60));
    s.run("t:stop()");
    s.step();
    CHECK(s.mass() == Approx(2.5 + 0.2 / 60));
    CHECK(s.tweens() == 0);
}

TEST_CASE("a tween runs several times and goes back in between") {
    Game s;
    s.run(
        "ball.mass = 1 t = tween(ball, 'mass', 2, 0.5) t.loops = 3 t.alternate = true "
        "t:on('finished', function() print('finished') end)");
    s.step(15);
    CHECK(s.mass() == Approx(1.5));
    s.step(15 + 6);
    CHECK(s.mass() == Approx(1.8));
    s.step(24 + 30);
    CHECK(s.mass() == 2);
    CHECK(stage::joined(s.printed) == "finished");
    s.run("u = tween(ball, 'mass', 1, 0.1) u.loops = 0");
    s.step(1000);
    CHECK(s.prints("print(u:alive())") == "true");
}

TEST_CASE("an ease that overshoots stays in the range of the property") {
    Game s;
    s.run("ball.friction = 0.5 tween(ball, 'friction', 0, 1, 'out_back')");
    for (int i = 0; i < 60; ++i) {
        s.step();
        CHECK(s.get("world.ball.friction").as_double() >= 0);
    }
    CHECK(s.errors.empty());
}

TEST_CASE("a sequence runs one after the other with pauses and without gaps") {
    Game s;
    s.run(
        "ball.mass = 1 ball.friction = 0 "
        "g = tween.sequence { tween(ball, 'mass', 2, 0.25), 0.25, tween(ball, 'mass', 4, 0.5) } "
        "g:on('finished', function(e) print('finished', e.step) end)");
    s.step(15);
    CHECK(s.mass() == 2);
    s.step(14);
    CHECK(s.mass() == 2);
    CHECK(s.get("tweens.tween_group_1.progress").as_double() == Approx(29.0 / 60));
    s.step(16);
    CHECK(s.mass() == Approx(3));
    s.step(15);
    CHECK(s.mass() == 4);
    CHECK(stage::joined(s.printed) == "finished\t60");
    s.step();
    CHECK(s.tweens() == 0);
}

TEST_CASE("tweens run together and groups within groups") {
    Game s;
    s.run(
        "ball.mass = 1 ball.friction = 0 ball.position = vec(0, 0) "
        "tween.sequence { "
        "  tween.parallel { tween(ball, 'mass', 2, 0.5), tween(ball, 'friction', 1, 1) }, "
        "  tween(ball, 'position', vec(1, 0), 0.5) }");
    s.step(30);
    CHECK(s.mass() == 2);
    CHECK(s.get("world.ball.friction").as_double() == Approx(0.5));
    s.step(30);
    CHECK(s.get("world.ball.position").vec2().x == Approx(0).margin(1e-9));
    s.step(15);
    CHECK(s.get("world.ball.position").vec2().x == Approx(0.5));
    s.step(30);
    CHECK(s.tweens() == 0);
}

TEST_CASE("a group refuses other instances than tweens and too many levels of groups") {
    Game s;
    CHECK_THAT(s.fails("tween.sequence { ball }"), contains("element 1 is a Body"));
    CHECK_THAT(s.fails("tween.parallel { 1 }"), contains("element 1 is an integer"));
    CHECK_THAT(s.fails("local t = tween(ball, 'mass', 2, 1) tween.sequence { t, t }"),
               contains("element 2 is in the list already"));
    CHECK_THAT(s.fails("local t = tween(ball, 'mass', 2, 1) tween.sequence { t } "
                       "tween.sequence { t }"),
               contains("in no other group"));
    CHECK_THAT(s.fails("local t = tween(ball, 'mass', 2, 1) "
                       "for i = 1, 100 do t = tween.sequence { t } end"),
               contains("groups within groups may be 32 deep"));
    s.run("game.tweens:delete()");
    s.run(
        "a = tween.sequence {} b = a for i = 1, 300 do "
        "local c = tween.sequence {} c:move(b) b = c end");
    s.step(3);  // beyond the depth nothing runs
    CHECK(s.errors.empty());
}

TEST_CASE("a tween that fails is reported once and ends") {
    Game s;
    s.run("t = tween(ball, 'mass', 2, 1)");
    s.step(10);
    s.run("t.to = vec(1, 2)");
    s.step(10);
    REQUIRE(s.errors.size() == 1);
    CHECK_THAT(s.errors[0].message, contains("there are no values between"));
    CHECK(s.tweens() == 0);
}

TEST_CASE("tweens are part of a snapshot") {
    Game s;
    s.run("ball.mass = 1 tween(ball, 'mass', 2, 1, function(t) return t * t end)");
    s.step(30);
    const double then = s.mass();
    const auto taken = s.tree->snapshot();
    s.step(15);
    const double later = s.mass();
    s.step(30);
    CHECK(s.tweens() == 0);
    s.tree->restore(taken);
    s.tree->barrier();
    CHECK(s.mass() == then);
    CHECK(s.tweens() == 1);
    s.step(15);
    CHECK(s.mass() == later);
    s.step(15);
    CHECK(s.mass() == 2);
}

TEST_CASE("a game with its own child called tweens gets an error") {
    Game s;
    CHECK_THAT(s.fails("game.tweens = Object {} tween(ball, 'mass', 2, 1)"),
               contains("tweens are below game.tweens, but that is an Object of the game"));
}

TEST_CASE("a formula can make no tween") {
    Game s;
    s.run("ball.mass = formula(function() tween(ball, 'friction', 1, 1) return 1 end)");
    CHECK_THAT(s.prints("print(ball:problem('mass'))"), contains("cannot call tween"));
}

TEST_CASE("a property that takes any value can be set to nil") {
    Game s;
    s.run("t = Tween {} t.to = 3 t.to = nil t.from = nil");
    CHECK(s.prints("print(t.to, t.from)") == "nil\tnil");
    s.run("edit('e', function() t.to = 5 end) undo()");
    CHECK(s.prints("print(t.to)") == "nil");
}

}  // namespace tween_test
