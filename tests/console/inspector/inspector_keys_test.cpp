// The inspector, used with the keyboard.

#include <inspector/inspector.h>
#include "catch.h"
#include "rig.h"

namespace inspector_keys_test {

using namespace fettle;
using console::test::Rig;
using property::Handle;
using property::Value;

namespace {

struct OpenRig : Rig {
    OpenRig() {
        key("grave");
        draw(2);
    }
    Handle at(const char* name) { return tree.child(tree.child(tree.root(), "world"), name); }
    Handle selected() { return state().inspector.selected(); }
    /// The field of a property of the ball gets the keyboard.
    void begin_typing(const char* property) {
        console.select(at("ball"));
        draw(3);
        const ImVec2 place = widget(property);
        click(place.x, place.y);
        draw(2);
    }
    void keys(std::initializer_list<const char*> all) {
        for (const char* each : all) {
            key(each);
            draw(2);
        }
    }
};

}  // namespace

TEST_CASE("Ctrl+F searches, and Enter selects the first that is found") {
    OpenRig rig;
    rig.keys({"ctrl+f"});
    rig.type("crate");
    rig.draw(2);
    rig.keys({"enter"});
    CHECK(rig.selected() == rig.at("crate"));
    rig.type("it");
    CHECK(rig.input() == "it");  // the prompt has the keyboard again
}

TEST_CASE("Ctrl+F shows the inspector if it is hidden") {
    OpenRig rig;
    rig.state().settings.set("inspector", Value(false));
    rig.draw(2);
    rig.keys({"ctrl+f"});
    rig.type("ball");
    rig.draw(2);
    rig.keys({"enter"});
    CHECK(rig.selected() == rig.at("ball"));
}

TEST_CASE("Ctrl+F leaves the keyboard to the prompt if the inspector has no room") {
    OpenRig rig;
    console::test::RasterSurface small(330, 140);
    for (int i = 0; i < 3; ++i) rig.console.draw(small, 1.0 / 60);
    rig.key("ctrl+f");
    rig.type("ab");
    CHECK(rig.input() == "ab");
    rig.draw(3);
    rig.type("c");
    CHECK(rig.input() == "abc");
}

TEST_CASE("the arrow keys walk through what is found") {
    OpenRig rig;
    rig.keys({"ctrl+f"});
    rig.type("body");
    rig.draw(2);
    const auto rows = rig.state().inspector.outline().row_of(rig.at("crate"));
    REQUIRE(rows > 0);
    for (std::ptrdiff_t i = 0; i <= rows; ++i) rig.keys({"down"});
    CHECK(rig.selected() == Handle());  // nothing is selected before Enter
    rig.keys({"enter"});
    CHECK(rig.selected() == rig.at("crate"));
}

TEST_CASE("without a text the arrow keys walk through the tree and unfold it") {
    OpenRig rig;
    rig.console.select(rig.tree.child(rig.tree.root(), "world"));
    rig.draw(2);
    auto row_of = [&](const char* name) {
        return rig.state().inspector.outline().row_of(rig.at(name));
    };
    rig.keys({"ctrl+f", "left"});
    CHECK(row_of("ball") == -1);
    rig.keys({"right", "down"});
    CHECK(row_of("ball") >= 0);
    rig.keys({"enter"});
    CHECK(rig.tree.parent(rig.selected()) == rig.tree.child(rig.tree.root(), "world"));
}

TEST_CASE("Escape clears the search, ends it and then closes the console") {
    OpenRig rig;
    rig.keys({"ctrl+f"});
    rig.type("crate");
    rig.draw(2);
    rig.keys({"escape"});
    CHECK(rig.state().inspector.outline().searched().empty());
    rig.type("ball");
    rig.draw(2);
    CHECK(rig.state().inspector.outline().searched() == "ball");
    rig.keys({"escape", "escape"});
    CHECK(rig.console.is_open());
    rig.type("x");
    CHECK(rig.input() == "x");
    rig.keys({"escape", "escape"});
    CHECK_FALSE(rig.console.is_open());
}

TEST_CASE("Tab goes from the search to the properties and from field to field") {
    OpenRig rig;
    rig.keys({"ctrl+f"});
    rig.type("ball");
    rig.draw(2);
    rig.keys({"tab"});
    REQUIRE(rig.selected() == rig.at("ball"));
    // The stops: name, parent, z, mask, type, position, angle, mass.
    const auto enter = [&](std::string_view text) {
        rig.key("ctrl+a");
        rig.type(text);
        rig.keys({"tab"});
    };
    rig.keys({"tab", "tab", "tab"});  // the values stay
    rig.keys({"space"});
    CHECK(rig.state().screen.popup_open);  // the bits of the mask
    rig.keys({"escape", "tab"});
    CHECK(rig.value("world.ball.type") == Value("dynamic"));
    rig.keys({"space"});  // the next of the texts
    CHECK(rig.value("world.ball.type") == Value("static"));
    rig.keys({"tab"});
    enter("2");
    enter("3");
    enter("0.25");
    CHECK(rig.value("world.ball.position") == Value(property::Vec2(2, 3)));
    CHECK(rig.value("world.ball.angle") == Value(0.25));
    rig.key("ctrl+a");
    rig.type("9");
    rig.keys({"escape"});
    CHECK(rig.value("world.ball.mass") == Value(1.0));
    rig.type("x");
    CHECK(rig.input() == "x");
}

TEST_CASE("Space switches a check box that Tab has reached, and other keys go to the prompt") {
    OpenRig rig;
    rig.begin_typing("lives");  // the one before
    const auto press_space = [&] {
        rig.press("space");
        rig.character(U' ');
        rig.release("space");
        rig.draw(2);
    };
    rig.keys({"tab"});
    press_space();
    CHECK(rig.value("world.ball.awake") == Value(false));
    rig.keys({"tab", "shift+tab"});
    press_space();
    CHECK(rig.value("world.ball.awake") == Value(true));
    CHECK(rig.input().empty());
    rig.type("x y");
    CHECK(rig.input() == "x y");
    CHECK(rig.value("world.ball.awake") == Value(true));
}

TEST_CASE("Tab stops at colors, references and lists") {
    OpenRig rig;
    rig.begin_typing("label");  // the one before
    rig.keys({"tab"});
    rig.key("ctrl+a");
    rig.type("#00ff00");
    rig.keys({"tab"});
    CHECK(rig.value("world.ball.color") == Value(property::Color{0, 1, 0, 1}));
    rig.keys({"space"});
    rig.draw(2);
    REQUIRE(rig.state().screen.popup_open);
    rig.type("crate");
    rig.draw();
    rig.keys({"enter"});
    CHECK(rig.value("world.ball.target") == Value(rig.at("crate")));
    const property::Property& vertices = rig.tree.property(rig.at("ball"), "vertices");
    const auto height = [&] {
        const console::Rect rect = rig.state().inspector.editor().widget_rect(vertices);
        return rect.high.y - rect.low.y;
    };
    rig.keys({"tab"});
    const float folded = height();
    rig.keys({"space"});
    CHECK(height() > 3 * folded);  // three vertices are shown
    rig.keys({"shift+tab", "shift+tab"});
    rig.key("ctrl+a");
    rig.type("tomato");
    rig.keys({"enter"});
    CHECK(rig.value("world.ball.color").color().r == 1);
}

TEST_CASE("Tab scrolls to fields that are out of sight, and ends after the last one") {
    OpenRig rig;
    rig.console.select(rig.at("ball"));
    rig.draw(2);
    rig.keys({"ctrl+f", "tab"});
    int fields = 0;
    while (rig.state().inspector.editor().typing() && fields < 100) {
        rig.keys({"tab"});
        ++fields;
    }
    CHECK(fields > 6);
    CHECK(fields < 100);
    CHECK(rig.tree.history().empty());  // nothing was changed
}

TEST_CASE("Shift and Tab go back, from the first field to the search") {
    OpenRig rig;
    rig.console.select(rig.at("ball"));
    rig.draw(2);
    rig.keys({"ctrl+f", "tab", "tab"});
    rig.keys({"shift+tab"});
    rig.key("ctrl+a");
    rig.type("kugel");
    rig.keys({"enter"});
    CHECK(rig.at("kugel"));  // the first field is the name
    rig.keys({"ctrl+f", "tab", "shift+tab"});
    rig.type("crate");
    rig.draw(2);
    CHECK(rig.state().inspector.outline().searched() == "crate");
}

TEST_CASE("Tab does not leave a field whose value is refused") {
    OpenRig rig;
    rig.begin_typing("mass");
    rig.key("ctrl+a");
    rig.type("heavy");
    rig.keys({"tab"});
    CHECK(rig.state().inspector.editor().problems() > 0);
    rig.key("ctrl+a");
    rig.type("7");
    rig.keys({"tab"});
    CHECK(rig.value("world.ball.mass") == Value(7.0));
    CHECK(rig.state().inspector.editor().problems() == 0);
}

}  // namespace inspector_keys_test
