// The gallery in a window: a click starts a game, and Escape comes back.

#include <iostream>

#include "catch.h"
#include "game_window.h"

namespace gallery_test {

using fettle::test::GameWindow;
using fettle::test::missing_tools;
using fettle::test::Picture;

TEST_CASE("a click in the gallery starts a game and Escape comes back") {
    if (const std::string missing = missing_tools(); !missing.empty()) {
        std::cout << "SKIPPED: " << missing << " not found\n";
        return;
    }
    GameWindow gallery({});
    // The first card, which gets the picture of its game.
    const auto in_card = [&](const Picture& before) {
        return gallery.picture().difference(before, 60, 130, 300, 200);
    };
    const Picture empty = gallery.picture();
    REQUIRE(gallery.eventually([&] { return in_card(empty) > 100'000; }));
    gallery.move(1270, 790);
    const Picture shown = gallery.settled();
    gallery.click(200, 200);
    REQUIRE(gallery.eventually(
        [&] { return gallery.picture().difference(shown, 0, 0, 1280, 100) > 200'000; }));
    gallery.key("Escape");
    CHECK(gallery.eventually(
        [&] { return gallery.picture().difference(shown, 0, 0, 1280, 100) < 20'000; }));
    CHECK(gallery.running());
    gallery.key("Escape");
    CHECK(gallery.eventually([&] { return !gallery.running(); }));
}

}  // namespace gallery_test
