// What moves in steps is drawn between the last two steps; what moves in frames is drawn where it
// is.

#include <catch.h>

#include "game.h"
#include "noting_screen.h"

namespace drawn_pose_test {

using namespace fettle::app;
using fettle::property::Value;

namespace {

struct Pictures : Game {
    NotingScreen screen;
    explicit Pictures(std::string_view script = {}) {
        runtime.run(R"(
            Dot = class("Dot", Object) { position = vec(0, 0) }
            function Dot:draw(pen) pen.circle(self:drawn_position(), 1) end
            game.dot = Dot {}
        )",
                    "test");
        if (!script.empty()) runtime.run(script, "test");
    }
    /// Where the dot is drawn after a frame of so many steps, m from the middle of the screen.
    Vec2 after(double steps) {
        loop.frame(steps * tick);
        loop.draw(screen, 0);
        CHECK(errors.empty());
        REQUIRE(!screen.noted.circles.empty());
        const Vec2 pixel = screen.noted.circles.front().pixel - Vec2(640, 400);
        return {pixel.x / 40, -pixel.y / 40};
    }
};

}  // namespace

TEST_CASE("what a script moves in steps is drawn between the last two steps") {
    Pictures game("function step() dot.position = dot.position + vec(1, 0) end");
    CHECK(game.after(1.5).x == Approx(0.5));
    CHECK(game.after(0.25).x == Approx(0.75));
    CHECK(game.after(0.75).x == Approx(1.5));
    CHECK(game.after(3).x == Approx(4.5));
}

TEST_CASE("a tween is drawn between the last two steps") {
    Pictures game("tween(dot, 'position', vec(60, 0), 1, 'linear')");
    CHECK(game.after(2.5).x == Approx(1.5));
}

TEST_CASE("in slow motion every picture shows another place") {
    Pictures game("time.scale = 0.2  function step() dot.position = dot.position + vec(1, 0) end");
    (void)game.after(7.5);
    const double before = game.after(1).x;
    CHECK(game.after(1).x == Approx(before + 0.2));
}

TEST_CASE("what a script moves in frames is drawn where it is") {
    Pictures game("function update(dt) dot.position = dot.position + vec(1, 0) end");
    CHECK(game.after(1.5).x == Approx(1));
    CHECK(game.after(0.25).x == Approx(2));
    CHECK(game.after(2.5).x == Approx(3));
}

TEST_CASE("a write from outside is drawn at once") {
    Pictures game("function step() dot.position = dot.position + vec(1, 0) end");
    (void)game.after(1.5);
    game.set("dot.position", Vec2(5, 0));
    CHECK(game.after(0.25).x == Approx(5));
    game.set("time.paused", true);
    game.set("dot.position", Vec2(7, 3));
    CHECK(game.after(0.25).x == Approx(7));
}

TEST_CASE("a jump in a step is drawn at once") {
    Pictures game(R"(
        function step()
            dot.position = dot.position + vec(0.5, 0)
            if dot.position.x > 5 then dot.position = vec(-5, 0) end
        end)");
    (void)game.after(5);
    CHECK(game.after(5.5).x == Approx(4.75));
    CHECK(game.after(1).x == Approx(-5));
    CHECK(game.after(1).x == Approx(-4.75));
}

TEST_CASE("a view that a script moves in steps is drawn between the last two steps") {
    Pictures game("function step() view.center = view.center + vec(1, 0) end");
    CHECK(game.after(1.5).x == Approx(-0.5));
    CHECK(game.after(0.25).x == Approx(-0.75));
}

TEST_CASE("a followed instance stays in the middle of the picture") {
    Pictures game(R"(
        view.follow = dot
        function step() dot.position = dot.position + vec(1, 0.5) end)");
    for (int i = 0; i < 5; ++i) CHECK(game.after(0.7).length() < 1e-9);
    game.set("dot.position", Vec2(40, 0));
    (void)game.after(1);
    CHECK(game.after(0.5).length() < 1e-9);
}

TEST_CASE("a camera that a script moves in steps is drawn between the last two steps") {
    Pictures game(R"(
        game.camera = Camera {}
        function step() camera.center = camera.center + vec(1, 0) end)");
    (void)game.after(1.5);
    REQUIRE(game.screen.noted.circles.size() == 2);
    CHECK(game.screen.noted.circles.back().pixel.x == Approx(640 - 0.5 * 40));
}

TEST_CASE("a picture of a headless run shows the last step") {
    Pictures game("function step() dot.position = dot.position + vec(1, 0) end");
    game.loop.turn();
    game.loop.draw(game.screen, 0);
    CHECK(game.screen.noted.circles.front().pixel.x == Approx(680));
}

TEST_CASE("pictures between steps do not change the state") {
    const char* const script =
        "function step() dot.position = dot.position * 1.5 + vec(0.1, 0) end";
    Pictures drawn(script), turned(script);
    (void)drawn.after(1);
    for (int i = 0; i < 4; ++i) (void)drawn.after(0.5);
    for (int i = 0; i < 3; ++i) turned.loop.turn();
    CHECK(drawn.get("dot.position") == turned.get("dot.position"));
}

}  // namespace drawn_pose_test
