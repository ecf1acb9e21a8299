#include <catch.h>

#include <limits>

#include "game.h"

namespace fettle::app {

using property::Vec2;

TEST_CASE("the middle of the screen shows the center of the view") {
    View view;
    view.center = {3, -2};
    CHECK(view.to_screen({3, -2}) == Vec2(640, 400));
    CHECK(view.to_world({640, 400}) == Vec2(3, -2));
}

TEST_CASE("up in the world is up on the screen") {
    const View view;
    CHECK(view.to_screen({0, 10}).y == 0);
    CHECK(view.to_screen({0, -10}).y == 800);
    CHECK(view.to_screen({16, 0}).x == 1280);
}

TEST_CASE("to_world is the inverse of to_screen") {
    View view;
    view.center = {-7.5, 12.25};
    view.height = 3.7;
    view.screen = {1013, 777};
    const Vec2 point(-6.1, 13);
    const Vec2 back = view.to_world(view.to_screen(point));
    CHECK(back.x == Approx(point.x));
    CHECK(back.y == Approx(point.y));
}

TEST_CASE("the transform of a view maps points as to_window does") {
    for (const double angle : {0.0, 0.7, -2.0})
        for (const Fit fit : {Fit::expand, Fit::letterbox}) {
            View view;
            view.center = {-7.5, 12.25};
            view.angle = angle;
            view.fit = fit;
            view.screen = {1013, 777};
            for (const Vec2& point : {Vec2(0, 0), Vec2(-6.1, 13), Vec2(200, -30)})
                CHECK((view.world_to_window()(point) - view.to_window(point)).length() < 1e-9);
        }
}

TEST_CASE("pixels of the screen are counted from the corner of the picture inside its bars") {
    View view;
    view.screen = {1000, 500};
    view.design = {400, 400};
    CHECK(view.corner() == Vec2(0, 0));
    CHECK(view.picture() == Vec2(1000, 500));
    view.fit = Fit::letterbox;
    CHECK(view.corner() == Vec2(250, 0));
    CHECK(view.picture() == Vec2(500, 500));
    CHECK(view.to_screen(view.center) == Vec2(250, 250));
    CHECK(view.to_window(view.center) == Vec2(500, 250));
    CHECK(view.to_world({0, 0}) == Vec2(-10, 10));
    CHECK(view.to_world({500, 500}) == Vec2(10, -10));
    view.fit = Fit::pixel;
    CHECK(view.corner() == Vec2(300, 50));
    CHECK(view.picture() == Vec2(400, 400));
    view.screen = {701, 301};  // smaller than the design: the window shows the middle of it
    CHECK(view.corner() == Vec2(150, 0));
    CHECK(view.picture() == Vec2(400, 301));
    const Vec2 point(3, 2), back = view.to_world(view.to_screen(point));
    CHECK(back.x == Approx(3));
    CHECK(back.y == Approx(2));
}

TEST_CASE("the mouse and the size of the screen are those of the picture inside its bars") {
    Game game("function mouse_pressed(button, at, screen) print(screen, at) end");
    game.services.view.screen = {1000, 500};
    game.set("view.design", Vec2(400, 400));
    game.set("view.fit", "letterbox");
    CHECK(game.get("view.screen").vec2() == Vec2(500, 500));
    InputEvent event;
    event.kind = EventKind::mouse_pressed;
    event.name = "left";
    event.x = 250;
    event.y = 500;
    game.loop.handle(event);
    game.loop.frame(tick);
    CHECK(game.get("input.mouse.screen").vec2() == Vec2(0, 500));
    CHECK(game.get("input.mouse.world").vec2() == Vec2(-10, -10));
    CHECK(game.new_output() == "vec(0, 500)\tvec(-10, -10)");
}

TEST_CASE("a rewind without a past is reported once") {
    Game game;
    std::vector<std::string> notes;
    game.runtime.on_note([&](std::string_view text) { notes.emplace_back(text); });
    game.runtime.run("rewind(1)", "test");
    CHECK(notes.empty());
    game.runtime.run("time.rewind_limit = 0 rewind(1) rewind(2)", "test");
    REQUIRE(notes.size() == 1);
    CHECK_THAT(notes[0], contains("rewind does nothing: time.rewind_limit is 0"));
}

TEST_CASE("a rewind that is typed without a past is answered each time") {
    Game game;
    const auto said = [&](const char* command) {
        const std::vector<std::string> lines = game.runtime.evaluate(command).lines;
        return lines.empty() ? std::string() : lines.front();
    };
    for (int i = 0; i < 2; ++i)
        CHECK(said("rewind(1)") == "rewind does nothing: no step was made yet");
    game.runtime.run("time.rewind_limit = 0", "test");
    CHECK_THAT(said("rewind(1)"), contains("rewind does nothing: time.rewind_limit is 0"));
}

TEST_CASE("width and corners follow the height and the size of the screen") {
    Game game;
    CHECK(game.get("view.width").number() == 32);
    CHECK(game.get("view.lower").vec2() == Vec2(-16, -10));
    CHECK(game.get("view.upper").vec2() == Vec2(16, 10));
    game.set("view.height", 10);
    CHECK(game.get("view.width").number() == 16);
    CHECK(game.get("view.zoom").number() == 80);
    CHECK_THROWS_WITH(game.set("view.width", 3.0), contains("view.width"));
}

TEST_CASE("zoom is computed from height and sets it") {
    Game game;
    game.set("view.zoom", 100);
    CHECK(game.get("view.height").number() == 8);
    CHECK_THROWS(game.set("view.zoom", 0));
    CHECK_THROWS(game.set("view.height", -1));
    CHECK_THROWS(game.set("view.height", std::numeric_limits<double>::quiet_NaN()));
    CHECK(game.get("view.height").number() == 8);
}

TEST_CASE("a watcher of a property derived from the view is notified when the source changes") {
    Game game(R"(view:watch("width", function(new) print(new) end))");
    game.loop.frame(tick);
    game.set("view.height", 10);
    game.loop.frame(tick);
    CHECK(game.new_output() == "16.0");
}

TEST_CASE("scripts convert between world and screen") {
    Game game;
    game.runtime.run("local p = view:to_screen(vec(1, 1)) print(p.x, p.y)", "test");
    CHECK(game.new_output() == "680.0\t360.0");
    game.runtime.run("local p = view:to_world(vec(640, 0)) print(p.x, p.y)", "test");
    CHECK(game.new_output() == "0.0\t10.0");
}

TEST_CASE("an overlay is shown while its property is true") {
    Game game;
    CHECK_FALSE(game.services.view.show.overlay(property::Overlay::contacts));
    game.set("view.show.contacts", true);
    CHECK(game.services.view.show.overlay(property::Overlay::contacts));
    CHECK_FALSE(game.services.view.show.overlay(property::Overlay::aabbs));
}

TEST_CASE("overlays belong to no file of the game") {
    Game game;
    const property::Class& show = game.tree.class_named("Show");
    for (const property::Property* property : show.properties()) {
        INFO(property->name);
        CHECK((property->transient || property->owner != &show));
    }
}

TEST_CASE("every property of the services has a description") {
    Game game;
    game.tree.each_below(game.tree.root(), [&](property::Handle instance) {
        for (const property::Property* property : game.tree.class_of(instance).properties()) {
            INFO(game.tree.path(instance, *property));
            CHECK_FALSE(property->doc.empty());
        }
    });
}

}  // namespace fettle::app
