#pragma once
// Characters that the fonts are not built with at first, such as Chinese ones: they are added when
// a text with them is drawn. All of them at once would take a texture of many megabytes.

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

namespace fettle::console {

class ExtraGlyphs {
  public:
    static constexpr std::size_t most = 4000;  ///< characters

    /// Characters for units and names, which the fonts always have: Latin, Greek, Cyrillic,
    /// punctuation, superscripts, currency, letterlike, arrows, mathematics, box drawing, geometric
    /// shapes, dingbats.
    static const ImWchar* always();
    /// Notes the other characters of a text. They are there from a later frame on.
    void look(std::string_view text);
    /// Whether there are new ones since the last `prepare`.
    bool changed() const { return changed_; }
    /// Call before fonts are added.
    void prepare();
    /// Adds them to the font that was added last, from its own file and from others. `cell`: the
    /// width of a character in pixels, of a wide one twice that; 0: as the fonts have it.
    void add_to_last_font(ImFontAtlas& atlas, const char* own_file, float size, float cell);

  private:
    void add_file(ImFontAtlas& atlas, const char* file, float size, float cell);

    std::set<char32_t> seen_;
    bool changed_ = false;
    std::vector<ImWchar> narrow_, wide_;  // ranges, which the atlas keeps pointers to
};

/// The file of a font by its name, "" if it is not installed. A packaged game brings its fonts
/// along, in the folder FETTLE_FONTS.
std::string font_file(const char* name);

}  // namespace fettle::console
