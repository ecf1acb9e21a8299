// A typed key changes a property and the picture: the complete program in a window.

#include <fstream>
#include <iostream>

#include "catch.h"
#include "game_window.h"

namespace console_test {

using fettle::test::GameWindow;
using fettle::test::missing_tools;
using fettle::test::Picture;
namespace fs = std::filesystem;

namespace {

const fs::path source(FETTLE_SOURCE_DIR), pictures(FETTLE_PICTURES);

/// True, with a message, if windows cannot be tested here.
bool skipped() {
    std::string missing = missing_tools();
    if (!missing.empty()) std::cout << "SKIPPED: " << missing << " not found\n";
    return !missing.empty();
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Opens the console and waits until it is visible.
void open_console(GameWindow& game) {
    Picture before = game.picture();
    game.key("grave");
    REQUIRE(game.eventually(
        [&] { return game.picture().difference(before, 0, 0, 800, 300) > 50'000; }));
}

}  // namespace

TEST_CASE("a command typed in a window changes the game and its picture") {
    if (skipped()) return;
    GameWindow game(source / "tests" / "window" / "game");
    REQUIRE(game.prints("ready"));
    game.key("k");
    REQUIRE(game.prints("game got\tk"));
    Picture closed = game.settled();

    open_console(game);
    game.type("world.gravity = vec(0, 2)");
    game.key("Return");
    INFO(game.printed());
    CHECK(game.prints("gravity is\tvec(0, 2)"));
    // The game got none of the typed keys, not even the grave key.
    CHECK_FALSE(contains(game.printed(), "game got\tw"));
    CHECK_FALSE(contains(game.printed(), "game got\tgrave"));

    game.key("grave");
    CHECK(game.eventually(
        [&] { return game.picture().difference(closed, 0, 0, 800, 300) < 50'000; }));
    // The crate has fallen upwards and away from its place.
    CHECK(game.eventually(
        [&] { return game.picture().difference(closed, 360, 640, 440, 720) > 3'000; }));
    game.key("j");
    CHECK(game.prints("game got\tj"));
    CHECK(game.running());
}

TEST_CASE("the key left of 1 opens the console whatever it types") {
    if (skipped()) return;
    if (!fettle::test::available("setxkbmap")) return;
    // It types ² in France, and is a dead ^ in Germany.
    const std::string layout = GENERATE("fr", "de");
    INFO(layout);
    GameWindow game(source / "tests" / "window" / "game", {}, "", layout);
    REQUIRE(game.prints("ready"));
    const Picture closed = game.settled();
    const auto is_open = [&] { return game.picture().difference(closed, 0, 0, 800, 300) > 50'000; };
    const std::string code = "49";  // of the key in X11
    game.hold(code, true);
    CHECK(game.eventually(is_open));
    game.hold(code, false);
    game.type("world.gravity = vec(0, 2)");
    game.key("Return");
    CHECK(game.prints("gravity is\tvec(0, 2)"));
    game.hold(code, true);
    CHECK(game.eventually([&] { return !is_open(); }));
    game.hold(code, false);
    CHECK_FALSE(contains(game.printed(), "game got"));
}

TEST_CASE("Tab completes a path in a window") {
    if (skipped()) return;
    GameWindow game(source / "tests" / "window" / "game");
    REQUIRE(game.prints("ready"));
    open_console(game);
    game.type("world.cra");
    game.key("Tab");
    game.type(".");
    Picture before = game.settled();
    game.key("Tab");
    // The list of candidates covers the game below the console.
    CHECK(game.eventually(
        [&] { return game.picture().difference(before, 20, 370, 600, 560) > 20'000; }));
    game.settled().save_png(pictures / "console.png");
    game.type("gravity_s");
    game.key("Tab");
    game.type(" = 3");
    game.key("Return");
    INFO(game.printed());
    CHECK(game.prints("gravity_scale is\t3"));

    game.type("world.crate.masss = 2");
    game.key("Return");
    game.key("Up");
    for (int i = 0; i < 5; ++i) game.key("BackSpace");
    game.type(" = 2");
    game.key("Return");
    CHECK_FALSE(contains(game.printed(), "game got"));
    CHECK(game.running());
}

TEST_CASE("a click on a body in a window selects it for the console and the inspector") {
    if (skipped()) return;
    GameWindow game(source / "tests" / "window" / "game");
    REQUIRE(game.prints("ready"));
    open_console(game);
    // The crate is at (-6, -7): 40 pixels per meter, (0, 0) in the middle of 1280 × 800.
    game.click(400, 680);
    game.type("it.mass = 7");
    game.key("Return");
    INFO(game.printed());
    CHECK(game.prints("mass is\t7"));
    CHECK_FALSE(contains(game.printed(), "game got"));
    game.settled().save_png(pictures / "inspector.png");
}

TEST_CASE("Escape clears typed text in a window and the game still gets no keys") {
    if (skipped()) return;
    GameWindow game(source / "tests" / "window" / "game");
    REQUIRE(game.prints("ready"));
    open_console(game);
    game.type("world.cr");
    game.key("Escape");
    game.type("world.gravity = vec(0, 3)");
    game.key("Return");
    INFO(game.printed());
    CHECK(game.prints("gravity is\tvec(0, 3)"));
    CHECK_FALSE(contains(game.printed(), "game got"));
    game.key("Escape");
    game.key("j");
    CHECK(game.prints("game got\tj"));
}

TEST_CASE("a plot is drawn and a key runs its command in a window") {
    if (skipped()) return;
    GameWindow game(source / "tests" / "window" / "game");
    REQUIRE(game.prints("ready"));
    open_console(game);
    game.type("plot world.crate.position");
    const Picture before = game.settled();
    game.key("Return");
    // The plot lies above the time bar, below the console.
    CHECK(game.eventually(
        [&] { return game.picture().difference(before, 20, 500, 880, 740) > 20'000; }));
    game.type("bind('f6', 'print(\"pressed\")')");
    game.key("Return");
    game.key("F6");
    game.key("Escape");
    game.key("F6");
    game.settled().save_png(pictures / "plot.png");
    CHECK_FALSE(contains(game.printed(), "game got\tf6"));
    CHECK(game.running());
}

TEST_CASE("the showcase runs in a window") {
    if (skipped()) return;
    fs::path showcase = source / "scripts" / "showcase";
    if (!fs::exists(showcase / "main.lua")) {
        std::cout << "SKIPPED: there is no showcase\n";
        return;
    }
    GameWindow game(showcase);
    Picture first = game.picture();
    CHECK(game.eventually([&] { return game.picture().difference(first) > 10'000; }));
    game.settled().save_png(pictures / "showcase.png");
    open_console(game);
    game.type("world.gravity");
    game.key("Return");
    game.click(640, 635);  // a block of the pyramid
    game.settled().save_png(pictures / "showcase-console.png");
    INFO(game.printed());
    CHECK_FALSE(contains(game.printed(), ".lua:"));  // no script error
    CHECK(game.running());
}

TEST_CASE("a game in a window ends in order after a signal") {
    if (skipped()) return;
    GameWindow game(source / "tests" / "window" / "game");
    REQUIRE(game.prints("ready"));
    // The second run: a signal while an endless script runs.
    const bool runaway = GENERATE(false, true);
    if (runaway) {
        game.key("l");
        REQUIRE(game.prints("for ever"));
    }
    CHECK(game.asked_to_end() == 143);
    INFO(game.printed());
    CHECK(contains(game.printed(), "closing"));
    CHECK(contains(game.printed(), "stopped: it was interrupted") == runaway);
}

TEST_CASE("a run in a window is recorded from its first step when a recording is requested later") {
    if (skipped()) return;
    const TemporaryFolder player;
    fs::create_directories(player.path / "fettle");
    std::ofstream(player.path / "fettle" / "autoexec.lua") << "world.ball.mass = 3\n";
    GameWindow game(source / "tests" / "window" / "game",
                    {{"XDG_CONFIG_HOME", player.path.string()}});
    REQUIRE(game.prints("ready"));
    game.key("k");
    REQUIRE(game.prints("game got\tk"));
    open_console(game);
    game.type("pin 'world.crate.mass'");
    game.key("Return");
    game.type("world.gravity = vec(0, 3)");
    game.key("Return");
    REQUIRE(game.prints("gravity is\tvec(0, 3)"));
    game.type("record()");
    game.key("Return");
    const auto recording = [&] {
        const fs::path data = game.folder() / "data";
        if (!fs::exists(data)) return fs::path();
        for (const auto& entry : fs::recursive_directory_iterator(data))
            if (entry.path().extension() == ".recording") return entry.path();
        return fs::path();
    };
    REQUIRE(game.eventually([&] { return !recording().empty(); }));
    game.type("world.crate.mass = 7");
    game.key("Return");
    REQUIRE(game.prints("mass is\t7"));
    game.settled().save_png(pictures / "recording.png");
    const fs::path printed = game.folder() / "replayed";
    const auto replay = [&] {
        return fettle::test::run({FETTLE_PROGRAM, "run", "--headless", "--replay", recording()}, {},
                                 printed);
    };
    INFO(fettle::test::read_file(printed));
    CHECK(replay() == 0);
    // What was removed while it was written is there at the end.
    fs::remove(recording());
    game.type("record(false)");
    game.key("Return");
    REQUIRE(game.eventually([&] { return !recording().empty(); }));
    CHECK(replay() == 0);
    // A changed file ends what can be recorded.
    std::ofstream(game.folder() / "game" / "main.lua", std::ios::app) << "print('changed')\n";
    REQUIRE(game.prints("changed"));
    game.type("world.crate.mass = 8 record()");
    game.key("Return");
    REQUIRE(game.prints("mass is\t8"));
    const fs::path first = recording();
    CHECK(first.filename() == "run-1.recording");
    CHECK_FALSE(fs::exists(first.parent_path() / "run-2.recording"));
    CHECK(replay() == 3);  // of another version of the game
    CHECK(contains(fettle::test::read_file(printed), "main.lua differs"));
    game.type("restart()");
    game.key("Return");
    REQUIRE(game.eventually([&] {
        const std::string all = game.printed();
        return all.find("ready") != all.rfind("ready");
    }));
    game.type("record()");  // the console is still open
    game.key("Return");
    REQUIRE(game.eventually([&] { return fs::exists(first.parent_path() / "run-2.recording"); }));
    CHECK(game.asked_to_end() == 143);
    fs::remove(first);
    CHECK(replay() == 0);
}

TEST_CASE("a terminal stays attached when the game begins again and hears of both", "[long]") {
    if (skipped()) return;
    const TemporaryFolder sockets;
    const std::map<std::string, std::string> environment = {
        {"XDG_RUNTIME_DIR", sockets.path.string()}};
    GameWindow game(source / "tests" / "window" / "game", environment);
    REQUIRE(game.prints("ready"));
    open_console(game);
    game.type("console.listen = true");
    game.key("Return");
    REQUIRE(game.prints("attaches a terminal"));
    // The answer of last_time is found after the command.
    const std::string typed = std::string("(echo last_time world.nothing; sleep 1; ") +
                              "echo 'restart()'; sleep 4; echo world.crate.mass = 6) | '" +
                              FETTLE_PROGRAM + "' repl --attach";
    const fs::path said = game.folder() / "said";
    INFO(game.printed());
    CHECK(fettle::test::run({"sh", "-c", typed}, environment, said) == 0);
    const std::string all = fettle::test::read_file(said);
    INFO(all);
    CHECK(contains(all, "✗ last_time world.nothing: world.nothing: no such name"));
    CHECK(contains(all, "the game begins again"));
    CHECK(contains(all, "world.crate.mass: "));
    CHECK(game.prints("mass is\t6"));
    // It listens still, for others.
    CHECK(fettle::test::run(
              {"sh", "-c", std::string("echo 6 \\* 7 | '") + FETTLE_PROGRAM + "' repl --attach"},
              environment, said) == 0);
    CHECK(contains(fettle::test::read_file(said), "42"));
}

TEST_CASE("a game saved in a window has a picture") {
    if (skipped()) return;
    GameWindow game(source / "tests" / "window" / "game");
    REQUIRE(game.prints("ready"));
    open_console(game);
    game.type("save_game('a')");
    game.key("Return");
    game.type("after(0, function() local s = saves()[1] print('saved', s.picture, s.problem) end)");
    game.key("Return");
    INFO(game.printed());
    CHECK(game.prints("saved\tsave:a\tnil"));
}

TEST_CASE("an endless script is shown in a window and can be stopped there", "[long]") {
    if (skipped()) return;
    GameWindow game(source / "tests" / "window" / "game");
    REQUIRE(game.prints("ready"));
    const Picture playing = game.settled();
    game.key("l");
    REQUIRE(game.prints("for ever"));
    // The message covers the whole picture; its last line names the keys.
    const auto shown = [&](unsigned top, unsigned bottom) {
        return [&game, playing, top, bottom] {
            return game.picture().difference(playing, 0, top, 1280, bottom) > 20'000;
        };
    };
    REQUIRE(game.eventually(shown(0, 700)));
    CHECK(game.eventually(shown(760, 800)));
    game.picture().save_png(pictures / "long_call.png");
    game.key("s");
    INFO(game.printed());
    CHECK(game.prints("stopped: it ran for"));
    CHECK(game.running());
}

}  // namespace console_test
