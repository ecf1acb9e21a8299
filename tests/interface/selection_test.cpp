// Selection in text fields, and the clipboard.

#include <catch.h>

#include "screen.h"

namespace selection_test {

using namespace fettle::interface::test;

namespace {

struct Field : Screen {
    Field()
        : Screen(R"(
        game.f = TextField { size = vec(300, 40), changed = function(e) print(e.value) end }
        game.other = Button { text = "other", offset = vec(0, 100) })") {
        click("f");
    }
    std::string text() const { return get("f.text").text(); }
    void write(const std::string& text) {
        set("f.text", Value(text));
        set("f.mark", Value());
        set("f.caret", Value(1000));
        tap("end");
    }
    void tap_with(const std::vector<std::string>& held, const std::string& key) {
        for (const std::string& each : held) set("input.keys." + each, true);
        tap(key);
        for (const std::string& each : held) set("input.keys." + each, false);
        turn();
    }
    void shift(const std::string& key) { tap_with({"left_shift"}, key); }
    void control(const std::string& key) { tap_with({"right_control"}, key); }
    /// The selected part, as a copy of it gives it.
    std::string selected() {
        set("input.clipboard", Value(""));
        control("c");
        return get("input.clipboard").text();
    }
    /// The pixel of a gap between two letters.
    Vec2 gap(std::size_t n) {
        constexpr double margin = 11;
        const TextStyle style{.size = get("interface.theme.font_size").number()};
        const double scale = get("f.screen_size").vec2().x / 300;
        const Vec2 corner = get("f.screen_position").vec2();
        const double x = margin + visuals.media().carets(text(), style).at(n);
        return corner + scale * Vec2(x, 20);
    }
    /// Some frames later, so that the next click is no double click.
    void wait() {
        for (int i = 0; i < 40; ++i) turn();
    }
};

}  // namespace

TEST_CASE_METHOD(Field, "shift with the arrow keys selects") {
    write("one two");
    CHECK(get("f.mark") == Value());
    shift("left");
    shift("left");
    CHECK(get("f.mark").integer() == 7);
    CHECK(get("f.caret").integer() == 5);
    CHECK(selected() == "wo");
    shift("right");
    CHECK(selected() == "o");
    shift("right");
    CHECK(get("f.mark") == Value());
    shift("home");
    CHECK(selected() == "one two");
    tap("home");
    shift("end");
    CHECK(selected() == "one two");
}

TEST_CASE_METHOD(Field, "an arrow key without shift ends the selection at its side") {
    write("one two");
    shift("left");
    shift("left");
    tap("right");
    CHECK(get("f.caret").integer() == 7);
    CHECK(get("f.mark") == Value());
    shift("left");
    shift("left");
    tap("left");
    CHECK(get("f.caret").integer() == 5);
    CHECK(get("f.mark") == Value());
}

TEST_CASE_METHOD(Field, "ctrl with the arrow keys goes by words") {
    write("one, häßlich two");
    control("left");
    CHECK(get("f.caret").integer() == 13);
    control("left");
    CHECK(get("f.caret").integer() == 5);
    control("right");
    CHECK(get("f.caret").integer() == 12);
    tap_with({"left_control", "left_shift"}, "left");
    CHECK(selected() == "häßlich");
    tap("end");
    control("backspace");
    CHECK(text() == "one, häßlich ");
    tap("home");
    control("delete");
    CHECK(text() == ", häßlich ");
}

TEST_CASE_METHOD(Field, "ctrl and A selects everything and typing replaces the selection") {
    write("one two");
    control("a");
    CHECK(selected() == "one two");
    type(U"x");
    CHECK(text() == "x");
    CHECK(get("f.mark") == Value());
    control("a");
    tap("delete");
    CHECK(text().empty());
}

TEST_CASE_METHOD(Field, "backspace deletes the selection only") {
    write("héllo");
    shift("left");
    shift("left");
    tap("backspace");
    CHECK(text() == "hél");
    shift("left");
    tap("backspace");
    CHECK(text() == "hé");
}

TEST_CASE_METHOD(Field, "copied text is pasted at the caret") {
    write("ab");
    shift("left");
    control("x");
    CHECK(text() == "a");
    CHECK(get("input.clipboard").text() == "b");
    control("v");
    control("v");
    CHECK(text() == "abb");
    control("a");
    control("v");
    CHECK(text() == "b");
    // Without a selection, nothing is copied.
    control("c");
    control("x");
    CHECK(get("input.clipboard").text() == "b");
    CHECK(text() == "b");
}

TEST_CASE_METHOD(Field, "what is pasted becomes one line") {
    set("input.clipboard", Value("\nfirst\r\nsecond\tthird\n"));
    control("v");
    CHECK(text() == "first second third");
}

TEST_CASE_METHOD(Field, "what is pasted is cut at the greatest length") {
    set("f.max_length", Value(5));
    write("abcd");
    set("input.clipboard", Value("äöü"));
    control("v");
    CHECK(text() == "abcdä");
    control("a");
    control("v");
    CHECK(text() == "äöü");
    control("a");
    type(U"é");
    CHECK(text() == "é");
}

TEST_CASE_METHOD(Field, "a paste that changes the text is an event") {
    set("input.clipboard", Value("new"));
    new_output();
    control("v");
    CHECK(new_output() == "new");
    control("c");
    CHECK(new_output().empty());
}

TEST_CASE_METHOD(Field, "dragging the mouse selects") {
    write("one two");
    point(gap(1));
    set("input.mouse.left", true);
    turn();
    point(gap(5));
    turn();
    CHECK(get("f.caret").integer() == 5);
    CHECK(get("f.mark").integer() == 1);
    point(gap(0));
    turn();
    CHECK(get("f.caret").integer() == 0);
    CHECK(get("f.mark").integer() == 1);
    set("input.mouse.left", false);
    turn();
    CHECK(selected() == "o");
    wait();
    click(gap(3));
    CHECK(get("f.mark") == Value());
    wait();
    set("input.keys.left_shift", true);
    click(gap(5));
    set("input.keys.left_shift", false);
    CHECK(selected() == " t");
}

TEST_CASE_METHOD(Field, "a double click selects a word and a third click everything") {
    write("one two three");
    wait();
    click(gap(5));
    CHECK(get("f.mark") == Value());
    click(gap(5));
    CHECK(selected() == "two");
    click(gap(5));
    CHECK(selected() == "one two three");
    wait();
    click(gap(5));
    CHECK(get("f.mark") == Value());
}

TEST_CASE_METHOD(Field, "a drag after a double click selects words") {
    write("one two three");
    wait();
    click(gap(5));
    point(gap(5));
    set("input.mouse.left", true);
    turn();
    point(gap(9));
    turn();
    CHECK(get("f.caret").integer() == 13);
    point(gap(1));
    turn();
    set("input.mouse.left", false);
    turn();
    CHECK(selected() == "one two");
}

TEST_CASE_METHOD(Field, "a selection beyond the end of a shorter text is that up to its end") {
    write("one two");
    shift("home");
    set("f.text", Value("on"));
    tap("right");
    CHECK(get("f.caret").integer() == 2);
    set("f.mark", Value(1000));
    set("f.caret", Value(1));
    type(U"x");
    CHECK(text() == "ox");
}

TEST_CASE_METHOD(Field, "the selection is drawn while the field has the keyboard") {
    write("one two");
    const std::size_t without = draw().polygons.size();
    control("a");
    CHECK(draw().polygons.size() == without + 1);
    set("interface.focus", Value(at("other")));
    turn();
    const std::size_t elsewhere = draw().polygons.size();
    set("f.mark", Value());
    CHECK(draw().polygons.size() == elsewhere);
}

TEST_CASE("a field that gets the keyboard without the mouse has its text selected") {
    Screen s(
        R"(game.c = Column { f = TextField { text = "AAA", size = vec(300, 40) }, Button { name = "other", text = "other" } }
        function carets() print(c.f.caret, c.f.mark) end)");
    s.run("c.other:focus()");
    s.tap("tab");
    s.run("carets()");
    CHECK(s.new_output() == "3\t0");
    s.type(U"Bob");
    CHECK(s.get("c.f.text").text() == "Bob");
    s.run("c.f:focus() carets()");  // it has the keyboard already
    CHECK(s.new_output() == "3\tnil");
    s.run("c.other:focus() c.f:focus() carets()");
    CHECK(s.new_output() == "3\t0");
    s.type(U"Ann");
    CHECK(s.get("c.f.text").text() == "Ann");
    s.run("c.f.text = '' c.other:focus() c.f:focus() carets()");
    CHECK(s.new_output() == "0\tnil");
    s.run("c.f.text = 'AAA' c.other:focus()");
    s.turn();
    s.click("c.f");  // a click only puts the caret
    s.run("carets()");
    CHECK(s.new_output() == "3\tnil");
}

TEST_CASE("the first field of a menu has its text selected") {
    Screen s("game.menu = Panel { modal = true, TextField { text = 'AAA' } }");
    s.type(U"Bob");
    CHECK(s.get("menu.text_field.text").text() == "Bob");
}

TEST_CASE("a widget without a text is told to have a label beside it") {
    Screen s;
    CHECK_FALSE(s.runtime.run("Slider { text = 'Volume' }", "test"));
    REQUIRE(s.errors.size() == 1);
    CHECK_THAT(s.errors[0], contains("Slider has no property \"text\"; a Label beside it "
                                     "shows a text: Row { Label { text = ..., grow = 1 }, "
                                     "Slider { ... } }"));
    CHECK_FALSE(s.runtime.run("Slider { caption = 'Volume' }", "test"));
    CHECK_THAT(s.errors[1], contains("a Label beside it shows a text"));
}

TEST_CASE_METHOD(Field, "the game does not get the keys of the clipboard") {
    runtime.run("function key_pressed(key) print(key) end", "test");
    new_output();
    control("a");
    control("c");
    control("v");
    CHECK(new_output().find("right_control a") == std::string::npos);
    CHECK(new_output().empty());
}

}  // namespace selection_test
