// The gallery in a window: a click starts a game, and holding Escape returns to the gallery.

#include <array>
#include <cstdint>
#include <iostream>
#include <set>

#include "catch.h"
#include "game_window.h"

namespace gallery_test {

using fettle::test::GameWindow;
using fettle::test::missing_tools;
using fettle::test::Picture;

namespace {

/// Number of colors at the left side of the first card; a card without a picture of its game has
/// one color.
std::size_t colors_in_first_card(const Picture& picture) {
    std::set<std::array<std::uint8_t, 3>> colors;
    for (std::size_t y = 130; y < 330; ++y)
        for (std::size_t x = 50; x < 150; ++x) {
            const std::uint8_t* const pixel = &picture.rgb[(y * picture.width + x) * 3];
            colors.insert({pixel[0], pixel[1], pixel[2]});
        }
    return colors.size();
}

/// True if the heading of the gallery is shown. The pictures of the games are not compared: on a
/// slow machine some come later.
bool has_heading_of(const Picture& picture, const Picture& gallery) {
    constexpr unsigned height = 100;
    return picture.difference(gallery, 0, 0, gallery.width, height) < 1000;
}

}  // namespace

TEST_CASE("a click in the gallery starts a game and holding Escape returns to the gallery") {
    if (const std::string missing = missing_tools(); !missing.empty()) {
        std::cout << "SKIPPED: " << missing << " not found\n";
        return;
    }
    GameWindow gallery({});
    REQUIRE(gallery.eventually([&] { return colors_in_first_card(gallery.picture()) > 3; }));
    gallery.move(1270, 790);
    const Picture shown = gallery.settled();
    gallery.click(200, 200);
    REQUIRE(gallery.eventually([&] { return !has_heading_of(gallery.picture(), shown); }));
    // A short press goes to the game.
    gallery.key("Escape");
    CHECK_FALSE(has_heading_of(gallery.picture(), shown));
    gallery.hold("Escape", true);
    CHECK(gallery.eventually([&] { return has_heading_of(gallery.picture(), shown); }));
    gallery.hold("Escape", false);
    CHECK(gallery.running());
    gallery.key("Escape");
    CHECK(gallery.eventually([&] { return !gallery.running(); }));
}

}  // namespace gallery_test
