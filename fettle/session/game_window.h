#pragma once
// The window in which a game runs. It follows `view.window`, and keeps the settings of the player.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <fettle/app/screen.h>
#include <fettle/property/storage/game_settings.h>

namespace fettle::program {

class Session;

/// The window that `game.json` describes.
app::WindowState window_state(const property::GameSettings& settings);

class GameWindow {
  public:
    /// Opens the window with the settings of the game and of the player.
    GameWindow(const std::filesystem::path& game, const property::GameSettings& settings);

    app::Window& screen() { return *window_; }
    /// Connects a session that was made and not started yet.
    void before_start(Session& session);
    /// Applies the settings that the player made in earlier runs.
    void started(Session& session);
    /// Whether the event is a key of the window: F11 and Alt+Enter change `fullscreen`. With ctrl
    /// and V, `input.clipboard` becomes the clipboard of the system.
    bool handle(const app::InputEvent& event, Session& session);
    /// Call once a frame, before drawing.
    void follow(Session& session);

  private:
    void show_icon(Session& session);
    void read_clipboard(Session& session);
    void write_clipboard(Session& session);
    void set(Session& session, const char* name, const property::Value& value);

    std::filesystem::path folder_;  // of the player
    property::PlayerSettings player_;
    std::unique_ptr<app::Window> window_;
    bool fullscreen_;          // as last seen
    std::string icon_{};       // as last seen
    std::string clipboard_{};  // `input.clipboard` as last seen
};

}  // namespace fettle::program
