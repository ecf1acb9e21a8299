#include <look/glyph_pictures.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>

#include <fettle/property/storage/font_files.h>

#include <ft2build.h>
#include FT_FREETYPE_H

#include <look/extra_glyphs.h>
#include <text/utf8.h>

namespace fettle::console {

namespace {

constexpr const char* color_font = "NotoColorEmoji.ttf";
constexpr float emoji_share = 0.9f;  // of the height of a line

/// A bitmap with four floats a pixel: red, green and blue times opacity, and opacity, from 0 to 1.
struct Bitmap {
    int width = 0, height = 0;
    std::vector<std::array<float, 4>> pixels;
};

Bitmap bitmap_of(const FT_Bitmap& from) {
    Bitmap made{static_cast<int>(from.width), static_cast<int>(from.rows), {}};
    made.pixels.reserve(std::size_t{from.width} * from.rows);
    for (unsigned y = 0; y < from.rows; ++y) {
        const unsigned char* const row =
            from.buffer + static_cast<std::ptrdiff_t>(y) * static_cast<std::ptrdiff_t>(from.pitch);
        for (unsigned x = 0; x < from.width; ++x) {
            if (from.pixel_mode == FT_PIXEL_MODE_BGRA) {
                const unsigned char* const p = row + std::size_t{4} * x;
                made.pixels.push_back(
                    {static_cast<float>(p[2]) / 255, static_cast<float>(p[1]) / 255,
                     static_cast<float>(p[0]) / 255, static_cast<float>(p[3]) / 255});
            } else {
                const float opacity = static_cast<float>(row[x]) / 255;
                made.pixels.push_back({opacity, opacity, opacity, opacity});
            }
        }
    }
    return made;
}

/// How much of the pixel number `at` lies between two places.
float covered(int at, float from, float to) {
    return std::max(
        0.0f, std::min(to, static_cast<float>(at + 1)) - std::max(from, static_cast<float>(at)));
}

/// A smaller bitmap: each pixel is the mean of the pixels that it covers.
Bitmap shrunk(const Bitmap& from, int width, int height) {
    Bitmap made{width, height, {}};
    const float wide = static_cast<float>(from.width) / static_cast<float>(width);
    const float high = static_cast<float>(from.height) / static_cast<float>(height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float left = wide * static_cast<float>(x), top = high * static_cast<float>(y);
            std::array<float, 4> sum{};
            for (int v = static_cast<int>(top); v < from.height && v < top + high; ++v)
                for (int u = static_cast<int>(left); u < from.width && u < left + wide; ++u) {
                    const int at = v * from.width + u;
                    for (std::size_t i = 0; i < 4; ++i)
                        sum[i] += covered(u, left, left + wide) * covered(v, top, top + high) *
                                  from.pixels[static_cast<std::size_t>(at)][i];
                }
            for (float& channel : sum) channel /= wide * high;
            made.pixels.push_back(sum);
        }
    return made;
}

std::vector<std::uint8_t> bytes_of(const Bitmap& bitmap) {
    std::vector<std::uint8_t> rgba;
    rgba.reserve(bitmap.pixels.size() * 4);
    const auto byte = [](float share) {
        return static_cast<std::uint8_t>(std::lround(std::clamp(share, 0.0f, 1.0f) * 255));
    };
    for (const auto& [r, g, b, a] : bitmap.pixels) {
        const float whole = std::max(a, 1.0f / 255);
        rgba.insert(rgba.end(), {byte(r / whole), byte(g / whole), byte(b / whole), byte(a)});
    }
    return rgba;
}

}  // namespace

struct GlyphPictures::Faces {
    Faces() {
        if (FT_Init_FreeType(&library) != 0) return;
        color = open(color_font);
        if (color != nullptr && FT_HAS_COLOR(color) == 0) color = nullptr;
        for (const char* const file : ExtraGlyphs::fallbacks())
            if (const FT_Face face = open(file)) outlines.push_back(face);
    }
    ~Faces() {
        if (library != nullptr) FT_Done_FreeType(library);  // and its faces
    }
    Faces(const Faces&) = delete;

    FT_Face open(const char* name) const {
        const std::string file = property::font_file(name);
        FT_Face face = nullptr;
        if (file.empty() || FT_New_Face(library, file.c_str(), 0, &face) != 0) return nullptr;
        return face;
    }
    /// Null if none has the character. `first`: a file, or null.
    FT_Face with(char32_t character, const char* first) {
        if (color != nullptr && FT_Get_Char_Index(color, character) != 0) return color;
        if (first != nullptr) {
            auto [at, is_new] = named.try_emplace(first);
            if (is_new) at->second = open(first);
            if (at->second != nullptr && FT_Get_Char_Index(at->second, character) != 0)
                return at->second;
        }
        for (const FT_Face face : outlines)
            if (FT_Get_Char_Index(face, character) != 0) return face;
        return nullptr;
    }

    FT_Library library = nullptr;
    FT_Face color = nullptr;
    std::vector<FT_Face> outlines;
    std::map<std::string, FT_Face> named;  // null: not installed
};

GlyphPictures::GlyphPictures() = default;
GlyphPictures::~GlyphPictures() = default;

GlyphPictures::Faces& GlyphPictures::faces() {
    if (!faces_) faces_ = std::make_unique<Faces>();
    return *faces_;
}

bool GlyphPictures::colored(char32_t character) {
    const FT_Face color = faces().color;
    return color != nullptr && FT_Get_Char_Index(color, character) != 0;
}

std::optional<GlyphPictures::Picture> GlyphPictures::draw(char32_t character, float size,
                                                          float cell, const char* first) {
    Picture picture;
    const int cells = cells_of(character);
    if (cells == 0) {  // it only joins or changes its neighbors
        picture.rgba.assign(4, 0);
        return picture;
    }
    const FT_Face face = faces().with(character, first);
    if (face == nullptr) return std::nullopt;
    // `size` is the height from the ascender to the descender, as in Dear ImGui.
    FT_Size_RequestRec request{FT_SIZE_REQUEST_TYPE_REAL_DIM, 0, std::lround(size * 64), 0, 0};
    if ((FT_IS_SCALABLE(face) ? FT_Request_Size(face, &request) : FT_Select_Size(face, 0)) != 0 ||
        FT_Load_Char(face, character, FT_LOAD_RENDER | FT_LOAD_COLOR | FT_LOAD_NO_HINTING) != 0)
        return std::nullopt;
    const FT_GlyphSlot slot = face->glyph;
    picture.colored = slot->bitmap.pixel_mode == FT_PIXEL_MODE_BGRA;
    if (!picture.colored && slot->bitmap.pixel_mode != FT_PIXEL_MODE_GRAY) return std::nullopt;
    Bitmap bitmap = bitmap_of(slot->bitmap);
    if (bitmap.pixels.empty()) bitmap = {1, 1, {{}}};

    const float advance = cell > 0          ? cell * static_cast<float>(cells)
                          : picture.colored ? std::ceil(size * 1.1f)
                                            : static_cast<float>(slot->advance.x) / 64;
    const float wide = static_cast<float>(bitmap.width), high = static_cast<float>(bitmap.height);
    const float room = picture.colored ? size * emoji_share : size;
    const float factor = std::min({1.0f, std::max(1.0f, advance) / wide, room / high});
    if (factor < 1)
        bitmap = shrunk(bitmap, std::max(1, static_cast<int>(wide * factor)),
                        std::max(1, static_cast<int>(high * factor)));
    picture.width = bitmap.width;
    picture.height = bitmap.height;
    picture.advance = advance;
    picture.left = std::floor((advance - static_cast<float>(bitmap.width)) / 2);
    picture.top = picture.colored || factor < 1
                      ? std::floor((size - static_cast<float>(bitmap.height)) / 2)
                      : std::round(static_cast<float>(face->size->metrics.ascender) / 64) -
                            static_cast<float>(slot->bitmap_top);
    picture.rgba = bytes_of(bitmap);
    return picture;
}

}  // namespace fettle::console
