// The list from which a reference is chosen.

#include "catch.h"
#include "rig.h"

namespace reference_picker_test {

using namespace fettle;
using console::test::Rig;
using property::Handle;
using property::Value;

TEST_CASE("Escape first clears the search in the list of references and then closes the list") {
    Rig rig;
    rig.key("grave");
    rig.draw();
    rig.console.select(rig.tree.child(rig.tree.child(rig.tree.root(), "world"), "ball"));
    rig.draw(3);
    const ImVec2 at = rig.widget("target", 1.0f);
    const bool searched = GENERATE(false, true);
    rig.click(at.x - 8, at.y);
    rig.draw(2);
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
