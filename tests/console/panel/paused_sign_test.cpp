// The sign of a game that the player has paused, while the console is closed.

#include "catch.h"
#include "rig.h"

namespace paused_sign_test {

using namespace fettle;
using console::test::Rig;
using property::Value;
using property::Writer;

namespace {

void pause(Rig& rig, Writer writer) {
    const property::Tree::CauseScope cause(rig.tree, writer);
    property::set(rig.tree, "time.paused", Value(true));
}

bool shows_sign(Rig& rig) {
    rig.draw(2);
    const bool shown = !rig.state().screen.paused_sign.empty();
    CHECK(shown == (rig.surface.triangle_count() > 0));
    return shown;
}

void open_and_close(Rig& rig) {
    rig.key("grave");
    rig.draw(2);
    rig.key("grave");
}

}  // namespace

TEST_CASE("a game that was paused with the console shows that while the console is closed") {
    Rig rig;
    rig.key("grave");
    pause(rig, GENERATE(Writer::console, Writer::inspector, Writer::module));
    rig.draw(2);
    CHECK(rig.state().screen.paused_sign.empty());  // the time bar says it
    rig.key("grave");
    CHECK(shows_sign(rig));
    const console::Rect place = rig.state().screen.paused_sign;
    CHECK(rig.console.free_area({0, 0, 1280, 720}).height <= place.low.y);
    const ImVec2 sign = place.middle();
    rig.move(sign.x, sign.y);
    CHECK(rig.button(true, sign.x, sign.y));  // the game does not get the click
    CHECK(rig.button(false, sign.x, sign.y));
    CHECK_FALSE(rig.value("time.paused").boolean());
    CHECK_FALSE(shows_sign(rig));
    CHECK_FALSE(rig.button(true, sign.x, sign.y));
}

TEST_CASE("a game that pauses itself shows no sign of the console") {
    Rig rig;
    open_and_close(rig);
    pause(rig, Writer::script);
    CHECK_FALSE(shows_sign(rig));
}

TEST_CASE("a run in which nobody has used the console shows its game only") {
    Rig rig;
    pause(rig, Writer::console);
    CHECK_FALSE(shows_sign(rig));
    open_and_close(rig);
    CHECK(shows_sign(rig));
}

TEST_CASE("a console that pauses while it is open leaves no sign when it is closed") {
    Rig rig;
    property::set(rig.tree, "console.pauses", Value(true));
    open_and_close(rig);
    CHECK_FALSE(shows_sign(rig));
}

}  // namespace paused_sign_test
