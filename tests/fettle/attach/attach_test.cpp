// `fettle repl --attach`: a terminal at a game that runs.

#include <catch.h>

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <optional>

#include "program.h"
#include "running_program.h"

namespace attach_test {

using namespace program_test;

namespace {

const std::string game = R"(
world.ball = Body { position = vec(0, 50), Circle { radius = 1 } }
every(0.5, function() print("tick") end)
)";

Outcome attached(const Folder& folder, const std::string& commands,
                 std::vector<std::string> arguments = {}) {
    arguments.insert(arguments.begin(), {"repl", "--attach"});
    // RunningProgram has the files "out" and "err".
    const std::string input = folder.write("other/commands", commands);
    std::string line =
        "XDG_RUNTIME_DIR=" + quoted((folder / "run").string()) + " " + quoted(FETTLE_PROGRAM);
    for (const std::string& each : arguments) line += " " + quoted(each);
    const int result =
        std::system((line + " <" + quoted(input) + " >" + quoted((folder / "other/out").string()) +
                     " 2>" + quoted((folder / "other/err").string()))
                        .c_str());
    return {WIFEXITED(result) ? WEXITSTATUS(result) : -1, folder.text("other/out"),
            folder.text("other/err")};
}

struct Listening {
    Listening(std::vector<std::string> arguments, const std::string& settings = "{}") {
        std::filesystem::create_directories(folder / "run");
        ::setenv("XDG_RUNTIME_DIR", (folder / "run").c_str(), 1);
        folder.write("drop/main.lua", game);
        folder.write("drop/game.json", settings);
        arguments.insert(arguments.begin(), {"run", (folder / "drop").string(), "--headless",
                                             "--steps", "1000000000"});
        program.emplace(folder, arguments);
    }
    /// Waits until a terminal can attach.
    bool ready() {
        for (int i = 0; i < 600; ++i) {
            if (std::filesystem::exists(folder / "run/fettle"))
                for (const auto& each : std::filesystem::directory_iterator(folder / "run/fettle"))
                    if (each.path().extension() == ".game") return true;
            ::usleep(100000);
        }
        return false;
    }

    Folder folder;
    std::optional<RunningProgram> program;
};

}  // namespace

TEST_CASE("a command typed in a terminal runs in a running game") {
    Listening running({"--listen"});
    REQUIRE(running.ready());
    const Outcome outcome = attached(
        running.folder,
        "x = 3\nx + 4\nfor i = 1, 2 do\nprint(i)\nend\nworld.gravity = vec(0, -2)\nworld.gravty\n"
        "world.ball.mass\nwhile true do\n");
    INFO(outcome.out << outcome.err);
    CHECK(outcome.status == 0);
    CHECK(contains(outcome.out, "  7\n"));
    CHECK(contains(outcome.out, "  1\n  2\n"));
    CHECK(contains(outcome.out, "  world.gravity: vec(0, -10) → vec(0, -2) m/s²\n"));
    CHECK(contains(outcome.out, "did you mean \"gravity\"?"));
    CHECK(contains(outcome.out, "  3.1415927 kg\n"));
    CHECK(outcome.out.ends_with("✗ the command ends too early\n"));
    // A variable that one terminal has set exists for the next one, which finds the game by its
    // name and its path.
    CHECK(contains(attached(running.folder, "x\n", {"drop"}).out, "  3\n"));
    CHECK(contains(attached(running.folder, "x\n", {(running.folder / "drop").string()}).out,
                   "  3\n"));
    // Longer commands would delay a frame; the refusal names the function that runs them.
    const Outcome large = attached(running.folder, std::string(4096, '(') + "\nx\n");
    CHECK(contains(large.out, "at most 4096 bytes; exec(\"FILE\") runs more"));
    CHECK(large.out.ends_with("  3\n"));
    const Outcome wrong = attached(running.folder, "x\n", {"drip"});
    CHECK(wrong.status == 3);
    CHECK(contains(wrong.err, "\"drip\" does not listen; there are drop ("));
    CHECK(attached(running.folder, "quit(4)\n").status == 0);
    CHECK(running.program->end().status == 4);
    const Outcome none = attached(running.folder, "x\n");
    CHECK(none.status == 3);
    CHECK(contains(none.err, "no game listens"));
}

TEST_CASE("a piped command ends with what it finds after its answer") {
    Listening running({"--listen"});
    REQUIRE(running.ready());
    attached(running.folder, "world.gravity = vec(0, -2)\n");
    const Outcome outcome =
        attached(running.folder, "ab('world.ball.mass', 9, 0.5)\nlast_time world.nothing\n");
    INFO(outcome.out << outcome.err);
    CHECK(contains(outcome.out, "  ab world.ball.mass = 9 since step "));
    CHECK(contains(outcome.out, "✗ last_time world.nothing: world.nothing: no such name"));
}

TEST_CASE("piped commands wait for a condition and for a break and for a time") {
    Listening running({"--listen"});
    REQUIRE(running.ready());
    const Outcome outcome =
        attached(running.folder,
                 "world.gravity = vec(0, 0)\nworld.ball.velocity = vec(0, -0.1)\n"
                 "world.ball.position = vec(0, 50)\nwait 0.1\nwait world.ball.position.y < "
                 "49\nwait world.nothing\n"
                 "break_when time.step % 1000 == 0\nwait()\ntime.step % 1000\n");
    INFO(outcome.out << outcome.err);
    CHECK(outcome.status == 0);
    CHECK(contains(outcome.out, "  world.ball.position.y < 49 is true at step "));
    CHECK(contains(outcome.out, "✗ wait world.nothing: world.nothing: no such name"));
    CHECK(contains(outcome.out, "  the game is paused at step "));
    CHECK(outcome.out.ends_with("  0\n"));
}

TEST_CASE("a property of the console opens and closes the connection for terminals") {
    Listening running({"--eval", "console.listen = true"});
    REQUIRE(running.ready());
    const Outcome last = attached(running.folder, "console.listen = false\n1 + 1\n");
    INFO(last.out << last.err);
    CHECK(last.status == 3);
    CHECK(contains(last.err, "listens no longer"));
    CHECK(std::filesystem::is_empty(running.folder / "run/fettle"));
    running.program->send(SIGTERM);
    running.program->end();
}

TEST_CASE("a game without a console and a game in a sandbox accept no terminals") {
    const Folder folder;
    folder.write("drop/main.lua", "console.listen = true");
    const std::string drop = (folder / "drop").string();
    std::filesystem::create_directories(folder / "run");
    const std::string before = "export XDG_RUNTIME_DIR=" + quoted((folder / "run").string()) + "; ";
    const auto run = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"run", drop, "--headless", "--steps", "30"});
        return fettle(folder, more, before);
    };
    const Outcome boxed = run({"--sandbox"});
    CHECK(boxed.status == 0);
    CHECK(contains(boxed.err, "console.listen: nothing may attach to a game in a sandbox"));
    CHECK(run({"--sandbox", "--listen"}).status == 3);
    CHECK(!std::filesystem::exists(folder / "run/fettle"));
    CHECK(contains(run({}).err, "fettle repl --attach"));
    folder.write("drop/main.lua", "");
    folder.write("drop/game.json", R"({"console": "off"})");
    const Outcome off = run({"--listen"});
    CHECK(off.status == 3);
    CHECK(contains(off.err, "--listen: this game has no console"));
    // The console is there for developers, who may attach.
    folder.write("drop/game.json", R"({"console": "developer"})");
    CHECK(contains(run({"--listen"}).err, "fettle repl --attach"));
}

TEST_CASE("a recording contains the commands of a terminal") {
    Listening running({"--listen", "--seed", "5"});
    running.program.reset();
    std::filesystem::remove_all(running.folder / "run/fettle");
    running.program.emplace(
        running.folder, std::vector<std::string>{"run", (running.folder / "drop").string(),
                                                 "--headless", "--steps", "1000000000", "--listen",
                                                 "--record", (running.folder / "record").string()});
    REQUIRE(running.ready());
    CHECK(attached(running.folder, "world.ball.position = vec(7, 7)\nquit(0)\n").status == 0);
    CHECK(running.program->end().status == 0);
    const Outcome again = fettle(
        running.folder, {"run", "--replay", (running.folder / "record").string(), "--headless"});
    INFO(again.out << again.err);
    CHECK(again.status == 0);
}

}  // namespace attach_test
