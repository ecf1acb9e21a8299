// The console with the Lua runtime.

#include "catch.h"
#include "rig.h"

namespace runtime_test {

using namespace fettle;
using console::test::Rig;
using property::Value;
using property::Vec2;

namespace {

/// A rig that evaluates commands with Lua.
class LuaRig : public Rig {
  public:
    explicit LuaRig(script::Options options = {}) : runtime(tree, options), lua(tree, runtime, {}) {
        console.open(false);
    }
    void run(std::string_view command) {
        lua.open();
        for (char c : command) {
            app::InputEvent event;
            event.kind = app::EventKind::text;
            event.character = static_cast<char32_t>(c);
            lua.handle(event);
        }
        press_enter();
    }
    void press_enter() {
        lua.handle(console::test::key_event("enter", true));
        lua.handle(console::test::key_event("enter", false));
        tree.barrier();
    }
    std::string text() {
        std::string all;
        for (const console::LogLine& line : lua.state().log.lines()) all += line.text + "\n";
        return all;
    }
    bool says(std::string_view part) { return text().find(part) != std::string::npos; }

    script::Runtime runtime;
    console::Console lua;
};

}  // namespace

TEST_CASE("an assignment to gravity in the console is echoed with old and new value") {
    LuaRig rig;
    rig.run("world.gravity = vec(0, -2)");
    CHECK(rig.value("world.gravity") == Value(Vec2(0, -2)));
    INFO(rig.text());
    CHECK(rig.says("world.gravity: vec(0, -10) → vec(0, -2) m/s²"));
}

TEST_CASE("an assignment to it in the console selects an instance") {
    LuaRig rig;
    const property::Handle world = rig.tree.child(rig.tree.root(), "world");
    rig.run("it = world.ball");
    CHECK(rig.lua.selected() == rig.tree.child(world, "ball"));
    rig.run("it.mass = 3");
    CHECK(rig.value("world.ball.mass") == Value(3.0));
    rig.run("it = 3");
    INFO(rig.text());
    CHECK(rig.says("`it` is the selected instance: expected an instance or nil, not an integer"));
    CHECK(rig.lua.selected() == rig.tree.child(world, "ball"));
    rig.run("it.mass = 4");
    CHECK(rig.value("world.ball.mass") == Value(4.0));
    rig.run("it = nil");
    CHECK_FALSE(rig.lua.selected());
    // The last result cannot be replaced either.
    rig.run("_, last = 1, 2");
    rig.run("40 + 2");
    rig.run("world.ball.mass = _");
    CHECK(rig.value("world.ball.mass") == Value(42.0));
    // A variable of a script may have any name.
    rig.runtime.run("it = 7 _ = 8 assert(it == 7 and _ == 8)", "main.lua");
}

TEST_CASE("undo of a clone lists no values of the clone") {
    LuaRig rig;
    rig.run("world.ball.mass = 7");
    rig.run("clear");
    rig.run("world:add(world.ball:clone())");
    rig.run("undo");
    rig.run("redo");
    INFO(rig.text());
    CHECK(rig.says("undo: world:add"));
    CHECK_FALSE(rig.says("detached"));
    CHECK_FALSE(rig.says("more change"));
    CHECK_FALSE(rig.says("mass:"));
}

TEST_CASE("an expression prints its value") {
    LuaRig rig;
    rig.run("1 + 2");
    rig.run("world.ball.mass * 3");
    INFO(rig.text());
    CHECK(rig.says("1 + 2\n3\n"));
    CHECK(rig.says("world.ball.mass * 3\n3"));
}

TEST_CASE("a misspelled name is an error with the nearest name and a caret") {
    LuaRig rig;
    rig.run("world.bal.mass = 2");
    INFO(rig.text());
    CHECK(rig.says("did you mean \"ball\""));
    CHECK(rig.says("world.bal.mass = 2\n      ^^^\n"));
    CHECK(rig.lua.state().prompt.edit().empty());
}

TEST_CASE("the prompt of a block stays open until the block is closed") {
    LuaRig rig;
    rig.run("for i = 1, 3 do");
    CHECK(rig.lua.state().prompt.edit().text() == "for i = 1, 3 do\n");
    rig.run("world.ball.lives = i + 4");
    rig.run("end");
    CHECK(rig.value("world.ball.lives") == Value(7));
    CHECK(rig.lua.state().prompt.edit().empty());
}

TEST_CASE("it? explains the selected instance") {
    LuaRig rig;
    rig.run("it?");
    CHECK(rig.says("it: Object"));
    rig.lua.select(rig.tree.child(rig.tree.child(rig.tree.root(), "world"), "ball"));
    rig.run("it?");
    INFO(rig.text());
    CHECK(rig.says("world.ball · Body"));
}

TEST_CASE("an endless command is stopped") {
    script::Options options;
    options.console_budget = 200'000;
    LuaRig rig(options);
    rig.run("while true do end");
    CHECK(rig.lua.state().prompt.edit().empty());
    bool error = false;
    for (const console::LogLine& line : rig.lua.state().log.lines())
        error = error || line.kind == console::LineKind::error;
    INFO(rig.text());
    CHECK(error);
    rig.run("2 + 2");
    CHECK(rig.text().ends_with("2 + 2\n4\n"));
}

TEST_CASE("the variable it is the selected instance") {
    LuaRig rig;
    rig.lua.select(rig.tree.child(rig.tree.child(rig.tree.root(), "world"), "crate"));
    rig.run("it.mass = 9");
    CHECK(rig.value("world.crate.mass") == Value(9.0));
}

TEST_CASE("Tab completes the paths of the tree") {
    LuaRig rig;
    rig.lua.open();
    for (char c : std::string_view("world.ball.fric")) {
        app::InputEvent event;
        event.kind = app::EventKind::text;
        event.character = static_cast<char32_t>(c);
        rig.lua.handle(event);
    }
    rig.lua.handle(console::test::key_event("tab", true));
    INFO(rig.lua.state().prompt.edit().text());
    CHECK(rig.lua.state().prompt.edit().text() == "world.ball.friction");
}

TEST_CASE("candidates show value and type and range and default") {
    LuaRig rig;
    rig.lua.open();
    auto& prompt = rig.lua.state().prompt;
    prompt.edit().insert("world.ball.");
    prompt.key({"tab"});
    REQUIRE(prompt.menu().open());
    CHECK(prompt.menu().candidates().size() >= 12);
    bool found = false;
    for (const auto& candidate : prompt.menu().candidates())
        if (candidate.completion.label == "friction") {
            found = true;
            CHECK(candidate.completion.detail.find("0.6") != std::string::npos);
            CHECK(candidate.completion.detail.find("0 to 1") != std::string::npos);
            CHECK(candidate.completion.doc == "Of the surface.");
        }
    CHECK(found);
}

TEST_CASE("help is printed for a path with a question mark") {
    LuaRig rig;
    rig.run("world.ball.mass?");
    INFO(rig.text());
    CHECK(rig.says("Resists being moved"));
}

TEST_CASE("a write by a console command is recorded as the console's") {
    LuaRig rig;
    property::Writer writer = property::Writer::module;
    auto connection =
        rig.tree.watch(rig.tree.child(rig.tree.child(rig.tree.root(), "world"), "ball"), "mass",
                       [&](const property::Change& change) { writer = change.cause.writer; });
    rig.run("world.ball.mass = 3");
    CHECK(writer == property::Writer::console);
    connection.stop();
}

TEST_CASE("the properties of the console can be used in the console") {
    LuaRig rig;
    rig.run("console.height = 0.7");
    rig.lua.draw(rig.surface, 1.0 / 60);
    CHECK(rig.text().find("console.height") != std::string::npos);
}

}  // namespace runtime_test
