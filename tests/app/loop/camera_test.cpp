// Cameras: what they show, and where on the screen.

#include <catch.h>

#include "game.h"
#include "noting_screen.h"

namespace camera_test {

using namespace fettle;
using namespace fettle::app;
using property::Color;
using property::Paint;
using property::Value;
using property::Vec2;

namespace {

struct Pictures : Game {
    NotingScreen screen;
    Pictures() {
        // A dot in the world, and one on the screen.
        runtime.run(R"(
            Dot = class("Dot", Object) { at = vec(0, 0) }
            function Dot:draw(pen) pen.circle(self.at, 1) end
            game.dot = Dot {}
            game.camera = Camera { visible = false }
        )",
                    "test");
    }
    std::vector<Circle> draw() {
        loop.frame(tick);
        loop.draw(screen, 0);
        CHECK(errors.empty());
        CHECK(screen.noted.pushed() == 0);
        return screen.noted.circles;
    }
};

bool near(const Vec2& a, const Vec2& b) {
    return (a - b).length() < 1e-6;
}

}  // namespace

TEST_CASE_METHOD(Pictures, "a camera draws the game again in its part of the window") {
    CHECK(draw().size() == 1);
    set("camera.viewport", property::List{Vec2(0.5, 0.5), Vec2(1, 1)});
    set("camera.center", Vec2(2, 1));
    set("camera.height", 10.0);
    set("camera.visible", true);
    const auto circles = draw();
    REQUIRE(circles.size() == 2);
    CHECK(near(circles[0].pixel, {640, 400}));
    CHECK(circles[0].radius == Approx(40));
    // 40 pixels a meter, from the middle of the viewport at (960, 600).
    CHECK(near(circles[1].pixel, {960 - 2 * 40, 600 + 40}));
    CHECK(circles[1].radius == Approx(40));
    CHECK(near(circles[1].clip_lower, {640, 400}));
    CHECK(near(circles[1].clip_upper, {1280, 800}));
    set("camera.height", 40.0);
    CHECK(draw()[1].radius == Approx(10));
    set("camera.angle", std::acos(-1.0) / 2);
    // The viewer turns to the left, so the picture turns to the right.
    CHECK(near(draw()[1].pixel, {960 - 10, 600 - 20}));
    // The view turns only its own picture.
    set("view.angle", 0.7);
    set("view.center", Vec2(1e6, -3e5));
    const auto turned = draw();
    CHECK(near(turned[1].pixel, {960 - 10, 600 - 20}));
    CHECK(near(turned[1].clip_lower, {640, 400}));
    CHECK(near(turned[1].clip_upper, {1280, 800}));
}

TEST_CASE_METHOD(Pictures, "a camera follows an instance") {
    runtime.run(R"(
        game.place = Object { position = vec(0, 3) }
        game.camera.follow = game.place
        print(game.camera:to_world(vec(640, 400)))  -- no step was made yet
    )",
                "t");
    CHECK(new_output() == "vec(0, 3)");
    set("camera.visible", true);
    CHECK(near(draw()[1].pixel, {640, 400 + 3 * 40}));
    set("place.position", Vec2(1, 0));
    CHECK(near(draw()[1].pixel, {640 - 40, 400}));
    CHECK(get("camera.center").vec2() == Vec2(1, 0));
    runtime.run("game.place:delete()", "t");
    CHECK(near(draw()[1].pixel, {640 - 40, 400}));  // it stays
}

TEST_CASE_METHOD(Pictures, "functions that draw convert points as they are seen") {
    runtime.run(R"(
        game.place = Object { position = vec(0, 0) }
        function step() game.place.position = game.place.position + vec(1, 0) end
        view.follow, game.camera.follow = game.place, game.place
        game.camera.follow_damping = 0.1
        game.camera.visible = true
        view:shake(0.5, 10)
        local seen, within
        function Dot:draw(pen)
            pen.circle(self.at, 1)
            seen, within = view:to_screen(self.at), game.camera:to_screen(self.at)
            assert((view:to_world(seen) - self.at):length() < 0.001)
            assert((game.camera:to_world(within) - self.at):length() < 0.001)
        end
        function keep() game.kept = Object { props = { seen = seen, within = within } } end
    )",
                "t");
    loop.frame(3.5 * tick);
    loop.draw(screen, 0);
    CHECK(errors.empty());
    runtime.run("keep()", "t");
    const auto& circles = screen.noted.circles;
    REQUIRE(circles.size() == 2);
    CHECK(near(circles[0].pixel, get("kept.seen").vec2()));
    CHECK(near(circles[1].pixel, get("kept.within").vec2()));
    // Elsewhere, as after the last step.
    runtime.run("print(view:to_screen(view.center), game.camera:to_screen(game.camera.center))",
                "t");
    CHECK(new_output() == "vec(640, 400)\tvec(640, 400)");
}

TEST_CASE_METHOD(Pictures, "a camera follows with a delay and within limits as the view does") {
    runtime.run(R"(
        game.place = Object { position = vec(8, 3) }
        game.camera.follow = game.place
        game.camera.follow_damping = 0.5
    )",
                "t");
    for (int i = 0; i < 30; ++i) loop.frame(tick);
    CHECK(near(get("camera.center").vec2(), Vec2(8, 3) * (1 - std::exp(-1.0))));
    set("camera.follow_damping", 0.0);
    set("camera.dead_zone", Vec2(2, 100));
    loop.frame(tick);
    CHECK(get("camera.center").vec2().x == Approx(7));
    // Half of the window, so 8 x 20 m are seen.
    set("camera.dead_zone", Vec2(0, 0));
    set("camera.viewport", property::List{Vec2(0, 0), Vec2(0.25, 1)});
    set("camera.limits", property::List{Vec2(-30, -10), Vec2(10, 50)});
    loop.frame(tick);
    CHECK(near(get("camera.center").vec2(), {6, 3}));
    // The corners may come in any order, and a list that is not a box is no limit.
    set("camera.limits", property::List{Vec2(10, 50), Vec2(-30, -10)});
    loop.frame(tick);
    CHECK(near(get("camera.center").vec2(), {6, 3}));
    set("camera.limits", property::List{Vec2(1, 1)});
    loop.frame(tick);
    CHECK(near(get("camera.center").vec2(), {8, 3}));
}

TEST_CASE_METHOD(Pictures, "a shake moves the picture of one camera and ends") {
    set("camera.visible", true);
    const Vec2 still = draw()[1].pixel;
    runtime.run("game.camera:shake(0.5, 0.2)", "t");
    double most = 0;
    for (int i = 0; i < 11; ++i) {
        const auto circles = draw();
        CHECK(near(circles[0].pixel, {640, 400}));
        most = std::max(most, (circles[1].pixel - still).length());
    }
    CHECK(most > 4);  // px; the amplitude is 0.5 m, which is 20 px
    CHECK(most < 0.75 * 40);
    CHECK(get("camera.center").vec2() == Vec2(0, 0));
    for (int i = 0; i < 3; ++i) draw();
    CHECK(near(draw()[1].pixel, still));
}

TEST_CASE_METHOD(Pictures, "the zoom of a camera is in pixels of its viewport") {
    set("camera.viewport", property::List{Vec2(0, 0), Vec2(1, 0.5)});
    CHECK(get("camera.zoom").number() == Approx(20));
    set("camera.zoom", 80.0);
    CHECK(get("camera.height").number() == Approx(5));
    set("camera.height", 10.0);
    CHECK(get("camera.zoom").number() == Approx(40));
    set("camera.visible", true);
    CHECK(draw()[1].radius == Approx(40));
    CHECK_THROWS(set("camera.zoom", 1e6));  // 0.4 mm would be visible
    runtime.run("game.second = Camera { zoom = 10 } print(game.second.height)", "t");
    CHECK(new_output() == "80.0");
}

TEST_CASE_METHOD(Pictures, "instances on the screen are drawn once and last") {
    runtime.run("function draw(pen) pen.screen(function() pen.circle(vec(5, 5), 2) end) end", "t");
    if (!errors.empty()) errors.clear();
    set("camera.visible", true);
    const auto circles = draw();
    REQUIRE(circles.size() == 3);
    CHECK_FALSE(circles[0].on_screen);
    CHECK_FALSE(circles[1].on_screen);
    CHECK(circles[2].on_screen);
    CHECK(near(circles[2].pixel, {5, 5}));
}

TEST_CASE_METHOD(Pictures, "a camera converts between points of the world and pixels") {
    runtime.run(R"(
        game.camera.viewport = { vec(0.5, 0), vec(1, 1) }
        game.camera.center = vec(3, 4)
        print(game.camera:to_world(vec(960, 400)), game.camera:to_screen(vec(4, 4)))
    )",
                "t");
    CHECK(new_output() == "vec(3, 4)\tvec(1000, 400)");
}

TEST_CASE_METHOD(Pictures, "a viewport without an area shows nothing") {
    set("camera.visible", true);
    const auto with = [&](property::List list) {
        set("camera.viewport", Value(std::move(list)));
        return draw().size();
    };
    CHECK(with({}) == 1);
    CHECK(with({Vec2(0.5, 0.5)}) == 1);
    CHECK(with({Vec2(0.5, 0.5), Vec2(0.5, 1)}) == 1);
    // The corners may come in any order.
    CHECK(with({Vec2(1, 1), Vec2(0.5, 0.5)}) == 2);
}

TEST_CASE_METHOD(Pictures, "a camera outside of the game shows nothing") {
    runtime.run("loose = Camera {}", "t");
    CHECK(draw().size() == 1);
    runtime.run("game.loose = loose loose:delete()", "t");
    CHECK(draw().size() == 1);
}

TEST_CASE_METHOD(Pictures, "cameras come back with a snapshot") {
    set("camera.visible", true);
    set("camera.center", Vec2(1, 0));
    const property::Snapshot before = tree.snapshot();
    runtime.run("game.camera:delete()", "t");
    CHECK(draw().size() == 1);
    tree.restore(before);
    CHECK(near(draw().at(1).pixel, {600, 400}));
}

}  // namespace camera_test
