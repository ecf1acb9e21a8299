// The window follows view.window, and its keys.

#include <iostream>

#include "catch.h"
#include "game_window.h"

namespace fullscreen_test {

using fettle::test::GameWindow;
using fettle::test::missing_tools;
namespace fs = std::filesystem;

TEST_CASE("F11 and Alt and Enter change between fullscreen and the window") {
    if (const std::string missing = missing_tools(); !missing.empty()) {
        std::cout << "SKIPPED: " << missing << " not found\n";
        return;
    }
    GameWindow game(fs::path(FETTLE_SOURCE_DIR) / "tests" / "window" / "resizing");
    REQUIRE(game.prints("ready\tvec(640, 400)"));
    game.key("F11");
    CHECK(game.prints("fullscreen\ttrue"));
    CHECK(game.prints("resized\t1280\t800"));
    game.key("alt+Return");
    CHECK(game.prints("fullscreen\tfalse"));
    CHECK(game.prints("resized\t640\t400"));
    INFO(game.printed());
    // The game did not get these keys.
    CHECK(game.printed().find("key\tf11") == std::string::npos);
    CHECK(game.printed().find("key\tenter") == std::string::npos);
    game.key("s");
    CHECK(game.prints("resized\t500\t300"));
    CHECK(game.prints("screen\tvec(500, 300)"));
}

}  // namespace fullscreen_test
