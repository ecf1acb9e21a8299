// What the log has folded is opened; moments that the past does not contain. The console with the
// Lua runtime.

#include "catch.h"
#include "observing_rig.h"

namespace unfolding_test {

using namespace fettle;
using console::test::ObservingRig;

TEST_CASE("a click on a moment that the past does not contain says so and changes nothing") {
    ObservingRig rig;
    rig.step(3);
    rig.lua.state().views.frame_view.go_to(-5);
    CHECK(rig.text().find("the past has no step below 0") != std::string::npos);
    CHECK_FALSE(rig.value("time.paused").boolean());
    rig.lua.state().views.frame_view.go_to(2);
    CHECK(rig.went_to == 2);
    CHECK(rig.value("time.paused").boolean());
}

TEST_CASE("ctrl O opens the last folded line of the log") {
    ObservingRig rig;
    rig.run("for i = 1, 90 do world.ball['n' .. i] = i end");
    rig.show();
    REQUIRE(rig.text().find("world.ball.n42") == std::string::npos);
    app::InputEvent ctrl_o;
    ctrl_o.kind = app::EventKind::key_pressed;
    ctrl_o.name = "o";
    ctrl_o.control = true;
    rig.lua.handle(ctrl_o);
    rig.show();
    CHECK(rig.text().find("world.ball.n42: nil → 42") != std::string::npos);
    // The log is scrolled to the first line that was folded.
    const auto& log = rig.lua.state().views.log_view;
    CHECK(log.scrolled() < 30 * log.line_height());
}

}  // namespace unfolding_test
