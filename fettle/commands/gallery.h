#pragma once
// The gallery: a game that shows the games that are installed with Fettle, and starts the one that
// is chosen, in the same window. It gets functions of the host that no other game has.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <fettle/app/layer.h>
#include <fettle/app/screen.h>
#include <fettle/script/runtime.h>

namespace fettle::program {

class Session;

/// A game in the gallery.
struct GalleryEntry {
    std::string name;   // of its folder
    std::string title;  // of its game.json; else the name
    std::string about;  // the first sentence of the comment at the top of its main.lua
    bool released;      // its game.json has a version: a whole game, and no example
    std::filesystem::path game;
};

/// The games beside the gallery, by name: whole games, then examples.
std::vector<GalleryEntry> gallery_entries(const std::filesystem::path& gallery);

class Gallery : public app::Layer {
  public:
    explicit Gallery(std::filesystem::path game);

    const std::filesystem::path& game() const { return game_; }
    /// Gives the scripts of the gallery their functions, before they are loaded. The textures of an
    /// earlier session must be released before.
    void connect(Session& session);
    /// The game that was chosen since the last call.
    std::optional<std::filesystem::path> take_choice();
    /// Makes the picture of one game that has none yet. Needs a display.
    void make_picture();

    bool handle(const app::InputEvent&) override { return false; }
    /// Draws the pictures where the scripts have asked for them in this frame.
    void draw(app::Surface& surface, double seconds) override;

  private:
    struct Picture {
        app::Pixels pixels{};
        app::Surface::Texture texture = 0;
    };
    struct Place {
        std::string name;
        app::ClipRectangle rectangle;
        float top;  // px; nothing is drawn above it
    };
    property::Value games() const;
    void show(std::span<const property::Value> arguments);
    void choose(const std::string& name);

    std::filesystem::path game_;
    std::vector<GalleryEntry> entries_;
    std::map<std::string, Picture> pictures_;  // without pixels: its game failed
    std::vector<Place> places_;
    std::optional<std::filesystem::path> choice_;
};

}  // namespace fettle::program
