// Where widgets are.

#include "screen.h"

namespace layout_test {

using namespace fettle::interface::test;

namespace {

struct Placed : Screen {
    using Screen::Screen;
    Vec2 at(const std::string& path) const { return get(path + ".screen_position").vec2(); }
    Vec2 size(const std::string& path) const { return get(path + ".screen_size").vec2(); }
};

}  // namespace

TEST_CASE("a widget is at its anchor and follows the size of the screen") {
    Placed s(
        "game.a = Panel { anchor = 'bottom_right', size = vec(200, 100), offset = vec(-10, -20) }");
    CHECK(s.at("a") == Vec2(1070, 600));
    CHECK(s.size("a") == Vec2(200, 100));
    s.set("a.anchor", Value("center"));
    CHECK(s.at("a") == Vec2(530, 290));
    s.services.view.screen = {1920, 1080};
    s.turn();
    CHECK(s.size("a") == Vec2(300, 150));  // the screen is 720 high for the layout
    CHECK(s.at("a") == Vec2(795, 435));
    s.set("interface.scale", Value(2.0));
    CHECK(s.size("a") == Vec2(400, 200));
    s.set("a.fill", Value("width"));
    CHECK(s.size("a").x > 1900);
}

TEST_CASE("a column with several columns is a grid") {
    Placed s(
        R"(game.g = Column { columns = 2, spacing = 10, Panel { size = vec(100, 30) }, Panel { size = vec(50, 60) },
        Panel { size = vec(0, 20) } })");
    CHECK(s.size("g") == Vec2(210, 90));  // all columns are as wide as the widest
    CHECK(s.at("g.panel") == Vec2(0, 15));
    CHECK(s.at("g.panel_2") == Vec2(110, 0));
    CHECK(s.at("g.panel_3") == Vec2(0, 70));
    CHECK(s.size("g.panel_3") == Vec2(100, 20));
    s.set("g.size", Value(Vec2(310, 100)));
    CHECK(s.size("g.panel_3") == Vec2(150, 20));
    CHECK(s.at("g.panel_2").x == 160);
    s.set("g.justify", Value("end"));
    CHECK(s.at("g.panel_3").y == 80);
    s.set("g.align", Value("end"));
    CHECK(s.at("g.panel_2").x + s.size("g.panel_2").x == 210);
    s.set("g.panel.grow", Value(1.0));  // the first column takes what the second one leaves
    CHECK(s.at("g.panel_2").x == 260);
    s.set("g.columns", Value(1));
    CHECK(s.at("g.panel_2").y == s.at("g.panel").y + 30 + 10);
    s.set("g.columns", Value(1000));
    CHECK(s.at("g.panel_3").x > s.at("g.panel_2").x);
    s.run("for _, each in ipairs(g:children()) do each:delete() end");
    CHECK(s.size("g").x == 310);
}

TEST_CASE("a grid that is too narrow cuts the texts of buttons and keeps its labels") {
    Placed s(
        R"(game.g = Column { columns = 2, size = vec(300, 0), Label { text = "Jump", grow = 1 },
        Button { text = "space, gamepad a, mouse left, and many other keys" },
        Label { text = "Name", grow = 1 }, TextField { size = vec(80, 40) } }
        game.free = Label { text = "Jump" })");
    CHECK(s.size("g.label").x >= s.size("free").x);
    CHECK(s.size("g.label").y == s.size("free").y);
    CHECK(s.at("g.button").x + s.size("g.button").x == 300);
    CHECK(s.at("g.text_field").x == s.at("g.button").x);
    s.run(
        "game.n = Column { columns = 3, size = vec(200, 0) } for i = 1, 3 do n:add(Button { text = "
        "'a wide text' }) end");
    CHECK(s.at("n.button_3").x + s.size("n.button_3").x <= 200);
}

TEST_CASE("in a window that is higher than wide the width decides how large widgets are") {
    Placed s("game.a = Panel { anchor = 'center', size = vec(560, 100) }");
    s.services.view.screen = {400, 700};
    s.turn();
    CHECK(s.size("a").x < 320);
    CHECK(s.at("a").x > 40);
    s.services.view.screen = {700, 400};
    s.turn();
    CHECK(s.size("a").x < 320);
}

TEST_CASE("columns and rows place their widgets after each other") {
    Placed s(
        R"(game.p = Panel { padding = 20, anchor = "top_left", Column { spacing = 8, size = vec(300, 0),
        Panel { size = vec(100, 30) }, Panel { size = vec(0, 40), min_size = vec(50, 50) },
        Row { spacing = 10, Panel { size = vec(60, 20) }, Panel { grow = 2, size = vec(0, 20) }, Panel { grow = 1, size = vec(0, 20) } } } })");
    CHECK(s.at("p.column.panel") == Vec2(20, 20));
    CHECK(s.size("p.column.panel") == Vec2(100, 30));
    CHECK(s.at("p.column.panel_2") == Vec2(20, 58));
    CHECK(s.size("p.column.panel_2") == Vec2(300, 50));
    CHECK(s.at("p.column.row") == Vec2(20, 116));
    // A panel has its padding on both sides; what is left over goes to those that grow.
    const double second = s.size("p.column.row.panel_2").x,
                 third = s.size("p.column.row.panel_3").x;
    CHECK(s.at("p.column.row.panel_3").x + third == 320);
    CHECK(second > third);
    CHECK(60 + 10 + second + 10 + third == 300);
    CHECK(s.size("p").x == 340);
    s.set("p.column.panel.visible", Value(false));
    CHECK(s.at("p.column.panel_2") == Vec2(20, 20));
    s.set("p.column.align", Value("end"));
    CHECK(s.at("p.column.panel_2").x + s.size("p.column.panel_2").x == 320);
    s.set("p.column.size", Value(Vec2(300, 400)));
    s.set("p.column.justify", Value("end"));
    CHECK(s.at("p.column.row").y + s.size("p.column.row").y == 420);
}

TEST_CASE("a label as wide as its text shows all of it wherever it is") {
    Placed s(R"(for i = 1, 100 do
        game:add(Label { text = "appears", font = "sans", font_size = 10 + i / 4, offset = vec(20 + i / 37, 7 * i), overflow = "cut" })
    end)");
    for (const double height : {600.0, 720.0, 800.0, 900.0, 1080.0}) {
        s.services.view.screen = {1280, height};
        s.turn();
        CHECK(s.draw().pictures_drawn == 100 * 7);
    }
}

TEST_CASE("in a row that is too narrow the widest texts are cut and short ones are whole") {
    Placed s(R"(game.c = Column { size = vec(340, 0),
        Row { Label { text = "Jump", grow = 1 }, Button { text = "space, gamepad a, mouse left" } },
        Row { Button { text = "Yes" }, Button { text = "a text that is much longer than there is room for it here" },
              Slider { size = vec(80, 0) } },
        Row { Label { text = "some words that wrap as long as it takes", grow = 1 }, Button { text = "Yes" } } }
        game.free = Label { text = "Jump" } game.yes = Button { text = "Yes" })");
    // The word in the label is whole, and the button has the rest.
    const auto right = [&](const std::string& path) { return s.at(path).x + s.size(path).x; };
    const double end = right("c");
    CHECK(s.size("c.row.label").x >= s.size("free").x);
    CHECK(s.size("c.row.label").y == s.size("free").y);
    CHECK(s.size("c.row.button").x > 200);
    CHECK(right("c.row.button") <= end + 1);
    CHECK(s.size("c.row_2.button").x == s.size("yes").x);
    CHECK(right("c.row_2.slider") <= end + 1);
    CHECK(right("c.row_2.slider") > end - 3);
    CHECK(s.size("c.row_3.button").x == s.size("yes").x);
    CHECK(s.size("c.row_3.label").y > 1.5 * s.size("free").y);
    CHECK(right("c.row_3.button") <= end + 1);
    // Where there is room, nothing is cut.
    s.set("c.size", Value(Vec2(900, 0)));
    CHECK(s.size("c.row.button").x < 400);
    CHECK(right("c.row_2.slider") < right("c"));
}

TEST_CASE("text that is too long wraps or is cut") {
    Placed s(
        R"(game.l = Label { size = vec(200, 0), text = "one two three four five six seven eight nine ten" })");
    const double wrapped = s.size("l").y;
    s.set("l.overflow", Value("cut"));
    const double cut = s.size("l").y;
    CHECK(wrapped >= 2 * cut - 1);
    const int few = s.draw().pictures_drawn;
    CHECK(few > 5);
    s.set("l.size", Value(Vec2(900, 0)));
    CHECK(s.draw().pictures_drawn > few);
    s.set("l.text", Value(std::string(5000, 'w')));
    s.set("l.overflow", Value("wrap"));
    CHECK(s.draw().pictures_drawn < 200);
    s.set("l.text", Value("one\n\nthree"));
    CHECK(s.size("l").y > 2.5 * cut);
}

TEST_CASE("a label without spaces wraps where its language allows it") {
    Placed s(R"(game.l = Label { size = vec(200, 0), text = "one" })");
    const double one = s.size("l").y;
    s.set("l.text", Value("我知道，火车一个小时前就开走了，下一班要等到明天早上才会来。"));
    CHECK(s.size("l").y > 1.9 * one);
    CHECK(s.draw().pictures_drawn == 30);  // nothing is cut
}

TEST_CASE("each line of a wrapped text runs in the direction of its paragraph") {
    // Wide enough for the first word, and for the rest.
    Placed s(R"(game.l = Label { size = vec(120, 0), font_size = 20 })");
    const auto drawn = [&](const char* text) {
        s.set("l.text", Value(text));
        return s.draw().pictures;
    };
    const char* const right_to_left = "\u200f";
    const char* const left_to_right = "\u200e";
    // The second line begins with Latin letters, which are at its right end.
    const auto hebrew = drawn("אבגדהוזחט ab אב");
    CHECK(hebrew == drawn((std::string("אבגדהוזחט\n") + right_to_left + "ab אב").c_str()));
    CHECK(hebrew != drawn("אבגדהוזחט\nab אב"));  // a paragraph of its own
    const auto latin = drawn("abcdefghijk אב ab");
    CHECK(latin == drawn((std::string("abcdefghijk\n") + left_to_right + "אב ab").c_str()));
    CHECK(latin != drawn("abcdefghijk\nאב ab"));
}

TEST_CASE("a button or a toggle that wraps its text is as high as its lines") {
    Placed s(R"(game.p = Column { size = vec(200, 0), align = "start",
        Button { size = vec(200, 0), text = "one two three four five six seven eight nine ten" },
        Toggle { size = vec(200, 0), text = "one two three four five six seven eight nine ten" } })");
    for (const std::string name : {"p.button", "p.toggle"}) {
        INFO(name);
        const double one = s.size(name).y;
        const int few = s.draw().pictures_drawn;
        s.set(name + ".overflow", Value("wrap"));
        CHECK(s.size(name).y > 1.5 * one);
        CHECK(s.draw().pictures_drawn > few);
    }
}

TEST_CASE("nothing is laid out unless something changed") {
    Placed s(R"(game.p = Panel { Column { Label { text = "a" }, Button { text = "b" } } })");
    s.draw();
    const auto before = s.interface.layouts();
    for (int i = 0; i < 10; ++i) {
        s.set("view.center", Value(Vec2(i, 0)));
        s.tree.create(s.tree.object_class(), s.tree.root());
        s.turn();
        s.draw();
    }
    CHECK(s.interface.layouts() == before);
    s.set("p.column.label.text", Value("a"));  // the same
    s.draw();
    CHECK(s.interface.layouts() == before);
    s.set("p.column.label.text", Value("longer"));
    s.draw();
    CHECK(s.interface.layouts() == before + 1);
    s.set("interface.theme.font_size", Value(30.0));
    s.draw();
    CHECK(s.interface.layouts() == before + 2);
}

TEST_CASE("a theme holds for everything below the widget that has it") {
    Placed s(R"(
        game.big = Theme { font_size = 40 }
        game.p = Panel { Column { Label { text = "a" }, Row { Label { text = "a" } } } })");
    const double small = s.size("p.column.row.label").y;
    s.run("p.column.row.theme = big");
    CHECK(s.size("p.column.row.label").y > 2 * small);
    CHECK(s.size("p.column.label").y == small);
    s.set("big.font_size", Value(20.0));
    CHECK(s.size("p.column.row.label").y < 2 * small);
    s.run("game.big = nil");
    CHECK(s.size("p.column.row.label").y == small);
    s.set("interface.theme.font_size", Value(34.0));
    CHECK(s.size("p.column.row.label").y > 1.8 * small);
}

TEST_CASE("a thousand nested widgets do no harm") {
    Placed s(R"(local inner = Panel { padding = 1 }
        for i = 1, 300 do inner = Panel { padding = 1, inner } end
        game.p = inner)");
    s.draw();
    s.turn();
    CHECK(s.errors.empty());
}

TEST_CASE("later widgets and those with a higher z are in front") {
    Placed s(R"(
        game.a = Button { text = "a", size = vec(200, 100) }
        game.b = Button { text = "b", size = vec(200, 100) }
        game.a:on("pressed", function() print("a") end)
        game.b:on("pressed", function() print("b") end))");
    s.click(Vec2(20, 20));
    CHECK(s.new_output() == "b");
    s.set("a.z", Value(1.0));
    s.click(Vec2(20, 20));
    CHECK(s.new_output() == "a");
}

TEST_CASE("the visible widget at a point of the screen is found") {
    Placed s(R"(
        game.around = Column { size = vec(600, 0), offset = vec(100, 100), spacing = 20,
            Label { text = "a label" }, Button { text = "a button", disabled = true } }
        game.hidden = Button { size = vec(600, 600), visible = false }
        game.panel = Panel { size = vec(100, 100), anchor = "bottom_right" })");
    const auto seen = [&](const Vec2& point) {
        const Result result =
            s.tree.call(s.tree.child(s.tree.root(), "interface"), "widget_at", {Value(point)});
        const Value& value = std::get<Value>(result);
        return value.is_nil() ? "" : s.tree.path(value.reference());
    };
    for (const std::string path : {"around.label", "around.button", "panel"})
        CHECK(seen(s.at(path) + s.size(path) / 2) == path);
    // Between the widgets of a column without a color, and no widget at all.
    CHECK(seen(s.at("around.button") - Vec2(-3, 10)).empty());
    CHECK(seen({2, 2}).empty());
}

}  // namespace layout_test
