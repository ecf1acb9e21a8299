#pragma once
// Dear ImGui on our own input events and surface: events in, triangles out. Neither the window
// library nor any graphics interface is known here.

#include <cstdint>
#include <string>
#include <vector>

#include <fettle/app/layer.h>

struct ImFont;
struct ImGuiContext;
struct ImDrawList;

namespace fettle::console {

class ImGuiBackend {
  public:
    /// `clipboard` may be null: then nothing is shared with other programs.
    explicit ImGuiBackend(app::Clipboard* clipboard);
    ~ImGuiBackend();
    ImGuiBackend(const ImGuiBackend&) = delete;

    /// Every use of ImGui for this console comes after this: there may be several contexts.
    void activate();
    /// Key events are those meant for widgets; mouse events all of them.
    void feed(const app::InputEvent& event);
    /// Control, shift and alt, which widgets need to know of even when the key is not theirs.
    void feed_modifiers(const app::InputEvent& key_event);
    void release_all();
    /// Lists that popped up are walked with the arrows and left with Escape; elsewhere the keys are
    /// the prompt's.
    void navigate_with_keys(bool on);
    /// `font_size` in pixels; fonts are built anew when it changes.
    void begin_frame(float width, float height, double seconds, float font_size);
    void end_frame();
    /// The last finished frame.
    void draw(app::Surface& surface);

    ImFont* regular() const { return regular_; }
    ImFont* bold() const { return bold_; }
    float font_size() const { return font_size_; }

  private:
    void build_fonts(float font_size);
    void draw_list(const ImDrawList& list, app::Surface& surface);

    ImGuiContext* context_;
    app::Clipboard* clipboard_;
    std::string clipboard_text_;  // what the last read returned lives here
    ImFont* regular_ = nullptr;
    ImFont* bold_ = nullptr;
    float font_size_ = 0;
    app::Surface* textures_on_ = nullptr;
    bool fonts_changed_ = false;
    std::vector<app::SurfaceVertex> vertices_;
    std::vector<std::uint16_t> indices_;
};

}  // namespace fettle::console
