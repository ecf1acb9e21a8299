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
};

class Font {
  public:
    /// A TTF or OTF file. Throws std::runtime_error if it is none.
    explicit Font(std::string file);
    ~Font();
    Font(const Font&) = delete;
    Font& operator=(const Font&) = delete;

    bool has(char32_t letter) const;
    // Lengths for a font of size 1.
    double advance(char32_t letter) const;
    double kerning(char32_t first, char32_t second) const;
    double ascent() const { return ascent_; }    // of the highest letters above the baseline
    double descent() const { return descent_; }  // below it, positive

    /// `size`: px. Null for a letter without pixels, such as a space. The letter lives at least
    /// until the next call.
    const Letter* letter(char32_t letter, double size);

  private:
    struct Data;
    int glyph(char32_t letter) const;

    std::string file_;
    std::unique_ptr<Data> data_;
    double unit_ = 0;  // size of a unit of the font, for a font of size 1
    double ascent_ = 0, descent_ = 0;
    std::unordered_map<std::uint64_t, std::unique_ptr<Letter>> letters_;
    mutable std::unordered_map<char32_t, int> glyphs_;
};

}  // namespace fettle::visuals
