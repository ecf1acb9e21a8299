// Output with the colors of the console for a terminal.

#include <fettle/console/terminal_colors.h>
#include <look/theme.h>
#include "catch.h"
#include "patterns.h"

namespace terminal_colors_test {

using namespace fettle;

namespace {

std::string without_colors(const std::string& text) {
    return patterns::without(text, "\x1b\\[[0-9;]*m");
}

}  // namespace

TEST_CASE("printed lines have the colors of the console and no other change") {
    for (const std::string line :
         {"  world.ball.mass: 2 → 5 kg", "", "plain words", "  \"a text\" and 3.5", "✗ é 日本"}) {
        INFO(line);
        CHECK(without_colors(console::colored_output(line)) == line);
        CHECK(without_colors(console::colored_error(line)) == line);
    }
    const std::string colored = console::colored_output("  world.ball.mass: 2 → 5 kg");
    CHECK(colored.find("\x1b[38;2;119;189;251mworld.ball.mass\x1b[39m") != std::string::npos);
    CHECK(colored.find("\x1b[38;2;200;168;240m5\x1b[39m kg") != std::string::npos);
    CHECK(console::colored_output("plain words") == "plain words");
    CHECK(console::colored_error("no").starts_with("\x1b[38;2;255;128;128m"));
}

}  // namespace terminal_colors_test
