// Commands of terminals: their answers say what only the window shows, and its log contains them.

#include <string>

#include "catch.h"
#include "observing_rig.h"

namespace terminal_test {

using namespace fettle;
using console::test::ObservingRig;

namespace {

/// The answer that a terminal gets.
std::string asked(ObservingRig& rig, const std::string& command) {
    std::string all;
    const script::Evaluation said = rig.lua.answer_terminal(command, "terminal 3");
    for (const std::string& line : said.lines) all += line + "|";
    return all + (said.error ? said.error->message : "");
}

}  // namespace

TEST_CASE("a terminal is told what the window shows") {
    ObservingRig rig;
    rig.step(2);
    CHECK(asked(rig, "pin world.ball.mass").starts_with("world.ball.mass is pinned"));
    CHECK(asked(rig, "pin").find("world.ball.mass") != std::string::npos);
    CHECK(asked(rig, "plot world.ball.mass, world.ball.position")
              .starts_with("the window plots world.ball.mass, world.ball.position"));
    CHECK(asked(rig, "plot()") == "nothing is plotted any more|");
    CHECK(asked(rig, "unpin world.ball.mass") == "world.ball.mass is no longer pinned|");
    CHECK(asked(rig, "unpin()") == "nothing like that is pinned|");
    CHECK(asked(rig, "bookmark 'start'") == "bookmark \"start\" is at step 2|");
    CHECK(asked(rig, "bookmark()") == "bookmark \"bookmark 1\" is at step 2|");
    CHECK(asked(rig, "unbookmark 'start'") == "bookmark \"start\" is removed|");
    // Nobody sees these, in a window either.
    CHECK(asked(rig, "bind('f5', 'undo')") == "f5 runs undo|");
    CHECK(asked(rig, "bind('f5')") == "f5 has no command any more|");
    CHECK(asked(rig, "alias('u', 'undo')") == "u stands for undo|");
    CHECK(asked(rig, "alias('u')") == "u is no alias any more|");
    rig.run("bind('f6', 'undo')");
    CHECK(rig.text().find("f6 runs undo\n") != std::string::npos);
}

TEST_CASE("what the views of the window show is not said in its log") {
    ObservingRig rig;
    for (const char* command : {"pin world.ball.mass", "plot world.ball.mass", "bookmark('a')",
                                "unpin()", "plot()", "unbookmark()"})
        rig.run(command);
    CHECK(rig.text().find("pinned") == std::string::npos);
    CHECK(rig.text().find("plotted") == std::string::npos);
    CHECK(rig.text().find("removed") == std::string::npos);
}

TEST_CASE("the log has the commands of terminals with the beginnings of their answers") {
    ObservingRig rig;
    asked(rig, "it = world.ball");
    asked(rig, "world.ball.mass = 5");
    asked(rig, "for i = 1, 20 do\nprint('line', i) end");
    asked(rig, "for i = 1, 2 do");  // it goes on in the next line
    asked(rig, "world.nothing");
    const std::string text = rig.text();
    INFO(text);
    const auto place = [&](const char* part) {
        const std::size_t at = text.find(part);
        REQUIRE(at != std::string::npos);
        return at;
    };
    CHECK(place("terminal 3› it = world.ball\n") < place("\nit = world.ball\n"));
    CHECK(place("terminal 3› world.ball.mass = 5\n") < place("world.ball.mass: 1 → 5"));
    CHECK(place("terminal 3› for i = 1, 20 do …\n") < place("line  8"));
    CHECK(text.find("line  9") == std::string::npos);
    CHECK(place("… 12 more lines in the terminal") < place("terminal 3› world.nothing"));
    CHECK(place("no such name") > 0);
    CHECK(text.find("for i = 1, 2 do") == std::string::npos);
}

TEST_CASE("clear in a terminal empties the log at once and no later answer") {
    ObservingRig rig;
    rig.run("print('first')");
    asked(rig, "clear");
    CHECK(rig.text().find("first") == std::string::npos);
    CHECK(rig.text().find("terminal 3› clear") != std::string::npos);
    rig.run("print('second')");
    CHECK(rig.text().find("second") != std::string::npos);
}

TEST_CASE("a search and a file of commands are answered later") {
    ObservingRig rig;
    rig.step(3);
    CHECK_FALSE(rig.lua.answers_later());
    asked(rig, "last_time world.ball.position.x < 2");
    CHECK(rig.lua.answers_later());
    rig.lua.between_frames();
    CHECK_FALSE(rig.lua.answers_later());
    asked(rig, "ab('world.ball.mass', 9)");
    CHECK(rig.lua.answers_later());
    rig.lua.between_frames();
    CHECK_FALSE(rig.lua.answers_later());
}

TEST_CASE("a selection and the end of a comparison and a replay are answered in a terminal") {
    ObservingRig rig;
    rig.step(200);
    const auto answer = [&](const std::string& command) {
        std::string all;
        for (const std::string& line : rig.lua.answer_terminal(command, "terminal 1").lines)
            all += line + "|";
        return all;
    };
    CHECK(answer("it = world.ball") == "it = world.ball|");
    CHECK(answer("selection { world.ball, world.crate }") == "2 selected, it = world.crate|");
    CHECK(answer("it = nil") == "nothing is selected|");
    CHECK(answer("ab()") == "nothing is compared|");
    CHECK(answer("play_back(2)")
              .starts_with("the window plays steps 80 to 200; then the game goes on"));
    // The log of the window has each answer once.
    const std::string log = rig.text();
    const std::size_t first = log.find("it = world.ball\n");
    REQUIRE(first != std::string::npos);
    CHECK(log.find("2 selected") == log.rfind("2 selected"));
    // Commands that are typed in the window need no answer but the log's.
    CHECK(rig.lua.evaluate("it = world.ball").lines.empty());
    CHECK(rig.text().find("it = world.ball\n") != std::string::npos);
}

TEST_CASE("go_on lets a game go on that stands after an error or is paused") {
    ObservingRig rig;
    bool halted = true;
    rig.lua.state().views.time_bar.halted = [&] { return halted; };
    rig.lua.state().options.resume = [&] { halted = false; };
    rig.step(7);
    rig.run("time.paused = true");
    const auto answer = [&](const std::string& command) {
        const auto lines = rig.lua.answer_terminal(command, "terminal 1").lines;
        return lines.empty() ? std::string() : lines.front();
    };
    CHECK(answer("go_on()") == "the game goes on from step 7");
    CHECK_FALSE(halted);
    CHECK(rig.value("time.paused") == property::Value(false));
    CHECK(answer("go_on()") == "the game runs already");
}

}  // namespace terminal_test
