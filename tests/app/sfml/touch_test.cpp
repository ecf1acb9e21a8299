// A finger on a touch screen: what SFML reports of it becomes what a script gets of the mouse.

#include <catch.h>

#include <sfml/sfml.h>

#include "game.h"

namespace touch_test {

using namespace fettle::app;

namespace {

enum class Touch : std::uint8_t { begins, moves, ends };

/// An event of SFML 2, or of SFML 3, where each kind is a type.
template <class Event>
Event touch(Touch what, unsigned finger, int x, int y) {
    if constexpr (requires { typename Event::TouchBegan; }) {
        if (what == Touch::begins) return typename Event::TouchBegan{finger, {x, y}};
        if (what == Touch::moves) return typename Event::TouchMoved{finger, {x, y}};
        return typename Event::TouchEnded{finger, {x, y}};
    } else {
        Event event{};
        event.type = what == Touch::begins  ? Event::TouchBegan
                     : what == Touch::moves ? Event::TouchMoved
                                            : Event::TouchEnded;
        event.touch = {finger, x, y};
        return event;
    }
}

struct TouchScreen : Game {
    using Game::Game;
    /// False if the event is not used.
    bool report(Touch what, unsigned finger, int x, int y) {
        InputEvent event;
        if (!sfml::convert(touch<sf::Event>(what, finger, x, y), event)) return false;
        loop.handle(event);
        loop.frame(tick);
        return true;
    }
};

}  // namespace

TEST_CASE("a finger on a touch screen is the left button of the mouse") {
    TouchScreen game(R"(
        input.actions.jump = { "mouse.left" }
        function mouse_pressed(button, _, at) print(("+%s %g,%g"):format(button, at.x, at.y)) end
        function mouse_released(button, _, at) print(("-%s %g,%g"):format(button, at.x, at.y)) end
        function mouse_moved(_, at) print(("to %g,%g"):format(at.x, at.y)) end
    )");
    REQUIRE(game.report(Touch::begins, 0, 300, 200));
    CHECK(game.new_output().ends_with("+left 300,200"));
    CHECK(game.get("input.mouse.left").boolean());
    CHECK(game.get("input.jump.held").boolean());
    REQUIRE(game.report(Touch::moves, 0, 310, 220));
    CHECK(game.new_output() == "to 310,220");
    CHECK_FALSE(game.report(Touch::begins, 1, 5, 5));
    CHECK_FALSE(game.report(Touch::ends, 1, 5, 5));
    CHECK(game.get("input.mouse.left").boolean());
    REQUIRE(game.report(Touch::ends, 0, 312, 221));
    CHECK(game.new_output().ends_with("-left 312,221"));
    CHECK_FALSE(game.get("input.mouse.left").boolean());
    CHECK_FALSE(game.get("input.jump.held").boolean());
}

}  // namespace touch_test
