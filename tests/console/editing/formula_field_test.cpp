// Formulas that are typed into the rows of the inspector, and the gutter with the last writers.

#include <look/imgui_compat.h>
#include "catch.h"
#include "rig.h"

namespace formula_field_test {

using namespace fettle;
using console::test::Rig;
using property::Handle;
using property::Value;
using property::Vec2;

namespace {

/// A rig with Lua and with `world.ball` selected.
struct FormulaRig {
    explicit FormulaRig(console::Options options = {})
        : runtime((console::test::make_game(tree), tree), {}),
          lua(tree, runtime, std::move(options)) {
        ball = tree.child(tree.child(tree.root(), "world"), "ball");
        lua.open();
        show();
        lua.select(ball);
        show();
    }
    void show(int frames = 3) {
        for (; frames > 0; --frames) {
            surface.clear();
            lua.draw(surface, 1.0 / 60);
        }
    }
    void click(ImVec2 at) {
        for (const auto kind : {app::EventKind::mouse_moved, app::EventKind::mouse_pressed,
                                app::EventKind::mouse_released}) {
            app::InputEvent event;
            event.kind = kind;
            event.name = "left";
            event.x = at.x;
            event.y = at.y;
            lua.handle(event);
            show(1);
        }
    }
    void key(std::string_view name) {
        lua.handle(console::test::key_event(name, true));
        lua.handle(console::test::key_event(name, false));
    }
    void type(std::string_view text) {
        for (const char c : text) {
            app::InputEvent event;
            event.kind = app::EventKind::text;
            event.character = static_cast<char32_t>(c);
            lua.handle(event);
        }
    }
    console::PropertyEditor& editor() { return lua.state().inspector.editor(); }
    const property::Property& property(const char* name) { return tree.property(ball, name); }
    void scroll_to(const char* name) {
        lua.state().inspector.select(ball, name);
        show();
    }
    /// A double click on the name of a property.
    void open(const char* name) {
        scroll_to(name);
        show(20);  // so that earlier clicks do not count
        const console::Rect widget = editor().widget_rect(property(name));
        REQUIRE_FALSE(widget.empty());
        const ImVec2 at(widget.low.x - 40, widget.low.y + 6);
        click(at);
        click(at);
        show(4);
    }
    void define(const char* name, const std::string& formula) {
        open(name);
        type(formula);
        key("enter");
        show();
    }
    /// A click on the writer of the mass, after `writer` wrote it in step 412.
    void click_writer_of_mass(property::Writer writer) {
        tree.set_step(412);
        {
            const property::Tree::CauseScope cause(tree, writer);
            tree.set(ball, "mass", Value(3.0));
        }
        scroll_to("mass");
        click(editor().gutter_rect(property("mass")).middle());
    }
    std::string source(const char* name) {
        const property::Formula* formula = tree.formula(ball, property(name));
        return formula == nullptr ? "" : formula->source;
    }
    std::string text() {
        std::string all;
        for (const console::LogLine& line : lua.state().log.lines()) all += line.text + "\n";
        return all;
    }

    property::Tree tree;
    script::Runtime runtime;
    console::test::RasterSurface surface{1280, 800};
    console::Console lua;
    Handle ball;
};

}  // namespace

TEST_CASE("a formula is typed into the row of every kind of property") {
    FormulaRig rig;
    const std::pair<const char*, const char*> formulas[] = {
        {"mass", "2 + 3"},
        {"lives", "2 + 4"},
        {"position", "vec(1, 2)"},
        {"color", "color(0, 1, 0)"},
        {"awake", "1 > 2"},
        {"type", "'stat' .. 'ic'"},
        {"label", "'a' .. 'b'"},
        {"target", "world.crate"},
        {"vertices", "{ vec(0, 0), vec(2, 0), vec(0, 2) }"},
    };
    for (const auto& [name, formula] : formulas) {
        INFO(name);
        rig.define(name, std::string("is ") + formula);
        CHECK(rig.editor().problem(rig.property(name)) == "");
        CHECK(rig.source(name) == formula);
    }
    const auto value = [&](const char* name) { return rig.tree.get(rig.ball, name); };
    CHECK(value("mass") == Value(5.0));
    CHECK(value("lives") == Value(6));
    CHECK(value("position") == Value(Vec2(1, 2)));
    CHECK(value("color") == Value(property::Color{0, 1, 0, 1}));
    CHECK(value("awake") == Value(false));
    CHECK(value("type") == Value("static"));
    CHECK(value("label") == Value("ab"));
    CHECK(value("target") == Value(property::resolve(rig.tree, "world.crate").instance));
    CHECK(value("vertices").list().size() == 3);
}

TEST_CASE("a number is no formula of a vector") {
    FormulaRig rig;
    rig.define("position", "is 3");
    CHECK(rig.editor().problem(rig.property("position")) ==
          "a formula is for the whole vector, as in is vec(x, y)");
    CHECK(rig.source("position").empty());
}

TEST_CASE("a formula is shown where it is edited and an error stays until it is mended") {
    FormulaRig rig;
    rig.define("awake", "1 < 2");
    CHECK(rig.source("awake") == "1 < 2");  // without the word `is`
    rig.define("awake", "is 1 <");
    CHECK_FALSE(rig.editor().problem(rig.property("awake")).empty());
    CHECK(rig.source("awake") == "1 < 2");
    rig.type("is 1 < 5");  // the field has kept the focus, and its text is selected
    rig.key("enter");
    rig.show();
    CHECK(rig.source("awake") == "1 < 5");
    CHECK(rig.editor().problem(rig.property("awake")).empty());
    rig.open("awake");
    rig.key("escape");
    rig.show();
    CHECK(rig.source("awake") == "1 < 5");
    CHECK(rig.lua.is_open());
}

TEST_CASE("a button ends the formula of a value that the simulation writes") {
    FormulaRig rig;
    rig.define("speed", "1 + 1");
    REQUIRE(rig.source("speed") == "1 + 1");
    rig.scroll_to("speed");
    const console::Rect widget = rig.editor().widget_rect(rig.property("speed"));
    rig.click(ImVec2(widget.high.x + 16, widget.low.y + 8));
    CHECK(rig.source("speed").empty());
}

TEST_CASE("no tooltip covers a field while one types into it") {
    FormulaRig rig;
    const auto tooltip = [&] {
        const ImGuiWindow* const window = ImGui::FindWindowByName("##Tooltip_00");
        return window != nullptr && window->Active;
    };
    rig.open("mass");  // the mouse stays on the name
    CHECK_FALSE(tooltip());
    rig.key("escape");
    rig.show();
    CHECK(tooltip());
}

TEST_CASE("a text that begins with is becomes a formula") {
    FormulaRig rig;
    rig.scroll_to("label");
    rig.click(rig.editor().widget_rect(rig.property("label")).middle());
    rig.show(4);
    rig.type("is world.ball.mass .. ' kg'");
    rig.key("enter");
    rig.show();
    CHECK(rig.source("label") == "world.ball.mass .. ' kg'");
}

TEST_CASE("the gutter leads to the line of the script that wrote a value") {
    std::string requested_file;
    FormulaRig rig({.script = [&](const std::string& file) {
        requested_file = file;
        return std::string("one\ntwo\nthree\nfour\nfive\nsix\nseven");
    }});
    rig.tree.locate_writes(true);
    std::function<std::string()> place = [] { return std::string("main.lua:2"); };
    {
        const property::Tree::CauseScope cause(rig.tree, property::Writer::script, &place);
        rig.tree.set(rig.ball, "mass", Value(3.0));
    }
    rig.scroll_to("mass");
    const console::Rect at = rig.editor().gutter_rect(rig.property("mass"));
    REQUIRE_FALSE(at.empty());
    rig.click(at.middle());
    CHECK(requested_file == "main.lua");
    CHECK(rig.text().find("› 2  two") != std::string::npos);
    CHECK(rig.text().find("  5  five") != std::string::npos);
    CHECK(rig.text().find("six") == std::string::npos);
}

TEST_CASE("the gutter leads to the step in which the console wrote a value") {
    FormulaRig rig;
    rig.click_writer_of_mass(property::Writer::console);
    CHECK(rig.text().find("time:go_to(412)") != std::string::npos);
    CHECK(rig.tree.get(rig.tree.child(rig.tree.root(), "time"), "paused") == Value(true));
    const console::Rect simulated = [&] {
        rig.scroll_to("speed");
        return rig.editor().gutter_rect(rig.property("speed"));
    }();
    rig.click(simulated.middle());
    CHECK(rig.text().find("why world.ball.speed") != std::string::npos);
}

TEST_CASE("the gutter prints who wrote a value if that was neither a person nor the simulation") {
    FormulaRig rig;
    rig.click_writer_of_mass(property::Writer::load);
    CHECK(rig.text().find("who world.ball.mass") != std::string::npos);
    CHECK(rig.text().find("time:go_to") == std::string::npos);
}

TEST_CASE("the last writer has short names") {
    using console::writer_text;
    using property::Writer;
    CHECK(writer_text({Writer::script, "main.lua:30", 5}) == "main.lua:30");
    CHECK(writer_text({Writer::console, "", 412}) == "console, step 412");
    CHECK(writer_text({Writer::console, "console:1", 412}) == "console, step 412");
    CHECK(writer_text({Writer::simulation, "", 412}) == "physics");
    CHECK(console::script_place("lib/a.lua:30") == std::pair<std::string, int>("lib/a.lua", 30));
    CHECK(console::script_place("console:1").first.empty());
    CHECK(console::script_place("a.lua:x").first.empty());
}

}  // namespace formula_field_test
