#pragma once
// Characters that the fonts are not built with at first, such as Chinese ones, stars and emoji:
// they are added when a text with them is drawn. All of them at once would take a texture of many
// megabytes. Until version 1.92, Dear ImGui makes all glyphs of a font together, so the fonts are
// built again when there are new characters. Since then it asks for each one when it is drawn
// first.
//
// A character of Debian's Dear ImGui has 16 bits. So each character beyond U+FFFF gets a stand-in
// when it is seen first, from a range of rare Chinese characters (U+3400 to U+4DBF). Dear ImGui
// gets the stand-in, in texts and from the keyboard; what it returns is translated back. Characters
// of that range have stand-ins as well, so that each text comes back as it was; and so have those
// for private use, because Dear ImGui drops them from what is typed and pasted.

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

#include <look/glyph_pictures.h>
#include <look/imgui_compat.h>

namespace fettle::console {

class ExtraGlyphs {
  public:
    static constexpr std::size_t most = 4000;  ///< characters

    /// What most texts consist of, which the fonts always have: Latin letters of European
    /// languages, the sign of formulas (ƒ), Greek and Russian letters, punctuation, superscripts,
    /// currency, arrows, common mathematics, box drawing, geometric shapes, check marks.
    static const ImWchar* always();
    /// The ranges of all characters but those and control characters; they end with 0.
    static const ImWchar* others();
    /// Files of fonts that have what the others lack, the best first.
    static const std::vector<const char*>& fallbacks();
    /// The glyphs of the current context.
    static ExtraGlyphs& current() { return *static_cast<ExtraGlyphs*>(ImGui::GetIO().UserData); }

    /// The text with stand-ins, for Dear ImGui: `text` itself if it needs none, otherwise
    /// `storage`. Characters that the fonts do not have yet are there from a later frame on.
    std::string_view shown(std::string_view text, std::string& storage);
    std::string shown(std::string_view text);
    char32_t shown(char32_t character);
    /// The text with the characters that the stand-ins stand for.
    std::string meant(std::string_view shown) const;
    /// Whether there are new ones since the last `prepare`.
    bool changed() const { return changed_; }
    /// Call before fonts are added.
    void prepare();
    /// Adds them to the font that was added last, from its own file and from others. `cell`: the
    /// width of a character in pixels, of a wide one twice that; 0: as the fonts have it.
    void add_to_last_font(ImFontAtlas& atlas, const char* own_file, float size, float cell);
    /// Call when the texture of the fonts has been made: copies the pictures into it.
    void draw_pictures(ImFontAtlas& atlas);

  private:
    struct Placed {
        int rect = 0;  // its number in the atlas
        ImFont* font = nullptr;
        ImWchar code = 0;
        GlyphPictures::Picture picture;
    };
    void look(std::string_view text);
    void add_file(ImFontAtlas& atlas, const char* file, float size, float cell);
    void add_pictures(ImFontAtlas& atlas, float size, float cell);
    /// The picture of a character that Dear ImGui asks for; nothing if no font has it.
    std::optional<GlyphPictures::Picture> paint(ImWchar code, const char* own_file, float size,
                                                float cell);

    std::set<char32_t> seen_;
    bool changed_ = false;
    std::vector<ImWchar> narrow_, wide_;  // ranges, which the atlas keeps pointers to
    std::vector<char32_t> pictured_;      // characters that are added as pictures
    std::vector<Placed> placed_;
    std::vector<std::unique_ptr<compat::PaintGlyph>> painters_;  // where glyphs come on demand
    GlyphPictures pictures_;
    std::map<char32_t, ImWchar> stand_ins_;
    std::vector<char32_t> stand_for_;  // the character of each stand-in
};

}  // namespace fettle::console
