#pragma once
// A small world with a console, driven by the events that a window would send.

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/console/console.h>
#include <fettle/property/path.h>
#include <fettle/property/storage/tweaks.h>
#include <fettle/property/tree.h>

#include <panel/state.h>
#include "raster_surface.h"

namespace fettle::console::test {

class TextClipboard : public app::Clipboard {
  public:
    std::string read() override { return text; }
    void write(std::string_view written) override { text = written; }
    std::string text;
};

/// Defines classes similar to those of a game: `World` with `at`, `Body` with a property of every
/// type.
void define_game(property::Tree& tree);
/// A tree with `world`, three bodies in it, and `time.paused`.
void make_game(property::Tree& tree);

app::InputEvent key_event(std::string_view name, bool pressed);

class Rig {
  public:
    /// Commands are evaluated by a simple replacement of Lua: `path = value` sets, `path` prints.
    /// `game`: a file whose tweaks are journaled; empty: no journal.
    explicit Rig(Options options = {}, const std::filesystem::path& game = {});

    /// Presses and releases a key; for example "ctrl+r", "shift+enter". Returns true if the
    /// console consumed the press, so that the game does not get it.
    bool key(std::string_view combination);
    bool press(std::string_view name);
    bool release(std::string_view name);
    bool character(char32_t character);
    /// Sends key, text and release for each character of ASCII text, as a keyboard does.
    void type(std::string_view text);
    bool move(float x, float y);
    bool button(bool pressed, float x, float y, std::string_view name = "left");
    void click(float x, float y);
    void drag(float from_x, float from_y, float to_x, float to_y);
    void draw(int frames = 1);

    Console::State& state() { return console.state(); }
    std::string input() { return state().prompt.edit().text(); }
    /// The lines of the log as one string.
    std::string log_text();
    bool logged(std::string_view part) { return log_text().find(part) != std::string::npos; }
    property::Value value(std::string_view path) { return property::get(tree, path); }
    /// Middle of the widget of a property of the selected instance; draws frames until the widget
    /// is visible.
    ImVec2 widget(std::string_view property, float share_x = 0.5f);
    void save(const std::string& name);

    property::Tree tree;
    std::unique_ptr<property::Tweaks> tweaks;
    TextClipboard clipboard;
    std::vector<std::string> commands;  // evaluated commands
    RasterSurface surface;
    Console console;

  private:
    std::string run_tweak_command(const std::string& command);
    Interpreter simple_interpreter();
    Options with_view(Options options);
};

}  // namespace fettle::console::test
