#pragma once
// Pictures of characters that the atlas of Dear ImGui cannot make by itself: emoji in their colors,
// and characters beyond U+FFFF.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace fettle::console {

class GlyphPictures {
  public:
    struct Picture {
        int width = 1, height = 1;       // pixels
        float left = 0, top = 0;         // from the top left corner of the line
        float advance = 0;               // to the next character
        bool colored = false;            // it has colors of its own
        std::vector<std::uint8_t> rgba;  // rows from the top
    };

    GlyphPictures();
    ~GlyphPictures();
    GlyphPictures(const GlyphPictures&) = delete;

    /// Whether an installed font has a colored picture of the character.
    bool colored(char32_t character);
    /// `size`: the height of the line in pixels. `cell`: the width of a character; a wide one gets
    /// twice that; 0: the width that the font gives. `first`: the file of the font that is asked
    /// before the fallbacks. Nothing if no installed font has the character.
    std::optional<Picture> draw(char32_t character, float size, float cell,
                                const char* first = nullptr);

  private:
    struct Faces;
    Faces& faces();  // opened at the first use

    std::unique_ptr<Faces> faces_;
};

}  // namespace fettle::console
