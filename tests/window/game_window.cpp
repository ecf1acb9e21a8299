#include "game_window.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <thread>

namespace fettle::test {

namespace fs = std::filesystem;

namespace {

constexpr double patience = 30;  // s, for any reaction on a slow machine
constexpr auto look_interval = std::chrono::milliseconds(20);
constexpr int screen_width = 1280, screen_height = 800;

}  // namespace

std::string missing_tools() {
    std::string missing;
    for (const char* program : {"Xvfb", "xdotool"})
        if (!available(program)) missing += (missing.empty() ? "" : " and ") + std::string(program);
    return missing;
}

GameWindow::GameWindow(const fs::path& game, const std::map<std::string, std::string>& environment,
                       const std::string& window_manager, const std::string& keyboard) {
    start_display();
    if (!keyboard.empty()) set_layout(keyboard);
    if (!window_manager.empty()) start_manager(window_manager);
    environment_["XDG_STATE_HOME"] = (folder_ / "state").string();
    environment_["XDG_DATA_HOME"] = (folder_ / "data").string();
    environment_["WAYLAND_DISPLAY"] = "";
    environment_["LIBGL_ALWAYS_SOFTWARE"] = "1";
    std::vector<std::string> command = {FETTLE_PROGRAM};
    if (!game.empty()) {
        command.push_back("run");
        // A copy, because the journal of tweaks is written beside the game.
        fs::copy(game, folder_ / "game", fs::copy_options::recursive);
        command.push_back((folder_ / "game").string());
    }
    std::map<std::string, std::string> all = environment;
    all.insert(environment_.begin(), environment_.end());
    program_ = Process(command, all, folder_ / "printed");
    focus();
}

GameWindow::~GameWindow() {
    program_.end();
    manager_.end();
    display_.end();
}

// Xvfb takes the first free number itself and reports it, so no other program can take it in
// between. Without -noreset it restarts after its last client has left, as xdotool does after each
// search for the window, and refuses clients meanwhile.
void GameWindow::start_display() {
    fs::path number = folder_ / "number";
    std::string screen = std::to_string(screen_width) + "x" + std::to_string(screen_height) + "x24";
    std::string command = "exec Xvfb -displayfd 3 -screen 0 " + screen + " -fbdir '" +
                          folder_.string() + "' -noreset -nolisten tcp 3>'" + number.string() + "'";
    display_ = Process({"sh", "-c", command}, {}, folder_ / "display");
    bool up = eventually(
        [&] { return !display_.running() || read_file(number).find('\n') != std::string::npos; });
    if (!up || !display_.running())
        throw std::runtime_error("no virtual display came up\n" + read_file(folder_ / "display"));
    std::string name = read_file(number);
    environment_["DISPLAY"] = ":" + name.substr(0, name.find('\n'));
}

// A window that is opened while the manager starts may be left out by it, and is then never shown.
void GameWindow::start_manager(const std::string& name) {
    manager_ = Process({name}, environment_, folder_ / "manager");
    const bool up = eventually([&] {
        return run({"xdotool", "get_num_desktops"}, environment_, folder_ / "desktops") == 0;
    });
    if (!up) throw std::runtime_error(name + " did not start\n" + read_file(folder_ / "manager"));
}

void GameWindow::set_layout(const std::string& keyboard) {
    if (run({"setxkbmap", keyboard}, environment_, folder_ / "layout") != 0)
        throw std::runtime_error("setxkbmap failed\n" + read_file(folder_ / "layout"));
}

std::string GameWindow::active_window() const {
    const auto ask = [&](std::vector<std::string> command) {
        const fs::path found = folder_ / "active";
        fs::remove(found);
        command.insert(command.begin(), "xdotool");
        return run(command, environment_, found) == 0 ? read_file(found) : "";
    };
    // The manager reports a window as active before the window has the keyboard.
    const std::string active = ask({"getactivewindow"});
    return active == ask({"getwindowfocus", "-f"}) ? active : "";
}

void GameWindow::xdotool(const std::vector<std::string>& arguments) const {
    std::vector<std::string> command = {"xdotool"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    if (run(command, environment_, folder_ / "xdotool") != 0)
        throw std::runtime_error("xdotool failed\n" + read_file(folder_ / "xdotool"));
}

void GameWindow::focus() {
    const fs::path found = folder_ / "windows";
    const bool shown = eventually([&] {
        fs::remove(found);
        return run({"xdotool", "search", "--onlyvisible", "--name", "."}, environment_, found) ==
                   0 &&
               !read_file(found).empty();
    });
    if (!shown) throw std::runtime_error("no window came up\n" + printed());
    // Without a window manager the position of the window is not set.
    std::string window = read_file(found);
    window = window.substr(0, window.find('\n'));
    xdotool({"windowmove", "--sync", window, "0", "0"});
    xdotool({"windowfocus", window});
}

void GameWindow::key(const std::string& name) {
    xdotool({"key", "--delay", "30", name});
}
void GameWindow::hold(const std::string& name, bool down) {
    xdotool({down ? "keydown" : "keyup", name});
}
void GameWindow::type(const std::string& text) {
    xdotool({"type", "--delay", "20", text});
}

void GameWindow::move(int x, int y) {
    xdotool({"mousemove", "--sync", std::to_string(x), std::to_string(y)});
}

void GameWindow::hold_button(bool down) {
    xdotool({down ? "mousedown" : "mouseup", "1"});
}

void GameWindow::click(int x, int y) {
    move(x, y);
    xdotool({"click", "1"});
}

Picture GameWindow::picture() const {
    return read_xwd(folder_ / "Xvfb_screen0");
}
std::string GameWindow::printed() const {
    return read_file(folder_ / "printed");
}

bool GameWindow::eventually(const std::function<bool()>& condition) {
    auto deadline = std::chrono::steady_clock::now() + std::chrono::duration<double>(patience);
    while (!condition()) {
        if (std::chrono::steady_clock::now() > deadline) return false;
        std::this_thread::sleep_for(look_interval);
    }
    return true;
}

bool GameWindow::prints(const std::string& text) {
    return eventually([&] { return printed().find(text) != std::string::npos; });
}

Picture GameWindow::settled() {
    constexpr int same_needed = 4, max_pictures = 40;
    // Before the first picture of the game, the screen is black, which does not change either.
    const auto is_drawn = [](const Picture& seen) {
        return std::ranges::any_of(seen.rgb,
                                   [&](std::uint8_t part) { return part != seen.rgb[0]; });
    };
    eventually([&] { return is_drawn(picture()); });
    Picture last = picture();
    int same = 0;
    for (int i = 0; i < max_pictures && same < same_needed; ++i) {
        std::this_thread::sleep_for(4 * look_interval);
        Picture next = picture();
        // The blinking caret and the pulsing outline always change.
        same = next.difference(last) < 3000 ? same + 1 : 0;
        last = std::move(next);
    }
    return last;
}

}  // namespace fettle::test
