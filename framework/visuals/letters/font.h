#pragma once
// Fonts: sizes of letters without a screen, and their pixels in any size.

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>

#include <fettle/property/picture.h>

namespace fettle::visuals {

/// The pixels of a letter in one size.
struct Letter {
    property::Picture picture;
    double size = 0;           // px, of the font
    double left = 0, top = 0;  // px, from the pen position on the baseline; y down
    bool colored = false;      // has colors of its own, such as an emoji
};

class Font {
  public:
    /// A TTF or OTF file. `index`: of the font in a file that has several. Throws
    /// std::runtime_error if it is none.
    explicit Font(std::string file, int index = 0);
    ~Font();
    Font(const Font&) = delete;
    Font& operator=(const Font&) = delete;

    bool has(char32_t letter) const;
    // Lengths for a font of size 1.
    double advance(char32_t letter) const;
    /// The change of the distance between two letters that follow each other.
    double kerning(char32_t first, char32_t second) const;
    double ascent() const { return ascent_; }    // of the highest letters above the baseline
    double descent() const { return descent_; }  // below it, positive

    /// `size`: px. Null for a letter without pixels, such as a space. The letter lives at least
    /// until the next call. With an `outline`, a part of the size, it is the line around the letter
    /// that is so wide to each side of its rim; null for a letter that is a picture.
    const Letter* letter(char32_t letter, double size, double outline = 0);

  private:
    struct Data;
    struct Glyph {
        unsigned index = 0;  // 0: the font lacks the letter
        double advance = 0;
    };
    unsigned glyph(char32_t letter) const;
    double set_size(double size) const;
    std::unique_ptr<Letter> draw(char32_t letter, double wanted) const;
    std::unique_ptr<Letter> draw_outline(char32_t letter, double wanted, double outline) const;

    std::string file_;
    std::unique_ptr<Data> data_;
    double unit_ = 0;  // size of a unit of the font, for a font of size 1
    double ascent_ = 0, descent_ = 0;
    std::unordered_map<std::uint64_t, std::unique_ptr<Letter>> letters_;
    mutable std::unordered_map<char32_t, Glyph> glyphs_;
    mutable std::unordered_map<std::uint64_t, double> kernings_;  // of pairs of letters
};

}  // namespace fettle::visuals
