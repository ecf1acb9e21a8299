#pragma once
// Connects Dear ImGui to Fettle's input events and surface: events go in, triangles come out. This
// code does not depend on a window library or a graphics interface.

#include <cstdint>
#include <string>
#include <vector>

#include <fettle/app/layer.h>

struct ImFont;
struct ImGuiContext;
struct ImDrawList;

#include <look/extra_glyphs.h>
#include <look/game_pictures.h>

namespace fettle::console {

class ImGuiBackend {
  public:
    /// `clipboard` may be null; then text is not shared with other programs.
    explicit ImGuiBackend(app::Clipboard* clipboard);
    ~ImGuiBackend();
    ImGuiBackend(const ImGuiBackend&) = delete;

    /// Must be called before every use of ImGui for this console, because there may be several
    /// contexts.
    void activate();
    /// Accepts the key events for widgets, and all mouse events.
    void feed(const app::InputEvent& event);
    /// Passes the state of control, shift and alt; widgets need it even if the key is not for them.
    void feed_modifiers(const app::InputEvent& key_event);
    void release_all();
    /// Switches keyboard navigation on for popup lists (arrows, Escape). Otherwise the keys belong
    /// to the prompt.
    void navigate_with_keys(bool on);
    /// Closes all popup lists.
    void close_menus();
    /// `font_size` in pixels; the fonts are built again when it changes.
    void begin_frame(float width, float height, double seconds, float font_size);
    void end_frame();
    /// Draws the last finished frame.
    void draw(app::Surface& surface);

    /// For draw lists with pictures of the game.
    GamePictures& pictures() { return pictures_; }
    ImFont* regular() const { return regular_; }
    ImFont* bold() const { return bold_; }
    float font_size() const { return font_size_; }

  private:
    void build_fonts(float font_size);
    void draw_list(const ImDrawList& list, app::Surface& surface);

    ExtraGlyphs extra_;
    GamePictures pictures_;
    ImGuiContext* context_;
    app::Clipboard* clipboard_;
    std::string clipboard_text_;  // owner of the text that the last read returned
    ImFont* regular_ = nullptr;
    ImFont* bold_ = nullptr;
    float font_size_ = 0;
    app::Surface* textures_on_ = nullptr;
    bool fonts_changed_ = false;
    app::Surface::Texture replaced_ = 0;  // that of the fonts before
    std::vector<app::SurfaceVertex> vertices_;
    std::vector<std::uint16_t> indices_;
};

}  // namespace fettle::console
