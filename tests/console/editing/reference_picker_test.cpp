// The list from which a reference is chosen.

#include "catch.h"
#include "rig.h"

namespace reference_picker_test {

using namespace fettle;
using console::test::Rig;
using property::Handle;
using property::Value;

/// Opens the list of `target`, a reference of the ball.
void open_list(Rig& rig) {
    rig.key("grave");
    rig.draw();
    rig.console.select(rig.tree.child(rig.tree.child(rig.tree.root(), "world"), "ball"));
    rig.draw(3);
    const ImVec2 at = rig.widget("target", 1.0f);
    rig.click(at.x - 8, at.y);
    rig.draw(2);
    REQUIRE(rig.state().screen.popup_open);
}

TEST_CASE("arrow keys and Enter choose in the list of references") {
    Rig rig;
    const Handle world = rig.tree.child(rig.tree.root(), "world");
    for (const char* name : {"crate_box", "box"})
        rig.tree.create(*rig.tree.find_class("Body"), world, name);
    open_list(rig);
    rig.type("box");
    rig.draw();
    SECTION("the best name is first") {
        rig.key("enter");
        rig.draw(2);
        CHECK(rig.value("world.ball.target") == Value(rig.tree.child(world, "box")));
    }
    SECTION("Down marks the next one") {
        rig.key("down");
        rig.draw();
        rig.key("down");
        rig.draw();
        rig.key("up");
        rig.draw();
        rig.key("down");
        rig.draw();
        rig.key("enter");
        rig.draw(2);
        CHECK(rig.value("world.ball.target") == Value(rig.tree.child(world, "crate_box")));
    }
    CHECK_FALSE(rig.state().screen.popup_open);
}

TEST_CASE("Escape first clears the search in the list of references and then closes the list") {
    const bool searched = GENERATE(false, true);
    Rig rig;
    open_list(rig);
    if (searched) {
        rig.type("crat");
        rig.draw();
        rig.key("escape");
        rig.draw(2);
        CHECK(rig.state().screen.popup_open);
    }
    REQUIRE(rig.state().screen.popup_open);
    rig.key("escape");
    rig.draw(2);
    CHECK_FALSE(rig.state().screen.popup_open);
    CHECK(rig.console.is_open());
    CHECK(rig.value("world.ball.target") == Value(Handle{}));
}

}  // namespace reference_picker_test
