// Errors about what is observed, searched and bound: where they are told.

#include <string>

#include "catch.h"
#include "observing_rig.h"

namespace observing_errors_test {

using namespace fettle;
using console::test::ObservingRig;
using property::Value;

TEST_CASE("the key that opens the console runs no command") {
    ObservingRig rig;
    rig.run("bind('grave', 'world.ball.mass = 7')");
    CHECK(rig.text().find("bind: grave opens and closes the console; console.key chooses another "
                          "key for that") != std::string::npos);
    rig.lua.state().settings.set("key", Value("f1"));
    rig.run("bind('grave', 'world.ball.mass = 7')");
    rig.lua.open(false);
    CHECK(rig.press_key("grave"));
    CHECK(rig.value("world.ball.mass") == Value(7.0));
}

TEST_CASE("errors of what is observed and searched reach the host") {
    ObservingRig rig;
    std::string all;
    rig.lua.state().observing.on_result = [&](const std::string& line) { all += line + "|"; };
    rig.run("pin world.nothing");
    CHECK(all.starts_with("pin: world.nothing: no such name"));
    all.clear();
    rig.run("plot world.nothing");
    CHECK(all.starts_with("plot: world.nothing: no such name"));
    all.clear();
    rig.step(3);
    rig.run("last_time world.nothing");
    CHECK(all.starts_with("✗ last_time world.nothing: world.nothing: no such name"));
}

}  // namespace observing_errors_test
