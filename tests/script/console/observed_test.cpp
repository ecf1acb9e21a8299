// What outlives the selection or a command: `it` in formulas, observed values, and the functions
// that a console carries out.

#include "stage.h"

#include <fettle/property/path.h>
#include <fettle/script/observed.h>

namespace observed_test {

using stage::Stage;
using stage::Value;
namespace script = fettle::script;

namespace {

/// Two bodies, `world.ball` selected; then `world.other` is.
struct TwoBodies : Stage {
    TwoBodies() {
        run("world.ball = Body { mass = 2 } world.other = Body { mass = 30 }");
        select("ball");
    }
    void select(const char* name) {
        runtime->set_selected(tree->child(tree->child(tree->root(), "world"), name));
    }
};

/// Receives the calls of scripts for a console.
struct Served : TwoBodies {
    std::vector<script::Observed> pinned, plotted, searched;
    std::vector<std::string> texts;

    Served() {
        script::ConsoleFunctions f;
        f.pin = [this](script::Observed what) {
            pinned.push_back(std::move(what));
            return std::string();
        };
        f.pins = [this] {
            std::vector<std::pair<std::string, Value>> all;
            for (const script::Observed& each : pinned) all.emplace_back(each.text, each.value());
            return all;
        };
        f.listed = [this](script::Listed) {
            std::vector<std::string> lines;
            for (const script::Observed& each : pinned)
                lines.push_back(each.text + "  " + tree->text(each.value()));
            return lines;
        };
        f.unpin = [this](const std::string& text) {
            texts.push_back("unpin " + text);
            return std::string(text == "world.ball.mass" ? "" : "nothing like that is pinned");
        };
        f.plot = [this](std::vector<script::Observed> all) {
            plotted = std::move(all);
            return std::to_string(plotted.size()) + " plotted";
        };
        f.last_time = [this](script::Observed what) { searched.push_back(std::move(what)); };
        f.bind = [this](const std::string& key, const std::string& command) {
            texts.push_back(key + ": " + command);
            return std::string();
        };
        f.alias = [this](const std::string& word, const std::string& command) {
            texts.push_back(word + " = " + command);
            return std::string();
        };
        runtime->serve_console(std::move(f));
    }
};

}  // namespace

TEST_CASE("a formula keeps the instance that was selected when it was typed") {
    TwoBodies s;
    CHECK_THAT(s.console("world.other.friction is it.mass / 4"), contains("world.ball.mass / 4"));
    CHECK(s.get("world.other.friction") == Value(0.5));
    s.select("other");
    s.console("world.ball.mass = 3");
    CHECK(s.get("world.other.friction") == Value(0.75));
    CHECK_THAT(s.console("why world.other.friction"), contains("is world.ball.mass / 4"));
}

TEST_CASE("a function that is a formula keeps the instance that was selected") {
    TwoBodies s;
    s.console("world.other.friction = formula(function() return it.mass / 4 end)");
    s.select("other");
    s.console("world.ball.mass = 3");
    CHECK(s.get("world.other.friction") == Value(0.75));
    // The rest of its environment is that of the game.
    s.console("factor = 2");
    s.console("world.ball.friction = formula(function() return factor * it.mass / 240 end)");
    CHECK(s.get("world.ball.friction") == Value(0.25));
}

TEST_CASE("only the variable named it is the selected instance") {
    TwoBodies s;
    s.console("game.note = Object {}");
    s.console("game.note.it = 8");
    CHECK_THAT(s.console("world.other.friction is game.note.it / 16"), contains("game.note.it"));
    CHECK(s.get("world.other.friction") == Value(0.5));
    // In a text, as a field, and as a parameter.
    const std::string odd =
        "world.other.friction is #\"it\" / 4 + (function(it) return it end)(0.25)";
    CHECK_THAT(s.console(odd), contains("#\"it\" / 4 + (function(it) return it end)(0.25)"));
    CHECK(s.get("world.other.friction") == Value(0.75));
    CHECK_THAT(s.console("world.other.friction is ({it = 1}).it / 2"),
               contains("({it = 1}).it / 2"));
    CHECK_THAT(s.console("world.other.friction is #(it.name..it.name) / 10"),
               contains("#(world.ball.name..world.ball.name) / 10"));
}

TEST_CASE("a formula with it needs a selection") {
    Stage s;
    s.run("world.ball = Body {}");
    CHECK_THAT(s.console("world.ball.friction is it.mass"), contains("it: nothing is selected"));
}

TEST_CASE("find and help take words without quotes") {
    TwoBodies s;
    CHECK_THAT(s.console("find fric"), contains("Body.friction"));
    CHECK_THAT(s.console("find no such word"), contains("nothing has"));
    CHECK_THAT(s.console("help world.ball.mass"), contains("Body.mass"));
    CHECK_THAT(s.console("help Body"), contains("friction"));
}

TEST_CASE("who and why take a path without quotes") {
    TwoBodies s;
    s.console("world.ball.mass = 5");
    CHECK_THAT(s.console("who world.ball.mass"), contains("world.ball.mass: console"));
    CHECK_THAT(s.console("who it.mass"), contains("world.ball.mass: console"));
    CHECK_THAT(s.console("why it.mass"), contains("world.ball.mass = 5"));
    CHECK_THAT(s.console("who(\"it.mass\")"), contains("world.ball.mass: console"));
    CHECK_THAT(s.console("why world.ball.mas"), contains("did you mean \"mass\""));
    CHECK_THAT(s.console("whom world.ball.mass"), contains("error"));
}

TEST_CASE("who of an instance names the writer of each property") {
    TwoBodies s;
    s.console("world.ball.mass = 5");
    s.console("world.ball.friction = 0.1");
    const std::string writers = s.console("who world.ball");
    CHECK_THAT(writers, contains("world.ball.mass: console"));
    CHECK_THAT(writers, contains("world.ball.friction: console"));
    CHECK_THAT(s.console("why world.ball"), contains("name one of its properties"));
}

TEST_CASE("undo and redo print how values changed") {
    TwoBodies s;
    s.console("world.ball.mass = 5");
    CHECK(s.console("undo") == "undo: world.ball.mass = 5|  world.ball.mass: 5 → 2 kg");
    CHECK(s.console("redo") == "redo: world.ball.mass = 5|  world.ball.mass: 2 → 5 kg");
    s.console("world.ball.mass is world.other.mass");
    CHECK_THAT(s.console("undo"), contains("world.ball.mass: is world.other.mass → 5 kg"));
    s.console("world.ball.label = 'x'");
    CHECK_THAT(s.console("undo"), contains("world.ball.label: \"x\" → nil"));
    s.console("for i = 1, 30 do world.ball['n' .. i] = i end");
    CHECK_THAT(s.console("undo"), contains("… 10 more (30 changes)"));
}

TEST_CASE("the changes of an edit and of its undoing that are not shown can be opened") {
    TwoBodies s;
    for (const char* command : {"for i = 1, 30 do world.ball['n' .. i] = i end", "undo", "redo"}) {
        INFO(command);
        const fettle::script::Evaluation typed = s.runtime->evaluate(command);
        REQUIRE(typed.folded.size() == 1);
        CHECK(typed.lines.at(typed.folded[0].line) == "… 10 more (30 changes)");
        REQUIRE(typed.folded[0].lines.size() == 10);
        CHECK_THAT(typed.folded[0].lines[0], contains("world.ball.n"));
    }
}

TEST_CASE("undo and redo name the instances that they make and delete and rename") {
    TwoBodies s;
    s.console("world.extra = Body { Circle {}, mass = 3 }");
    CHECK(s.console("undo") ==
          "undo: world.extra = Body { Circle {}, mass = 3 }|  world.extra: deleted");
    CHECK_THAT(s.console("redo"), contains("|  world.extra: exists again (Body)"));
    s.console("world.extra:delete()");
    CHECK(s.console("undo") == "undo: world.extra:delete()|  world.extra: exists again (Body)");
    CHECK(s.console("redo") == "redo: world.extra:delete()|  world.extra: deleted");
    s.console("world.ball.name = 'stone'");
    CHECK_THAT(s.console("undo"), contains("|  world.stone: is world.ball now"));
    CHECK_THAT(s.console("redo"), contains("|  world.ball: is world.stone now"));
    s.console("for i = 1, 30 do world['n' .. i] = Body {} end world.stone.mass = 7");
    const std::string undone = s.console("undo");
    CHECK_THAT(undone, contains("|  world.n20: deleted"));
    CHECK_THAT(undone, contains("… 11 more (31 changes)"));
}

TEST_CASE("the history begins with the latest edit") {
    TwoBodies s;
    s.console("world.ball.mass = 5");
    s.console("world.ball.mass = 6");
    const std::string listed = s.console("history");
    CHECK(listed.find("mass = 6") < listed.find("mass = 5"));
}

TEST_CASE("lines beyond the limit of a command are counted as lines") {
    Stage s;
    s.run("world.ball = Body {}");
    CHECK_THAT(s.console("for i = 1, 2001 do print(i) end"), contains("|… 1 more line"));
    const std::string both =
        s.console("for i = 1, 2005 do print(i) end for i = 1, 23 do world.ball['n' .. i] = i end");
    CHECK_THAT(both, contains("|… 5 more lines|") && contains("… 3 more (23 changes)"));
}

TEST_CASE("help of a callback that the game defines is its documentation") {
    Stage s;
    s.run("function update(dt) end");
    CHECK_THAT(s.console("help(update)"), contains("Called every frame"));
    CHECK_THAT(s.console("update?"), contains("Called every frame"));
}

TEST_CASE("help of a callback that the game lacks is its documentation") {
    Stage s;
    CHECK_THAT(s.console("help(update)"), contains("Called every frame"));
    CHECK_THAT(s.console("help(nil)"), contains("nil"));
}

TEST_CASE("functions that need a console are refused without one and do nothing in a replay") {
    Stage s;
    s.run("world.ball = Body {}");
    CHECK_THAT(s.console("pin world.ball.mass"), contains("pin: this run has no console"));
    CHECK_THAT(s.console("clear"), contains("clear: this run has no console"));
    script::Options options = stage::unhurried();
    options.replay = "a recording";
    Stage replay(options);
    replay.run("world.ball = Body {}");
    CHECK(replay.console("pin world.ball.mass").empty());
}

TEST_CASE("an observed value is a path or an expression or a function") {
    Served s;
    s.console("pin('world.ball.mass', 'it.mass > 1', function() return it.mass * 2 end)");
    REQUIRE(s.pinned.size() == 3);
    CHECK(s.pinned[0].path == "world.ball.mass");
    CHECK(s.pinned[0].unit == "kg");
    CHECK(s.pinned[0].value() == Value(2.0));
    CHECK(s.pinned[1].text == "world.ball.mass > 1");
    CHECK(s.pinned[1].path.empty());
    CHECK(s.pinned[1].value() == Value(true));
    s.select("other");
    CHECK(s.pinned[2].value() == Value(4.0));
    CHECK_THAT(s.pinned[2].text, contains("it.mass * 2"));
}

TEST_CASE("several values are plotted by words with commas") {
    Served s;
    s.console("plot it.mass, math.max(world.ball.mass, 7), world.other.position");
    REQUIRE(s.plotted.size() == 3);
    CHECK(s.plotted[1].value() == Value(7));
    CHECK(s.plotted[2].unit == "m");
    s.console("plot()");
    CHECK(s.plotted.empty());
}

TEST_CASE("a command is answered by the console and a script is not") {
    Served s;
    CHECK_THAT(s.console("plot it.mass, it.mass > 1"), contains("2 plotted"));
    std::vector<std::string> printed;
    s.runtime->on_print([&](std::string_view text) { printed.emplace_back(text); });
    s.run("plot('world.ball.mass') unpin('nothing')");
    CHECK(s.plotted.size() == 1);
    CHECK(printed.empty());
}

TEST_CASE("pin alone lists what is pinned unless the game has a variable of that name") {
    Served s;
    s.console("pin world.ball.mass");
    CHECK_THAT(s.console("pin"), contains("world.ball.mass") && contains("2"));
    CHECK_THAT(s.console("pins"), contains("world.ball.mass"));
    CHECK_THAT(s.console("pins()[\"world.ball.mass\"] * 2"), contains("4"));
    s.run("pin = 7");
    CHECK_THAT(s.console("pin"), contains("7"));
}

TEST_CASE("an observed expression cannot change the game") {
    Served s;
    s.console("pin(function() world.ball.mass = 9 return 1 end)");
    CHECK_THROWS_WITH(s.pinned.at(0).value(), contains("cannot"));
    CHECK(s.get("world.ball.mass") == Value(2.0));
    s.console("pin(function() while true do end end)");
    CHECK_THROWS(s.pinned.at(1).value());
    s.console("pin(function() return print end)");
    CHECK_THROWS(s.pinned.at(2).value());
}

TEST_CASE("an observed value reads the present results of formulas") {
    Served s;
    s.console("world.ball.friction is world.other.mass / 60");
    s.console("pin world.ball.friction * 2");
    s.run("world.other.mass = 6");
    s.pinned.at(0).compute_formulas();
    CHECK(s.pinned.at(0).value().number() == Approx(0.2));
}

TEST_CASE("an observed value of a deleted instance is an error and comes back with the instance") {
    Served s;
    s.console("pin world.ball.mass");
    s.console("world.ball:delete()");
    CHECK_THROWS_WITH(s.pinned.at(0).value(), contains("ball"));
    s.console("world.ball = Body { mass = 6 }");
    CHECK(s.pinned.at(0).value() == Value(6.0));
}

TEST_CASE("wrong arguments of the console's functions are named") {
    Served s;
    CHECK_THAT(s.console("pin(3)"), contains("pin: needs a path or an expression as text"));
    CHECK_THAT(s.console("pin()"), contains("pin: needs a path"));
    CHECK_THAT(s.console("pin('world.ball.mass >')"), contains("the expression ends too early"));
    CHECK_THAT(s.console("bind(3, 'x')"), contains("bind: needs the name of a key"));
    CHECK_THAT(s.console("alias('a b', 'x')"), contains("alias: \"a b\" is not a word"));
    CHECK_THAT(s.console("alias('if', 'x')"), contains("alias: \"if\" is a word of Lua"));
    CHECK_THAT(s.console("bookmark('a', 1.5)"), contains("a step is a whole number, not 1.5"));
    CHECK_THAT(s.console("unpin world.other.mass"), contains("nothing like that is pinned"));
    CHECK(s.console("unpin it.mass").empty());
    CHECK(s.texts.back() == "unpin world.ball.mass");
    CHECK(s.pinned.empty());
}

TEST_CASE("an alias that hides a function says so") {
    Served s;
    CHECK_THAT(s.console("alias('undo', 'rewind(1)')"), contains("alias(\"undo\") ends that"));
    CHECK(s.console("alias('undo')").empty());
    CHECK(s.console("alias('heavy', 'world.ball.mass =')").empty());
}

}  // namespace observed_test
