#pragma once
// One texture that everything is drawn with: a white patch for plain triangles, discs for small
// circles, and glyphs. One texture means one draw call, in the order of painting.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include <fettle/app/surface.h>

#include <sfml/sfml.h>

namespace fettle::app {

/// A part of the atlas, in texels.
struct Patch {
    float left = 0, top = 0, width = 0, height = 0;
};

/// A disc with an anti-aliased rim: its radius, and the patch around it with a margin.
struct Disc {
    float radius;  // px
    Patch patch;
};

struct Glyph {
    float left = 0, top = 0;  // of the picture, from the pen on the baseline, y down, px
    float advance = 0;        // px
    Patch patch{};            // width 0: nothing to draw
};

class Atlas {
  public:
    Atlas();

    const sf::Texture& texture() const { return texture_; }
    /// Both coordinates of the middle of the white patch.
    static constexpr float white = 2;

    static constexpr float largest_disc = 56;  // px
    /// The smallest disc that is no smaller than `radius`, which is at most `largest_disc`.
    const Disc& disc(float radius) const;

    bool has_font(Face face) const;
    /// Glyphs of a line at a whole pixel size, those missing drawn into the atlas. Null when the
    /// atlas is full: `clear_glyphs` once what is batched is drawn.
    bool prepare(const std::u32string& line, unsigned size, Face face);
    /// Of a prepared glyph.
    const Glyph& glyph(char32_t character, unsigned size, Face face) const;
    float kerning(char32_t first, char32_t second, unsigned size, Face face) const;
    float ascent(unsigned size, Face face) const;  // px above the baseline
    void clear_glyphs();

  private:
    static constexpr unsigned side = 2048;

    struct Shelf {
        unsigned x = 0, y = 0, height = 0;
    };
    static std::uint64_t key(char32_t character, unsigned size, Face face);
    std::optional<Patch> place(unsigned width, unsigned height);
    void draw_discs();
    void load_fonts();
    const sf::Font* font(Face face) const;

    sf::Texture texture_;
    std::vector<Disc> discs_;
    Shelf shelf_{};
    unsigned glyphs_from_ = 0;  // the row below the discs
    std::array<std::unique_ptr<sf::Font>, 3> fonts_;
    std::unordered_map<std::uint64_t, Glyph> glyphs_;
};

/// Replacement characters stand for what is no UTF-8.
std::u32string decode_utf8(std::string_view text);

}  // namespace fettle::app
