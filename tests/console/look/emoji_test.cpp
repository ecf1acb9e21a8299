// Emoji and other characters beyond U+FFFF, which Dear ImGui does not have.

#include <algorithm>
#include <string>

#include <fettle/property/storage/font_files.h>

#include <look/extra_glyphs.h>
#include <text/utf8.h>
#include "catch.h"
#include "rig.h"

namespace emoji_test {

using namespace fettle;
using console::test::Pixel;
using console::test::Rig;
using property::Value;

namespace {

/// A picture of the console with a printed line.
std::vector<Pixel> picture(const char* text) {
    Rig rig;
    rig.key("grave");
    rig.console.print(text);
    rig.draw(4);
    return rig.surface.pixels();
}

bool installed(const char* font) {
    return !property::font_file(font).empty();
}

}  // namespace

TEST_CASE("emoji take two cells and characters that join them take none") {
    CHECK(console::cell_count("a🚀b") == 4);
    CHECK(console::cell_count("⭐") == 2);
    CHECK(console::cell_count("❤\uFE0F") == 1);
    CHECK(console::cell_count("👩\u200D🚀") == 4);
    CHECK(console::cell_count("𝔸") == 1);
    CHECK(console::cell_offset("❤\uFE0Fx", 1) == 6);  // the sign that follows belongs to it
    CHECK(console::cell_offset("a🚀", 2) == 1);
}

TEST_CASE("emoji are drawn in their colors") {
    if (!installed("NotoColorEmoji.ttf")) return;
    const std::vector<Pixel> apple = picture("🍎");
    const bool differ = apple != picture("🍏");
    CHECK(differ);
    const auto red = std::ranges::count_if(
        apple, [](const Pixel& p) { return p[0] > 180 && p[1] < 90 && p[2] < 90; });
    CHECK(red > 20);
}

TEST_CASE("letters that come while the surface changes are drawn, and old textures are destroyed") {
    Rig rig;
    rig.key("grave");
    rig.draw(4);
    const std::size_t before = rig.surface.textures();
    rig.console.print("🍎 漢字 Việt");
    rig.draw(4);
    CHECK(rig.surface.textures() == before);
    rig.console.print("🍏 仮名 ế");
    console::test::RasterSurface other(1280, 720);
    for (int i = 0; i < 4; ++i) {
        other.clear();
        rig.console.draw(other, 1.0 / 60);
    }
    CHECK(other.faults() == 0);
    CHECK(other.textures() == before);
    rig.draw(4);
    const bool same = other.pixels() == rig.surface.pixels();
    CHECK(same);
}

TEST_CASE("a character beyond U+FFFF without a picture in colors is drawn as other letters are") {
    if (!installed("DejaVuSans.ttf")) return;
    const bool differ = picture("𝔸") != picture("𝔹");
    CHECK(differ);
    // No font has these two: both are the same sign.
    const bool same = picture("\U000EFFF1") == picture("\U000EFFF2");
    CHECK(same);
}

TEST_CASE("a text with emoji is unchanged by editing and copying and pasting") {
    Rig rig;
    rig.key("grave");
    rig.console.select(rig.tree.child(rig.tree.child(rig.tree.root(), "world"), "ball"));
    const std::string before = "a🚀\uE000\u3400𠀀";  // also one for private use
    property::set(rig.tree, "world.ball.label", Value(before));
    rig.draw(3);
    const auto enter = [&](const auto& edit) {
        const ImVec2 at = rig.widget("label");
        rig.click(at.x, at.y);
        rig.draw(3);
        edit();
        rig.key("enter");
        rig.draw(3);
    };
    enter([&] {
        rig.key("ctrl+a");
        rig.key("ctrl+c");
        rig.draw(2);
        rig.key("end");
        rig.character(U'😀');
        rig.character(U'\u3400');
    });
    CHECK(rig.clipboard.text == before);
    CHECK(rig.value("world.ball.label") == Value(before + "😀\u3400"));
    rig.clipboard.text = "🎈x🎈";
    enter([&] {
        rig.key("ctrl+a");
        rig.key("ctrl+v");
    });
    CHECK(rig.value("world.ball.label") == Value("🎈x🎈"));
    enter([&] {
        rig.key("end");
        rig.key("backspace");  // the whole character
    });
    CHECK(rig.value("world.ball.label") == Value("🎈x"));
    // The prompt has the character itself, too.
    rig.key("escape");
    rig.console.open();
    rig.character(U'🚀');
    CHECK(rig.input() == "🚀");
    CHECK(rig.surface.faults() == 0);
}

TEST_CASE("a text with more different emoji than the font has room for is unchanged") {
    Rig rig;
    rig.key("grave");
    rig.console.select(rig.tree.child(rig.tree.child(rig.tree.root(), "world"), "ball"));
    std::string many;
    for (char32_t c = 0x20000; c < 0x20000 + 7000; ++c) console::append_code_point(many, c);
    property::set(rig.tree, "world.ball.label", Value(many));
    rig.draw(3);
    const ImVec2 at = rig.widget("label");
    rig.click(at.x, at.y);
    rig.draw(3);
    rig.type("x");
    rig.key("enter");
    rig.draw(3);
    CHECK(rig.value("world.ball.label") == Value(many));
}

}  // namespace emoji_test
