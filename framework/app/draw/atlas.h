#pragma once
// One texture for figures and text: a white patch for plain triangles, discs for small circles, and
// glyphs. With one texture, they need only one draw call and keep their order. Pictures are
// in other textures; see pictures.h.

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
    float left = 0, top = 0;  // of the image, from the pen position on the baseline, y down, px
    float advance = 0;        // px
    Patch patch{};            // width 0: an empty glyph, such as a space
};

class Atlas {
  public:
    Atlas();

    const sf::Texture& texture() const { return texture_; }
    /// The white patch is in the corner; both coordinates of its center.
    static constexpr unsigned white_side = 4;
    static constexpr float white = 2;

    static constexpr float largest_disc = 56;  // px
    /// The smallest disc with a radius of at least `radius`, which is at most `largest_disc`.
    const Disc& disc(float radius) const;

    bool has_font(Face face) const;
    /// Draws missing glyphs of a line at a whole pixel size into the atlas. Returns false if the
    /// atlas is full: then flush the batch and call `clear_glyphs`.
    bool prepare(const std::u32string& line, unsigned size, Face face);
    /// The glyph must have been prepared.
    const Glyph& glyph(char32_t character, unsigned size, Face face) const;
    float kerning(char32_t first, char32_t second, unsigned size, Face face) const;
    float ascent(unsigned size, Face face) const;  // px above the baseline
    void clear_glyphs();

  private:
    // With software rendering, filling a larger texture would take a third of the time until the
    // first picture.
    static constexpr unsigned side = 1024;

    struct Shelf {
        unsigned x = 0, y = 0, height = 0;
    };
    static std::uint64_t key(char32_t character, unsigned size, Face face);
    std::optional<Patch> place(unsigned width, unsigned height);
    void write(const Patch& patch, const std::vector<std::uint8_t>& pixels);
    void draw_discs();
    void load_fonts();
    const sf::Font* font(Face face) const;
    const sf::Font& font_with(char32_t character, unsigned size, Face face);

    sf::Texture texture_;
    std::vector<Disc> discs_;
    Shelf shelf_{};
    unsigned glyphs_from_ = 0;  // row below the discs
    std::array<std::unique_ptr<sf::Font>, 3> fonts_;
    std::optional<std::vector<std::unique_ptr<sf::Font>>> fallbacks_;  // none until one is needed
    std::unordered_map<std::uint64_t, Glyph> glyphs_;
};

}  // namespace fettle::app
