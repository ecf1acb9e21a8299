#pragma once
// The appearance: one palette and one scale of distances. It is dark, so that the game is brighter
// than the console.

#include <imgui.h>

#include <cstddef>
#include <string>
#include <string_view>

#include <text/highlight.h>
#include <text/log.h>

namespace fettle::console {

namespace palette {
inline constexpr ImU32 rgb(unsigned hex, unsigned alpha = 255) {
    return IM_COL32(hex >> 16 & 255, hex >> 8 & 255, hex & 255, alpha);
}
inline constexpr ImU32 text = rgb(0xdadde5);
inline constexpr ImU32 dim = rgb(0xb4bac6);
inline constexpr ImU32 faint = rgb(0x9aa2b1);
inline constexpr ImU32 line = rgb(0x505a6b);    // borders
inline constexpr ImU32 well = rgb(0x0d0f14);    // background of input fields
inline constexpr ImU32 panel = rgb(0x14171e);   // windows
inline constexpr ImU32 raised = rgb(0x1f242d);  // fields, headers
inline constexpr ImU32 popup = rgb(0x1a1e26);   // lists and tooltips
inline constexpr ImU32 hover = rgb(0x2a313d);
inline constexpr ImU32 chosen = rgb(0x2e3744);  // the selected row of a list
inline constexpr ImU32 accent = rgb(0xf4a259);
inline constexpr ImU32 selection = rgb(0xf4a259, 48);
inline constexpr ImU32 share = rgb(0xf4a259, 44);  // how much of its range a number is
inline constexpr ImU32 axis_x = rgb(0xf39b90);
inline constexpr ImU32 axis_y = rgb(0x8fd48a);
inline constexpr ImU32 path = rgb(0x77bdfb);
inline constexpr ImU32 number = rgb(0xc8a8f0);
inline constexpr ImU32 string = rgb(0xa8d587);
inline constexpr ImU32 error = rgb(0xff8080);
inline constexpr ImU32 note = rgb(0x74cbb9);
inline constexpr ImU32 clear = rgb(0, 0);
}  // namespace palette

/// Opacity of widgets that cannot be changed.
inline constexpr float disabled_alpha = 0.85f;

/// The fonts: for code and values, the same bold, and for labels.
struct Fonts {
    ImFont *mono = nullptr, *bold = nullptr, *sans = nullptr;
};
/// The fonts of the current context.
Fonts fonts();
/// While it lives, text is drawn in that font.
class FontScope {
  public:
    explicit FontScope(ImFont* font);
    ~FontScope();
    FontScope(const FontScope&) = delete;
};
/// The color of the nth line of a plot.
ImU32 series_color(std::size_t index);

/// Distances are given in font heights and multiplied with the font size; colors are fixed.
void apply_theme(float font_size);
ImU32 token_color(Token token);
ImU32 line_color(LineKind kind);
/// The color of the mark of a class in lists.
ImU32 class_color(std::string_view class_name);
ImU32 with_alpha(ImU32 color, float alpha);
ImVec4 vector(ImU32 color);

/// Draws a text and returns its width.
float draw_text(ImDrawList& list, ImVec2 at, ImU32 color, std::string_view text);
/// The text, shortened with an ellipsis to `width`.
std::string shortened(std::string_view text, float width);
/// Draws a text, shortened with an ellipsis to `width`.
void draw_text_fit(ImDrawList& list, ImVec2 at, ImU32 color, std::string_view text, float width);
/// The same for a path, whose end matters most: the ellipsis is in front.
void draw_path_fit(ImDrawList& list, ImVec2 at, ImU32 color, std::string_view path, float width);
float text_width(std::string_view text);
/// A text for a widget of Dear ImGui, which otherwise lacks characters (ExtraGlyphs).
std::string widget_text(std::string_view text);
/// An item of that text, as ImGui::TextUnformatted makes one.
void text_line(std::string_view text);
/// A tooltip, with line breaks where it would be too wide. `show_tip_beside` draws it beside the
/// present window, a menu, so that it covers no other entry.
void show_tip(std::string_view text);
void show_tip_beside(std::string_view text);
/// The text as a tooltip breaks its lines.
std::string tip_lines(std::string_view text);
/// The height of low buttons in pixels: that of a line, but enough to click on them.
float button_height();
/// A button that fits between lines of text.
bool low_button(const char* label);
/// A square button with a sign and a tooltip; it has no background until the mouse is over it.
bool small_button(const char* id, const char* sign, const char* tip);
/// The text with line breaks in place of blanks, so that it fits into `width` if possible. Dear
/// ImGui itself also breaks lines at dots, inside of numbers and paths.
std::string wrapped(std::string_view text, float width);

}  // namespace fettle::console
