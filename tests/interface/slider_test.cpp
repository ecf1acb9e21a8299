// Values of sliders that the player chooses with keys and mouse.

#include "screen.h"

namespace slider_test {

using namespace fettle::interface::test;

TEST_CASE("a slider with steps has short numbers") {
    Screen s(R"(game.m = Column { modal = true, Slider { name = "s", min = -1, max = 2, step = 0.1,
        value = -1, changed = function(event) print(event.value) end } })");
    s.point({700, 700});
    for (int i = 0; i < 30; ++i) s.tap("right");
    CHECK(s.new_output() ==
          "-0.9 -0.8 -0.7 -0.6 -0.5 -0.4 -0.3 -0.2 -0.1 0.0 0.1 0.2 0.3 0.4 0.5 0.6 0.7 0.8 0.9 "
          "1.0 1.1 1.2 1.3 1.4 1.5 1.6 1.7 1.8 1.9 2.0");
}

TEST_CASE("a slider whose min is the greater value decreases to the right") {
    Screen s(R"(game.m = Column { modal = true, Slider { name = "s", min = 10, max = 0, step = 4,
        value = 10, changed = function(event) print(event.value) end } })");
    s.point({700, 700});
    for (int i = 0; i < 4; ++i) s.tap("right");
    CHECK(s.new_output() == "6.0 2.0 0.0");
    s.tap("left");
    s.new_output();
    s.set("m.s.step", Value(0.0));
    const Vec2 corner = s.get("m.s.screen_position").vec2(), size = s.get("m.s.screen_size").vec2();
    s.click(corner + Vec2(0.5 * size.x, 0.5 * size.y));
    CHECK(s.get("m.s.value").number() == Approx(5));
}

}  // namespace slider_test
