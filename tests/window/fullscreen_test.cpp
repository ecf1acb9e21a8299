// The window follows view.window, and its keys.

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>

#include "catch.h"
#include "game_window.h"
#include "temporary_folder.h"

namespace fullscreen_test {

using fettle::test::available;
using fettle::test::GameWindow;
using fettle::test::missing_tools;
namespace fs = std::filesystem;

TEST_CASE("F11 and Alt and Enter change between fullscreen and the window") {
    if (const std::string missing = missing_tools(); !missing.empty()) {
        std::cout << "SKIPPED: " << missing << " not found\n";
        return;
    }
    GameWindow game(fs::path(FETTLE_SOURCE_DIR) / "tests" / "window" / "resizing");
    REQUIRE(game.prints("ready\tvec(640, 400)"));
    game.key("F11");
    CHECK(game.prints("fullscreen\ttrue"));
    CHECK(game.prints("resized\t1280\t800"));
    game.key("alt+Return");
    CHECK(game.prints("fullscreen\tfalse"));
    CHECK(game.prints("resized\t640\t400"));
    INFO(game.printed());
    // The game did not get these keys.
    CHECK(game.printed().find("key\tf11") == std::string::npos);
    CHECK(game.printed().find("key\tenter") == std::string::npos);
    game.key("s");
    CHECK(game.prints("resized\t500\t300"));
    CHECK(game.prints("screen\tvec(500, 300)"));
}

TEST_CASE("Alt and Enter change to fullscreen and back under a window manager") {
    std::string missing = missing_tools();
    if (!available("blackbox")) missing += missing.empty() ? "blackbox" : " and blackbox";
    if (!missing.empty()) {
        std::cout << "SKIPPED: " << missing << " not found\n";
        return;
    }
    const TemporaryFolder folder;
    std::ofstream(folder.path / "main.lua")
        << "view.window:watch('fullscreen', function(on) print('fullscreen', on) end)\n"
           "print('ready')\n";
    GameWindow game(folder.path, {}, "blackbox");
    REQUIRE(game.prints("ready"));
    REQUIRE(game.eventually([&] { return !game.active_window().empty(); }));
    // The window that is opened gets the keyboard only after the keys have been let go.
    std::size_t seen = 0;
    const auto prints_next = [&](const std::string& text) {
        return game.eventually([&] {
            const std::size_t at = game.printed().find(text, seen);
            if (at != std::string::npos) seen = at + text.size();
            return at != std::string::npos;
        });
    };
    for (const char* change : {"true", "false", "true", "false"}) {
        CAPTURE(change);
        const std::string before = game.active_window();
        game.key("alt+Return");
        const bool changes = prints_next(std::string("fullscreen\t") + change);
        INFO(game.printed());
        REQUIRE(changes);
        REQUIRE(game.eventually([&] {
            const std::string now = game.active_window();
            return !now.empty() && now != before;
        }));
    }
}

TEST_CASE("a button of the mouse that is let go while the window is opened again is not held") {
    if (const std::string missing = missing_tools(); !missing.empty()) {
        std::cout << "SKIPPED: " << missing << " not found\n";
        return;
    }
    const TemporaryFolder folder;
    std::ofstream(folder.path / "main.lua")
        << "view.window.size = vec(400, 300)\n"
           "function mouse_pressed(button) print('pressed', button) end\n"
           "local releases = 0\n"
           "function mouse_released(button) releases = releases + 1 "
           "print('released', button, releases) end\n"
           "function key_pressed(key) if key == 'f' then view.window.resizable = not "
           "view.window.resizable print('again') else print('held', input.mouse.left) end end\n"
           "print('ready')\n";
    GameWindow game(folder.path);
    REQUIRE(game.prints("ready"));
    game.move(200, 150);
    game.hold_button(true);
    REQUIRE(game.prints("pressed\tleft"));
    game.key("f");
    REQUIRE(game.prints("again"));
    game.move(1200, 700);  // outside of the new window, which gets no event
    game.hold_button(false);
    CHECK(game.prints("released\tleft\t1"));
    // A press that reached the window is released once.
    game.move(200, 150);
    game.focus();
    game.hold_button(true);
    game.hold_button(false);
    // A release in the frame of its press waits until the end of that frame, in which a key would
    // still see the button as held.
    REQUIRE(game.prints("released\tleft\t2"));
    game.key("g");
    REQUIRE(game.prints("held\tfalse"));
    const std::string all = game.printed();
    CHECK(std::count(all.begin(), all.end(), '\n') == 7);
}

TEST_CASE("a size that a game sets when it begins stays") {
    if (const std::string missing = missing_tools(); !missing.empty()) {
        std::cout << "SKIPPED: " << missing << " not found\n";
        return;
    }
    const TemporaryFolder folder;
    std::ofstream(folder.path / "main.lua")
        << "view.window.size = vec(640, 400)\n"
           "function update() if time.frame == 30 then print('size', view.window.size, "
           "view.screen) end end\n";
    GameWindow game(folder.path);
    CHECK(game.prints("size\tvec(640, 400)\tvec(640, 400)"));
}

TEST_CASE("a window that becomes larger stays on the screen") {
    if (const std::string missing = missing_tools(); !missing.empty()) {
        std::cout << "SKIPPED: " << missing << " not found\n";
        return;
    }
    const TemporaryFolder folder;
    std::ofstream(folder.path / "game.json") << R"({"window": {"size": [400, 300]}})";
    std::ofstream(folder.path / "main.lua")
        << "view.background = color('#ff0000')\n"
           "function key_pressed() view.window.size = vec(1200, 700) end\n"
           "print('ready')\n";
    GameWindow game(folder.path);
    REQUIRE(game.prints("ready"));
    game.key("f");
    CHECK(game.eventually([&] {
        const auto rgb = game.picture().rgb;
        std::size_t red = 0;
        for (std::size_t i = 0; i + 2 < rgb.size(); i += 3)
            red += rgb[i] == 255 && rgb[i + 1] == 0 && rgb[i + 2] == 0;
        return red == 1200 * 700;
    }));
}

TEST_CASE("a window gets the icon that the game sets and an invalid icon is reported") {
    if (std::system("command -v xvfb-run >/dev/null 2>&1") != 0) {
        std::cout << "SKIPPED: xvfb-run not found\n";
        return;
    }
    const TemporaryFolder folder;
    std::ofstream(folder.path / "main.lua")
        << "function step()\n"
           "    if time.step == 2 then view.window.icon = 'icon.tga' end\n"
           "    if time.step == 4 then view.window.icon = 'icom.tga' end\n"
           "    if time.step == 6 then view.window.icon = 'text.png' end\n"
           "end\n";
    // One red pixel, uncompressed, and a file that is not an image.
    const char pixel[] = {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 24, 32, 0, 0, -1};
    std::ofstream(folder.path / "icon.tga").write(pixel, sizeof pixel);
    std::ofstream(folder.path / "text.png") << "no image";
    const std::string out = (folder.path / "out").string();
    const std::string command =
        "LIBGL_ALWAYS_SOFTWARE=1 xvfb-run -a -s '-screen 0 1280x800x24' '" FETTLE_PROGRAM
        "' run '" +
        folder.path.string() + "' --steps 10 >'" + out + "' 2>&1 </dev/null";
    CHECK(std::system(command.c_str()) == 0);
    std::ifstream in(out);
    const std::string output{std::istreambuf_iterator<char>(in), {}};
    INFO(output);
    CHECK(output.find("\"icon.tga\" is not an image") == std::string::npos);
    CHECK(output.find(
              "view.window.icon: there is no file \"icom.tga\" (did you mean \"icon.tga\"?)") !=
          std::string::npos);
    CHECK(output.find("view.window.icon: \"text.png\" is not an image that can be shown") !=
          std::string::npos);
}

TEST_CASE("a run begins with the settings of the player and its replay does not need them") {
    if (std::system("command -v xvfb-run >/dev/null 2>&1") != 0) {
        std::cout << "SKIPPED: xvfb-run not found\n";
        return;
    }
    const TemporaryFolder folder;
    const auto write = [&](const std::string& name, const std::string& text) {
        fs::create_directories((folder.path / name).parent_path());
        std::ofstream(folder.path / name) << text;
    };
    const auto shell = [&](const std::string& command) {
        const std::string whole =
            "cd '" + folder.path.string() +
            "' && export XDG_DATA_HOME=\"$PWD/data\" LIBGL_ALWAYS_SOFTWARE=1 && " + command +
            " >out 2>&1 </dev/null";
        const int status = std::system(whole.c_str());
        std::ifstream in(folder.path / "out");
        const std::string out{std::istreambuf_iterator<char>(in), {}};
        INFO(out);
        CHECK(status == 0);
        return out;
    };
    const std::string program = "'" FETTLE_PROGRAM "' run ";
    const std::string settings = "data/fettle/games/org.example.screen/settings.json";
    write(settings, "{ \"fullscreen\": true, \"other\": 1 }");
    write("game/game.json", R"({ "id": "org.example.screen", "window": { "size": [640, 400] } })");
    write("game/main.lua", R"(
        function step()
            local w = view.window
            if time.step % 10 == 0 then print(w.fullscreen, view.screen, w.size) end
        end
    )");
    const std::string expected =
        "true\tvec(1280, 800)\tvec(640, 400)\nfalse\tvec(640, 400)\tvec(640, 400)\n";
    CHECK(shell("xvfb-run -a -s '-screen 0 1280x800x24' " + program +
                "game --steps 20 --record a.rec --at '15:view.window.fullscreen = false'") ==
          expected);
    std::ifstream in(folder.path / settings);
    const std::string kept{std::istreambuf_iterator<char>(in), {}};
    CHECK(kept.find("\"fullscreen\": false") != std::string::npos);
    CHECK(kept.find("\"other\": 1") != std::string::npos);
    CHECK(shell(program + "--replay a.rec --headless") ==
          expected + "20 steps, each as it was recorded\n");
}

}  // namespace fullscreen_test
