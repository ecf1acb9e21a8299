// A gamepad as Linux reports it, through the library of the window, to the game.

#include <fcntl.h>
#include <linux/joystick.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <iostream>
#include <stdexcept>

#include "catch.h"
#include "game_window.h"
#include "temporary_folder.h"

namespace gamepad_window_test {

using fettle::test::GameWindow;
using fettle::test::missing_tools;
namespace fs = std::filesystem;

namespace {

/// The pipe from which the library in `gamepad/` takes the events of a DualShock 4.
class Pad {
  public:
    explicit Pad(const fs::path& pipe) {
        if (::mkfifo(pipe.c_str(), 0600) == 0) file_ = ::open(pipe.c_str(), O_RDWR);
        if (file_ < 0) throw std::runtime_error("no pipe " + pipe.string());
    }
    ~Pad() { ::close(file_); }
    Pad(const Pad&) = delete;

    void button(unsigned char number, bool down) { send(JS_EVENT_BUTTON, number, down ? 1 : 0); }
    void axis(unsigned char number, short value) { send(JS_EVENT_AXIS, number, value); }

  private:
    void send(unsigned char type, unsigned char number, short value) {
        js_event event{};
        event.type = type;
        event.number = number;
        event.value = value;
        if (::write(file_, &event, sizeof event) != sizeof event)
            throw std::runtime_error("the event was not written");
    }
    int file_ = -1;
};

}  // namespace

TEST_CASE("a gamepad of the system moves what the game binds to it") {
    if (const std::string missing = missing_tools(); !missing.empty()) {
        std::cout << "SKIPPED: " << missing << " not found\n";
        return;
    }
    const TemporaryFolder folder;
    fs::create_directory(folder.path / "game");
    std::ofstream(folder.path / "game" / "main.lua") << R"(
        input.actions.jump = { "gamepad.a" }
        function gamepad_axis(pad, axis, value) print(axis, string.format("%.2f", value)) end
        function gamepad_pressed(pad, button) print("pressed", button) end
        function gamepad_released(pad, button) print("released", button) end
        function action_pressed(action) print("action", action) end
        every(0.1, function() if input.move:length() > 0 then print("move", input.move) end end)
        local pad = input.gamepad_1
        after(0, function() print("ready", pad.connected, pad.mapping) end)
    )";
    Pad pad(folder.path / "js0");
    GameWindow game(folder.path / "game",
                    {{"LD_PRELOAD", FETTLE_GAMEPAD}, {"FETTLE_TEST_GAMEPAD", folder.path / "js0"}});
    const bool connected = game.prints("ready\ttrue\tplaystation");
    INFO(game.printed());
    REQUIRE(connected);
    pad.button(0, true);
    CHECK(game.prints("pressed\ta\n"));
    CHECK(game.prints("action\tjump"));
    pad.button(0, false);
    CHECK(game.prints("released\ta\n"));
    pad.button(2, true);
    CHECK(game.prints("pressed\ty\n"));
    pad.axis(0, 32767);
    CHECK(game.prints("left_x\t1.00"));
    CHECK(game.prints("move\tvec(1, 0)"));
    pad.axis(0, 0);
    pad.axis(1, -32767);
    CHECK(game.prints("left_y\t1.00"));
    CHECK(game.prints("move\tvec(0, 1)"));
    pad.axis(4, 32767);
    CHECK(game.prints("right_y\t-1.00"));
    pad.axis(5, 32767);
    CHECK(game.prints("right_trigger\t1.00"));
    pad.axis(7, -32767);
    CHECK(game.prints("pressed\tdpad_up"));
}

}  // namespace gamepad_window_test
