// Reads fonts with FreeType; HarfBuzz finds the kerning and joins letters. Both libraries may be
// given damaged and malicious files.

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include <ft2build.h>
#include <hb.h>
#include FT_FREETYPE_H
#include FT_ADVANCES_H
#include FT_GLYPH_H
#include FT_OUTLINE_H
#include FT_STROKER_H

#include <letters/font.h>

namespace fettle::visuals {
namespace {

constexpr std::size_t most_letters = 4000;  // pictures that a font keeps
constexpr double largest = 256;             // px; larger letters are enlarged pictures of this size
constexpr long most_pixels = 4096;  // width and height of a letter that such a size can have

/// A size for letters that are drawn this large: few sizes, so that texts of many sizes, or one
/// that grows, share letters. The difference is at most a sixty-fourth, and a quarter of a pixel
/// below 16.
double kept_size(double size) {
    const double step = size < 16 ? 0.25 : size < 32 ? 0.5 : size < 64 ? 1 : size < 128 ? 2 : 4;
    return std::clamp(step * std::round(size / step), 1.0, largest);
}

/// A pixel of a bitmap, as red, green, blue and opacity that is not multiplied into them.
struct Pixel {
    std::uint8_t red = 255, green = 255, blue = 255, opacity = 0;
};

Pixel pixel_of(const FT_Bitmap& from, unsigned x, unsigned y) {
    const unsigned char* const row =
        from.buffer + static_cast<std::ptrdiff_t>(y) * static_cast<std::ptrdiff_t>(from.pitch);
    if (from.pixel_mode == FT_PIXEL_MODE_GRAY) return {.opacity = row[x]};
    if (from.pixel_mode == FT_PIXEL_MODE_MONO)
        return {.opacity = static_cast<std::uint8_t>((row[x / 8] >> (7 - x % 8) & 1) * 255)};
    if (from.pixel_mode != FT_PIXEL_MODE_BGRA) return {};
    const unsigned char* const p = row + std::size_t{4} * x;
    const unsigned opacity = p[3];
    const auto channel = [&](unsigned value) {
        return static_cast<std::uint8_t>(opacity == 0 ? 0 : std::min(255u, value * 255u / opacity));
    };
    return {channel(p[2]), channel(p[1]), channel(p[0]), p[3]};
}

// Latin letters are not joined to ligatures: each one is drawn by itself, so that a caret can be
// between any two of them.
constexpr std::array<hb_feature_t, 3> without_ligatures = {
    {{HB_TAG('l', 'i', 'g', 'a'), 0, 0, ~0u},
     {HB_TAG('c', 'l', 'i', 'g'), 0, 0, ~0u},
     {HB_TAG('c', 'a', 'l', 't'), 0, 0, ~0u}}};

bool fits(const FT_BBox& box) {  // in 64ths of a pixel
    return (box.xMax - box.xMin) / 64 <= most_pixels && (box.yMax - box.yMin) / 64 <= most_pixels;
}

/// `left`, `top`: of the bitmap from the pen position, y up.
std::unique_ptr<Letter> letter_of(const FT_Bitmap& drawn, int left, int top, double size) {
    if (drawn.buffer == nullptr || drawn.width == 0 || drawn.rows == 0 ||
        drawn.width > most_pixels || drawn.rows > most_pixels)
        return nullptr;
    // A transparent pixel on each side, so that the rim of a turned letter is smooth.
    const unsigned wide = drawn.width + 2, high = drawn.rows + 2;
    std::vector<std::uint8_t> rgba;
    rgba.reserve(std::size_t{wide} * high * 4);
    for (unsigned y = 0; y < high; ++y)
        for (unsigned x = 0; x < wide; ++x) {
            const bool inside = x >= 1 && y >= 1 && x <= drawn.width && y <= drawn.rows;
            const Pixel p = inside ? pixel_of(drawn, x - 1, y - 1) : Pixel{};
            rgba.insert(rgba.end(), {p.red, p.green, p.blue, p.opacity});
        }
    auto made = std::make_unique<Letter>();
    made->picture.replace(wide, high, std::move(rgba));
    made->picture.keep_on_pixels();
    made->size = size;
    made->left = left - 1;
    made->top = -top - 1;
    made->colored = drawn.pixel_mode == FT_PIXEL_MODE_BGRA;
    return made;
}

}  // namespace

struct Font::Data {
    ~Data() {
        hb_buffer_destroy(buffer);
        hb_font_destroy(spacing);
        if (face != nullptr) FT_Done_Face(face);
        if (library != nullptr) FT_Done_FreeType(library);
    }
    void open_spacing(const std::string& file, int index);
    double kerning(char32_t first, char32_t second) const;  // in units of the font

    FT_Library library = nullptr;
    FT_Face face = nullptr;
    hb_font_t* spacing = nullptr;   // null for a font of pictures
    hb_buffer_t* buffer = nullptr;  // of the text that is shaped
};

void Font::Data::open_spacing(const std::string& file, int index) {
    hb_blob_t* const blob = hb_blob_create(file.data(), static_cast<unsigned>(file.size()),
                                           HB_MEMORY_MODE_READONLY, nullptr, nullptr);
    hb_face_t* const described = hb_face_create(blob, static_cast<unsigned>(index));
    spacing = hb_font_create(described);
    buffer = hb_buffer_create();
    hb_face_destroy(described);
    hb_blob_destroy(blob);
}

/// The two letters are set as a text: their width without the sum of their widths.
double Font::Data::kerning(char32_t first, char32_t second) const {
    const std::array<std::uint32_t, 2> letters = {first, second};
    hb_buffer_reset(buffer);
    hb_buffer_add_utf32(buffer, letters.data(), 2, 0, 2);
    hb_buffer_set_direction(buffer, HB_DIRECTION_LTR);
    hb_buffer_guess_segment_properties(buffer);
    hb_shape(spacing, buffer, without_ligatures.data(), without_ligatures.size());
    unsigned count = 0;
    const hb_glyph_info_t* const glyphs = hb_buffer_get_glyph_infos(buffer, &count);
    const hb_glyph_position_t* const places = hb_buffer_get_glyph_positions(buffer, &count);
    if (count != 2) return 0;
    double added = 0;
    for (unsigned i = 0; i < count; ++i)
        added += places[i].x_advance - hb_font_get_glyph_h_advance(spacing, glyphs[i].codepoint);
    return added;
}

Font::Font(std::string file, int index) : file_(std::move(file)), data_(std::make_unique<Data>()) {
    if (FT_Init_FreeType(&data_->library) != 0) throw std::runtime_error("cannot be read");
    const auto* bytes = reinterpret_cast<const FT_Byte*>(file_.data());
    if (FT_New_Memory_Face(data_->library, bytes, static_cast<FT_Long>(file_.size()), index,
                           &data_->face) != 0)
        throw std::runtime_error("is not a font (TTF or OTF)");
    const FT_Face face = data_->face;
    // As in other programs, the size is that of the em square.
    if (FT_IS_SCALABLE(face) && face->units_per_EM > 0) {
        unit_ = 1.0 / face->units_per_EM;
        ascent_ = unit_ * face->ascender;
        descent_ = -unit_ * face->descender;
        data_->open_spacing(file_, index);
        return;
    }
    // Emoji are pictures of a few sizes.
    if (FT_IS_SCALABLE(face) || face->num_fixed_sizes < 1 || FT_Select_Size(face, 0) != 0 ||
        face->size->metrics.y_ppem == 0)
        throw std::runtime_error("is not a font (TTF or OTF)");
    const FT_Size_Metrics& metrics = face->size->metrics;
    ascent_ = static_cast<double>(metrics.ascender) / 64 / metrics.y_ppem;
    descent_ = -static_cast<double>(metrics.descender) / 64 / metrics.y_ppem;
}

Font::~Font() = default;

bool Font::of_pictures() const {
    return FT_HAS_COLOR(data_->face) != 0;
}

const Font::Glyph& Font::known(char32_t letter) const {
    const auto [at, added] = glyphs_.try_emplace(letter, Glyph{});
    Glyph& found = at->second;
    if (!added) return found;
    const FT_Face face = data_->face;
    found.index = FT_Get_Char_Index(face, letter);
    FT_Fixed advance = 0;
    if (FT_IS_SCALABLE(face)) {
        if (FT_Get_Advance(face, found.index, FT_LOAD_NO_SCALE, &advance) == 0)
            found.advance = unit_ * static_cast<double>(advance);
    } else if (FT_Select_Size(face, 0) == 0 &&
               FT_Load_Glyph(face, found.index, FT_LOAD_COLOR) == 0) {
        found.advance =
            static_cast<double>(face->glyph->advance.x) / 64 / face->size->metrics.y_ppem;
    }
    return found;
}

double Font::kerning(char32_t first, char32_t second) const {
    if (data_->spacing == nullptr) return 0;
    const auto [at, added] =
        kernings_.try_emplace(std::uint64_t{first} << 32 | std::uint64_t{second}, 0.0);
    if (added) at->second = unit_ * data_->kerning(first, second);
    return at->second;
}

std::vector<ShapedGlyph> Font::shape(std::u32string_view text, const Run& run) const {
    std::vector<ShapedGlyph> made;
    if (data_->spacing == nullptr) {  // pictures are not joined
        for (std::size_t i = run.begin; i < run.end; ++i)
            made.push_back({.glyph = glyph(text[i]), .letter = i, .advance = advance(text[i])});
        if (run.right_to_left) std::reverse(made.begin(), made.end());
        return made;
    }
    hb_buffer_t* const buffer = data_->buffer;
    hb_buffer_reset(buffer);
    hb_buffer_add_utf32(buffer, reinterpret_cast<const std::uint32_t*>(text.data()),
                        static_cast<int>(text.size()), static_cast<unsigned>(run.begin),
                        static_cast<int>(run.end - run.begin));
    hb_buffer_set_direction(buffer, run.right_to_left ? HB_DIRECTION_RTL : HB_DIRECTION_LTR);
    hb_buffer_set_script(buffer, static_cast<hb_script_t>(run.script));
    const bool latin = run.script == HB_SCRIPT_LATIN;
    hb_shape(data_->spacing, buffer, without_ligatures.data(),
             latin ? unsigned{without_ligatures.size()} : 0);
    unsigned count = 0;
    const hb_glyph_info_t* const glyphs = hb_buffer_get_glyph_infos(buffer, &count);
    const hb_glyph_position_t* const places = hb_buffer_get_glyph_positions(buffer, &count);
    made.reserve(count);
    for (unsigned i = 0; i < count; ++i)
        made.push_back({.glyph = glyphs[i].codepoint,
                        .letter = glyphs[i].cluster,
                        .x = unit_ * places[i].x_offset,
                        .y = -unit_ * places[i].y_offset,
                        .advance = unit_ * places[i].x_advance});
    return made;
}

/// Sets the size in which letters are drawn next. Fonts of pictures have few sizes. Returns the
/// size that is set, or 0.
double Font::set_size(double size) const {
    const FT_Face face = data_->face;
    if (FT_IS_SCALABLE(face))
        return FT_Set_Char_Size(face, 0, std::lround(size * 64), 72, 72) == 0 ? size : 0;
    int best = -1;
    for (int i = 0; i < face->num_fixed_sizes; ++i)
        if (best < 0 ||
            std::abs(static_cast<double>(face->available_sizes[i].y_ppem) / 64 - size) <
                std::abs(static_cast<double>(face->available_sizes[best].y_ppem) / 64 - size))
            best = i;
    if (best < 0 || FT_Select_Size(face, best) != 0) return 0;
    return static_cast<double>(face->available_sizes[best].y_ppem) / 64;
}

std::unique_ptr<Letter> Font::draw(unsigned glyph, double wanted) const {
    const double size = set_size(wanted);
    if (!(size > 0)) return nullptr;
    const FT_GlyphSlot slot = data_->face->glyph;
    if (FT_Load_Glyph(data_->face, glyph, FT_LOAD_NO_HINTING | FT_LOAD_COLOR) != 0) return nullptr;
    if (slot->format == FT_GLYPH_FORMAT_OUTLINE) {
        FT_BBox box;
        FT_Outline_Get_CBox(&slot->outline, &box);
        if (!fits(box)) return nullptr;
    }
    if (slot->format != FT_GLYPH_FORMAT_BITMAP && FT_Render_Glyph(slot, FT_RENDER_MODE_NORMAL) != 0)
        return nullptr;
    return letter_of(slot->bitmap, slot->bitmap_left, slot->bitmap_top, size);
}

std::unique_ptr<Letter> Font::draw_outline(unsigned glyph, double wanted, double outline) const {
    const double size = set_size(wanted);
    const FT_GlyphSlot slot = data_->face->glyph;
    FT_Stroker stroker = nullptr;
    FT_Glyph line = nullptr;
    std::unique_ptr<Letter> made;
    if (size > 0 && FT_Load_Glyph(data_->face, glyph, FT_LOAD_NO_HINTING) == 0 &&
        slot->format == FT_GLYPH_FORMAT_OUTLINE && FT_Get_Glyph(slot, &line) == 0 &&
        FT_Stroker_New(data_->library, &stroker) == 0) {
        FT_Stroker_Set(stroker, std::lround(64 * outline * size), FT_STROKER_LINECAP_ROUND,
                       FT_STROKER_LINEJOIN_ROUND, 0);
        FT_BBox box{};
        if (FT_Glyph_Stroke(&line, stroker, 1) == 0)
            FT_Glyph_Get_CBox(line, FT_GLYPH_BBOX_UNSCALED, &box);
        if (fits(box) && FT_Glyph_To_Bitmap(&line, FT_RENDER_MODE_NORMAL, nullptr, 1) == 0) {
            const auto* drawn = reinterpret_cast<const FT_BitmapGlyphRec*>(line);
            made = letter_of(drawn->bitmap, drawn->left, drawn->top, size);
        }
    }
    FT_Stroker_Done(stroker);
    FT_Done_Glyph(line);
    return made;
}

const Letter* Font::letter(unsigned glyph, double size, double outline) {
    const double kept = kept_size(size);
    // 21 bits of the glyph, 11 of the outline.
    const auto wide = static_cast<std::uint64_t>(std::lround(1024 * std::clamp(outline, 0.0, 1.0)));
    const std::uint64_t key =
        std::uint64_t{glyph} << 43 | wide << 32 | static_cast<std::uint64_t>(std::lround(4 * kept));
    if (const auto found = letters_.find(key); found != letters_.end()) return found->second.get();
    if (letters_.size() >= most_letters) letters_.clear();
    auto& made = letters_[key];
    made =
        wide > 0 ? draw_outline(glyph, kept, static_cast<double>(wide) / 1024) : draw(glyph, kept);
    return made.get();
}

}  // namespace fettle::visuals
