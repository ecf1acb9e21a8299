// The inspector in a window in which it has no room of its own.

#include <string>

#include "catch.h"
#include "rig.h"

#include <look/imgui_compat.h>

namespace narrow_inspector_test {

using namespace fettle;
using console::test::Rig;
using property::Value;

namespace {

struct SmallWindow : Rig {
    explicit SmallWindow(unsigned height = 240) {
        surface.resize(400, height);
        key("grave");
        draw(4);
    }
    bool shows_inspector() { return !state().screen.inspector_rect.empty(); }
    void click_ball() {
        const property::Vec2 at = state().options.to_pixels(value("world.ball.position").vec2());
        click(static_cast<float>(at.x), static_cast<float>(at.y));
        draw(4);
    }
};

}  // namespace

TEST_CASE("in a low and narrow window a click on a body shows its properties") {
    SmallWindow rig;
    REQUIRE_FALSE(rig.shows_inspector());
    property::set(rig.tree, "world.ball.position", Value(rig.state().options.to_world(200, 200)));
    rig.click_ball();
    REQUIRE(rig.logged("it = world.ball"));
    REQUIRE(rig.shows_inspector());
    const console::Rect panel = rig.state().screen.panel_rect,
                        inspector = rig.state().screen.inspector_rect;
    CHECK(panel.contains(inspector.low.x, inspector.low.y));
    CHECK(inspector.high.y - inspector.low.y > 100);
    CHECK(panel.high.y < 240);
    rig.save("inspector_400x240");
    SECTION("a number can be dragged") {
        const double before = rig.value("world.ball.mass").number();
        const ImVec2 at = rig.widget("mass");
        CHECK(inspector.contains(at.x, at.y));
        rig.drag(at.x, at.y, at.x + 40, at.y);
        CHECK(rig.value("world.ball.mass").number() > before);
        CHECK(rig.shows_inspector());
    }
    SECTION("a button shows the tree and the values again") {
        const auto press = [&] {
            const console::Rect at = rig.state().inspector.turn_button();
            rig.click(at.middle().x, at.middle().y);
            rig.draw(4);
        };
        const property::Property& name = rig.tree.property(rig.console.selected(), "name");
        CHECK_FALSE(rig.state().inspector.editor().widget_rect(name).empty());
        press();
        CHECK(rig.state().inspector.editor().widget_rect(name).empty());
        press();
        CHECK_FALSE(rig.state().inspector.editor().widget_rect(name).empty());
    }
    SECTION("a command that prints shows the log") {
        rig.type("world.ball.mass");
        rig.key("enter");
        rig.draw(4);
        CHECK_FALSE(rig.shows_inspector());
    }
    SECTION("a search shows the tree") {
        rig.key("ctrl+f");
        rig.draw(6);
        rig.type("crate");
        rig.key("enter");
        rig.draw(4);
        CHECK(rig.tree.path(rig.console.selected()) == "world.crate");
        CHECK(rig.shows_inspector());
    }
    SECTION("in a larger window it has its own place") {
        rig.surface.resize(1280, 720);
        rig.draw(4);
        CHECK(rig.shows_inspector());
        CHECK(rig.state().screen.inspector_rect.low.x > rig.state().screen.panel_rect.high.x);
    }
}

TEST_CASE("in a window without any room the inspector is left out") {
    SmallWindow rig(120);
    rig.state().status.inspector_over_log = true;
    rig.draw(4);
    CHECK_FALSE(rig.shows_inspector());
}

}  // namespace narrow_inspector_test
