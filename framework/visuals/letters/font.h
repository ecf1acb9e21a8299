#pragma once
// Fonts: sizes of letters without a screen, and their pixels in any size. A glyph is a picture in a
// font: that of a letter, of a joined form of it, or of several letters together.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <fettle/property/picture.h>

namespace fettle::visuals {

/// The pixels of a glyph in one size.
struct Letter {
    property::Picture picture;
    double size = 0;           // px, of the font
    double left = 0, top = 0;  // px, from the pen position on the baseline; y down
    bool colored = false;      // has colors of its own, such as an emoji
};

/// A part of a text in one font, script and direction.
struct Run {
    std::size_t begin = 0, end = 0;
    std::uint32_t script = 0;  // as HarfBuzz numbers them
    bool right_to_left = false;
};

/// A glyph of a shaped run. Lengths are for a font of size 1.
struct ShapedGlyph {
    unsigned glyph = 0;
    std::size_t letter = 0;  // the first letter in the text that it is for
    double x = 0, y = 0;     // from the pen, y down
    double advance = 0;      // of the pen
};

class Font {
  public:
    /// A TTF or OTF file. `index`: of the font in a file that has several. Throws
    /// std::runtime_error if it is none.
    explicit Font(std::string file, int index = 0);
    ~Font();
    Font(const Font&) = delete;
    Font& operator=(const Font&) = delete;

    /// Whether its glyphs are pictures, such as emoji. A space of such a font is as wide as they
    /// are.
    bool of_pictures() const;
    bool has(char32_t letter) const { return glyph(letter) != 0; }
    /// The glyph of the letter by itself; 0 if the font lacks it.
    unsigned glyph(char32_t letter) const { return known(letter).index; }
    // Lengths for a font of size 1.
    double advance(char32_t letter) const { return known(letter).advance; }
    /// The change of the distance between two letters that follow each other.
    double kerning(char32_t first, char32_t second) const;
    /// The glyphs of a run from left to right, joined as its script asks. The letters around the
    /// run have an effect on joins.
    std::vector<ShapedGlyph> shape(std::u32string_view text, const Run& run) const;
    double ascent() const { return ascent_; }    // of the highest letters above the baseline
    double descent() const { return descent_; }  // below it, positive

    /// `size`: px. Null for a glyph without pixels, such as a space. The letter lives at least
    /// until the next call. With an `outline`, a part of the size, it is the line around the glyph
    /// that is so wide to each side of its rim; null for a glyph that is a picture.
    const Letter* letter(unsigned glyph, double size, double outline = 0);

  private:
    struct Data;
    struct Glyph {
        unsigned index = 0;  // 0: the font lacks the letter
        double advance = 0;
    };
    const Glyph& known(char32_t letter) const;
    double set_size(double size) const;
    std::unique_ptr<Letter> draw(unsigned glyph, double wanted) const;
    std::unique_ptr<Letter> draw_outline(unsigned glyph, double wanted, double outline) const;

    std::string file_;
    std::unique_ptr<Data> data_;
    double unit_ = 0;  // size of a unit of the font, for a font of size 1
    double ascent_ = 0, descent_ = 0;
    std::unordered_map<std::uint64_t, std::unique_ptr<Letter>> letters_;
    mutable std::unordered_map<char32_t, Glyph> glyphs_;
    mutable std::unordered_map<std::uint64_t, double> kernings_;  // of pairs of letters
};

}  // namespace fettle::visuals
