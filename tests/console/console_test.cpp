// The console as a whole: events in, edits and pictures out.

#include "catch.h"
#include "rig.h"

using namespace fettle;
using console::test::Rig;
using property::Value;
using property::Vec2;

TEST_CASE("the grave key opens and closes the console and never types itself") {
    Rig rig;
    CHECK_FALSE(rig.console.is_open());
    CHECK(rig.press("grave"));
    CHECK(rig.character('`'));
    CHECK(rig.release("grave"));
    CHECK(rig.console.is_open());
    CHECK(rig.value("console.open") == Value(true));
    CHECK(rig.input().empty());
    rig.draw();
    CHECK(rig.surface.triangle_count() > 100);

    CHECK(rig.press("grave"));
    CHECK(rig.character('`'));
    CHECK(rig.release("grave"));
    CHECK_FALSE(rig.console.is_open());
    CHECK(rig.input().empty());
    rig.draw();
    CHECK(rig.surface.triangle_count() == 0);
}

TEST_CASE("pictures") {
    Rig rig;
    rig.key("grave");
    rig.draw();
    rig.type("world.ball.mass = 5");
    rig.key("enter");
    rig.type("world.bal.mass = 5");
    rig.key("enter");
    rig.console.select(rig.tree.child(rig.tree.child(rig.tree.root(), "world"), "ball"));
    rig.draw(3);
    rig.type("if x then y = \"hello\" -- comment");
    rig.key("shift+enter");
    rig.type("world.ball.f");
    rig.draw(3);
    rig.key("tab");
    rig.draw(3);
    rig.save("first");
}
