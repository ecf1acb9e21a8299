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

TEST_CASE("a terminal waits for a condition or a time or a pause") {
    ObservingRig rig;
    double seconds = 0;
    rig.lua.state().waits.clock = [&] { return seconds; };
    const std::string who = "terminal 3";
    const auto ended = [&]() -> std::string {
        const auto lines = rig.lua.waited(who);
        if (!lines) return "waits";
        std::string all;
        for (const std::string& line : *lines) all += line + "|";
        return all;
    };
    CHECK(ended() == "");  // it has been told nothing
    CHECK(asked(rig, "wait world.ball.position.x > 4") == "");
    CHECK(rig.lua.answers_later(who));
    CHECK_FALSE(rig.lua.answers_later("terminal 1"));
    rig.step(4);
    CHECK(ended() == "waits");
    rig.step(3);  // also if it is true for one step only
    CHECK(ended() == "world.ball.position.x > 4 is true at step 5|");
    CHECK_FALSE(rig.lua.answers_later(who));
    CHECK(ended() == "");
    // A condition that is true already, and one that is no boolean.
    asked(rig, "wait world.ball.position.x > 4");
    rig.lua.between_frames();
    CHECK(ended() == "world.ball.position.x > 4 is true at step 7|");
    asked(rig, "wait world.ball.mass");
    rig.step(2);
    CHECK(ended() == "waits");
    rig.run("world.ball.mass = 9");
    CHECK(ended() == "world.ball.mass has changed at step 9|");
    // A time.
    asked(rig, "wait 2.5");
    rig.lua.between_frames();
    seconds = 2.4;
    rig.lua.between_frames();
    CHECK(ended() == "waits");
    seconds = 2.5;
    rig.lua.between_frames();
    CHECK(ended() == "");
    asked(rig, "wait('world.ball.mass > 99', 3)");
    seconds = 6;
    rig.step();
    CHECK(ended() == "✗ wait: after 3 s world.ball.mass > 99 is still false|");
    // A pause, and a condition that cannot become true while the game stands.
    asked(rig, "break_when world.ball.position.x > 11");
    asked(rig, "wait()");
    rig.step();
    CHECK(ended() == "waits");
    rig.step(5);
    CHECK(ended() == "the game is paused at step 12|");
    asked(rig, "wait world.ball.position.x > 20");
    rig.lua.between_frames();
    CHECK(ended() ==
          "✗ wait: the game is paused at step 12: world.ball.position.x > 20 is still false|");
    asked(rig, "wait 1");
    rig.lua.stop_waiting(who);
    CHECK(ended() == "");
}

TEST_CASE("a wait that cannot be is an error") {
    ObservingRig rig;
    CHECK(asked(rig, "wait(-1)").find("wait: expected a time from 0 to 3600 s") !=
          std::string::npos);
    CHECK(asked(rig, "wait('world.ball.mass > 1', {})").find("wait: expected a time") !=
          std::string::npos);
    CHECK_FALSE(rig.lua.answers_later("terminal 3"));
    asked(rig, "wait world.bal.mass > 1");
    const auto lines = rig.lua.waited("terminal 3");
    REQUIRE(lines);
    REQUIRE(lines->size() == 1);
    CHECK(lines->front().starts_with("✗ wait world.bal.mass > 1: world.bal: no such name"));
    // In the window, the next command is typed when the person wants.
    rig.run("wait(1)");
    CHECK(rig.text().find("works inside a coroutine") != std::string::npos);
    bool halted = true;
    rig.lua.state().waits.halted = [&] { return halted; };
    asked(rig, "wait()");
    rig.lua.between_frames();
    CHECK(rig.lua.waited("terminal 3") ==
          std::vector<std::string>{"the game stands after an error at step 0"});
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
    rig.lua.between_frames();
    CHECK_FALSE(halted);
    CHECK(rig.value("time.paused") == property::Value(false));
    CHECK(answer("go_on()") == "the game runs already");
    // It is no edit.
    CHECK(answer("undo") == "undo: time.paused = true");
}

}  // namespace terminal_test
