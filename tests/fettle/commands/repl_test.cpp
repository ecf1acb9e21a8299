// `fettle repl`: the console of a game in the terminal, with commands from a file and typed ones.

#include <catch.h>
#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>

#include "patterns.h"
#include "program.h"

namespace repl_test {

using namespace program_test;

namespace {

Outcome repl(const Folder& folder, const std::string& commands,
             std::vector<std::string> arguments = {}) {
    arguments.insert(arguments.begin(), "repl");
    return fettle(folder, arguments, {}, folder.write("commands", commands));
}

/// The program in a terminal of its own.
class Terminal {
  public:
    Terminal(const Folder& folder, const std::string& game) {
        child_ = forkpty(&terminal_, nullptr, nullptr, nullptr);
        REQUIRE(child_ >= 0);
        if (child_ != 0) return;
        // Tests may run in the background, where a shell makes its commands ignore Ctrl+C.
        std::signal(SIGINT, SIG_DFL);
        setenv("XDG_STATE_HOME", (folder / "state").c_str(), 1);
        setenv("TERM", "xterm", 1);
        setenv("LC_ALL", "C.UTF-8", 1);
        // libedit does not free the names of functions that are added to it.
        setenv("ASAN_OPTIONS", "detect_leaks=0", 1);
        execl(FETTLE_PROGRAM, "fettle", "repl", game.c_str(), nullptr);
        _exit(127);
    }
    ~Terminal() {
        if (child_ > 0) end();
    }
    Terminal(const Terminal&) = delete;

    void type(const std::string& keys) {
        REQUIRE(write(terminal_, keys.data(), keys.size()) == ssize_t(keys.size()));
    }
    /// Reads until `text` appears; false after a minute without it. `before`, if given, receives
    /// what is shown before it.
    bool shows(const std::string& text, std::string* before = nullptr) {
        for (const auto end = Clock::now() + patience; Clock::now() < end;) {
            if (const std::size_t at = screen_.find(text); at != std::string::npos) {
                if (before != nullptr) *before = screen_.substr(0, at);
                screen_.erase(0, at + text.size());
                return true;
            }
            if (!wait()) break;
        }
        UNSCOPED_INFO("the screen: " << screen_);
        return false;
    }
    /// Closes the terminal; returns the exit status.
    int end() {
        close(terminal_);
        int status = 0;
        waitpid(std::exchange(child_, -1), &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    /// Types the keys and reads until the program has ended; returns the exit status.
    int ended_by(const std::string& keys) {
        type(keys);
        for (const auto end = Clock::now() + patience; Clock::now() < end && wait();) {
        }
        return end();
    }

  private:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::minutes patience{1};

    /// Reads what there is after a tenth of a second at most; false at the end of the program.
    bool wait() {
        pollfd ready = {.fd = terminal_, .events = POLLIN, .revents = 0};
        std::array<char, 4096> bytes;
        if (poll(&ready, 1, 100) <= 0) return true;
        const ssize_t count = read(terminal_, bytes.data(), bytes.size());
        if (count <= 0) return false;
        screen_.append(bytes.data(), std::size_t(count));
        screen_ = patterns::without(screen_, "\x1b\\[[0-9;]*m");
        return true;
    }

    pid_t child_ = -1;
    int terminal_ = -1;
    std::string screen_;
};

}  // namespace

TEST_CASE("wait makes the steps of a game without a window") {
    const Folder folder;
    folder.write("drop/main.lua",
                 "world.ball = Body { position = vec(0, 50), Circle { radius = 1 } }");
    const Outcome outcome =
        repl(folder,
             "wait world.ball.position.y < 49\ntime.step\nwait 0.5\ntime.step\n"
             "wait('world.ball.position.y > 60', 0.25)\n"
             "break_when world.ball.position.y < 30\nwait()\nworld.ball.position.y\n",
             {(folder / "drop").string()});
    INFO(outcome.out << outcome.err);
    CHECK(outcome.status == 0);
    CHECK(contains(outcome.out, "  world.ball.position.y < 49 is true at step 27\n  27\n"));
    CHECK(contains(outcome.out, "\n  57\n"));
    CHECK(
        contains(outcome.out, "✗ wait: after 0.25 s world.ball.position.y > 60 is still false\n"));
    CHECK(contains(outcome.out, "  the game is paused at step "));
    CHECK(contains(outcome.out, "\n  29."));
}

TEST_CASE("an alias stands for a command also in the terminal") {
    Folder folder;
    const Outcome done = repl(folder,
                              "world.ball = Body { Circle {} }\n"
                              "alias('heavy', 'world.ball.mass =')\n"
                              "heavy 12\n"
                              "world.ball.mass\n");
    INFO(done.out << done.err);
    CHECK(contains(done.out, "12 kg"));
    CHECK_FALSE(contains(done.out, "✗"));
}

TEST_CASE("commands from a file are run one after another") {
    const Folder folder;
    const Outcome outcome = repl(folder,
                                 "x = 3\nx + 4\nfor i = 1, 2 do\nprint(i)\nend\ntime.step\n"
                                 "advance(1)\ntime.step\nworld.gravity = vec(0, -2)\n"
                                 "world.gravty\nquit(4)\nprint('too late')\n");
    INFO(outcome.out << outcome.err);
    CHECK(outcome.status == 4);
    CHECK(outcome.out.starts_with("  7\n  1\n  2\n  0\n  60\n  60\n"));
    CHECK(contains(outcome.out, "  world.gravity: vec(0, -10) → vec(0, -2) m/s²\n"));
    CHECK(contains(outcome.out, "did you mean \"gravity\"?"));
    CHECK(!contains(outcome.out, "too late"));
}

TEST_CASE("an error at which the game halts again is printed again") {
    const Folder folder;
    const std::string game =
        folder.write("game/main.lua", "function step() error('each step') end\n");
    const Outcome outcome = repl(folder, "advance(0.1)\ngo_on()\nadvance(0.1)\n", {game});
    INFO(outcome.out << outcome.err);
    const std::string line = "error in step: main.lua:1: each step";
    const std::size_t first = outcome.err.find(line);
    REQUIRE(first != std::string::npos);
    CHECK(outcome.err.find(line, first + 1) != std::string::npos);
}

TEST_CASE("a game stands still between commands from a file") {
    const Folder folder;
    const std::string game =
        folder.write("game/main.lua",
                     "world.ball = Body { position = vec(0, 50), Circle { radius = 1 } }\n"
                     "function step(dt) if time.step == 30 then print('half a second') end end\n");
    const Outcome outcome =
        repl(folder,
             "world.ball.position.y\nworld.ball.position.y\nadvance(0.5)\n"
             "world.ball.position.y < 50\nworld.ball.mass is time.now\nworld.ball.mass\n",
             {game});
    INFO(outcome.out << outcome.err);
    CHECK(outcome.status == 0);
    CHECK(outcome.out.starts_with("  50 m\n  50 m\n  30\n"));
    CHECK(contains(outcome.out, "half a second\n"));
    CHECK(contains(outcome.out, "  true\n"));
    CHECK(outcome.out.ends_with("  0.5 kg\n"));
}

TEST_CASE("the repl reports errors of commands and games that it cannot open") {
    const Folder folder;
    CHECK(contains(repl(folder, "advance(-1)\n").out, "expected a time from 0 to 3600 s"));
    CHECK(contains(repl(folder, "advance('x')\n").out, "expected a time from 0 to 3600 s"));
    CHECK(contains(repl(folder, "for i = 1, 2 do\n").out, "the command ends too early"));
    CHECK(contains(repl(folder, "while true do end\n1 + 1\n").out, "  2\n"));
    CHECK(repl(folder, "", {(folder / "none").string()}).status == 3);
    const std::string broken = folder.write("broken/main.lua", "error('no start')\n");
    const Outcome failed = repl(folder, "1 + 1\n", {broken});
    CHECK(failed.status == 1);
    CHECK(contains(failed.err, "no start"));
    CHECK(contains(failed.out, "  2\n"));
    folder.write("closed/main.lua", "");
    folder.write("closed/game.json", R"({"console": "off"})");
    const Outcome closed = repl(folder, "1\n", {(folder / "closed").string()});
    CHECK(closed.status == 3);
    CHECK(contains(closed.err, "this game has no console"));
}

TEST_CASE("in a terminal words are completed and the game goes on") {
    const Folder folder;
    const std::string game =
        folder.write("game/main.lua",
                     "every(0.1, function() if time.step > 120 then print('späte Zeile') end end)");
    {
        Terminal terminal(folder, game);
        REQUIRE(terminal.shows("Tab completes"));
        // Of several candidates, only one begins like that.
        terminal.type("world.step_st = 'so it' world.stepp_x = 1\n");
        terminal.type("print(world.step_\t, 'is')\n");
        CHECK(terminal.shows("so it\tis"));
        terminal.type("world.gravit\t\n");
        CHECK(terminal.shows("vec(0, -10) m/s²"));
        CHECK(terminal.shows("späte Zeile"));
        terminal.type("print('ü' .. 1 +");
        terminal.type("\n 1)\n");
        CHECK(terminal.shows("ü2"));
        CHECK(terminal.shows("› "));
        CHECK(terminal.ended_by("\x04") == 0);
    }
    // The commands of the last run are there again.
    {
        Terminal terminal(folder, game);
        REQUIRE(terminal.shows("Tab completes"));
        terminal.type("\x1b[A\x1b[A\x1b[A\n");
        CHECK(terminal.shows("vec(0, -10) m/s²"));
        CHECK(terminal.ended_by("quit(5)\n") == 5);
    }
    // Keys that are typed while a command runs are not lost.
    for (const std::string keys : {"\x04", "quit(5)\n"}) {
        Terminal terminal(folder, game);
        REQUIRE(terminal.shows("Tab completes"));
        terminal.type("print('it ' .. 'runs') for i = 1, 5e6 do end\n");
        REQUIRE(terminal.shows("it runs"));
        CHECK(terminal.ended_by(keys) == (keys == "\x04" ? 0 : 5));
    }
}

TEST_CASE("in a terminal ctrl-c drops a line at every moment of a slow frame") {
    const Folder folder;
    const std::string game =
        folder.write("game/main.lua", "function step() for i = 1, 2e6 do end end\n");
    Terminal terminal(folder, game);
    REQUIRE(terminal.shows("Ctrl+C stops"));
    REQUIRE(terminal.shows("› "));
    // Ctrl+C empties the queue of the terminal: the letter before it may be gone when it is read.
    for (int milliseconds = 0; milliseconds < 20; ++milliseconds) {
        terminal.type("x");
        poll(nullptr, 0, milliseconds);
        terminal.type("\x03");
        INFO("ctrl-c " << milliseconds << " ms after a letter");
        REQUIRE(terminal.shows("^C"));
        REQUIRE(terminal.shows("› "));
    }
    CHECK(terminal.ended_by("\x04") == 0);
}

TEST_CASE("in a terminal ctrl-c stops even a command that catches errors") {
    const Folder folder;
    const std::string game = folder.write("game/main.lua", "");
    bool interrupted = false;
    // Ctrl+C may come before the command begins, which then stops without a place, or after its
    // budget has ended. That answer may be lost, since Ctrl+C also empties what the terminal has
    // not shown yet.
    for (int i = 0; i < 20 && !interrupted; ++i) {
        Terminal terminal(folder, game);
        REQUIRE(terminal.shows("› "));
        terminal.type("while true do pcall(function() while true do end end) end\n");
        REQUIRE(terminal.shows("end) end\r\n"));
        poll(nullptr, 0, i);
        terminal.type("\x03");
        std::string answer;
        REQUIRE(terminal.shows("› ", &answer));
        interrupted = contains(answer, "✗ console:1: stopped: it was interrupted");
        if (interrupted) {
            terminal.type("40 + 3\n");
            CHECK(terminal.shows("  43"));
        }
        CHECK(terminal.ended_by("\x04") == 0);
    }
    CHECK(interrupted);
}

TEST_CASE("in a terminal ctrl-c stops a line or steps and the game goes on") {
    const Folder folder;
    const std::string game =
        folder.write("game/main.lua",
                     "slow = false\nfunction step() if slow then for i = 1, 1e4 do end end end\n");
    Terminal terminal(folder, game);
    REQUIRE(terminal.shows("Ctrl+C stops"));
    REQUIRE(terminal.shows("› "));
    // A line that is typed.
    terminal.type("print('dropped' .. '");
    REQUIRE(terminal.shows("dropped"));
    terminal.type("\x03");
    REQUIRE(terminal.shows("^C"));
    terminal.type("print('the next ' .. 'line')\n");
    CHECK(terminal.shows("the next line"));
    // The lines of a command that is not complete.
    terminal.type("for i = 1, 2 do\n");
    REQUIRE(terminal.shows("… "));
    terminal.type("\x03");
    REQUIRE(terminal.shows("^C"));
    terminal.type("40 + 2\n");
    CHECK(terminal.shows("  42"));
    // The steps of advance.
    terminal.type("slow = true\nadvance(3600)\n");
    REQUIRE(terminal.shows("216000"));
    terminal.type("\x03");
    CHECK(terminal.shows("were not made"));
    terminal.type("slow = false print('before ' .. tostring(time.now < 3600))\n");
    CHECK(terminal.shows("before true"));
    CHECK(terminal.ended_by("\x04") == 0);
}

}  // namespace repl_test
