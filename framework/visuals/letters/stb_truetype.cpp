// Reads fonts with stb_truetype. Its code is in this source only.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <utility>
#include <vector>

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb/stb_truetype.h>

#include <letters/font.h>

namespace fettle::visuals {
namespace {

constexpr std::size_t most_letters = 4000;  // pictures that a font keeps
constexpr double largest = 256;             // px; larger letters are enlarged pictures of this size

/// Few sizes for large letters, whose difference is not visible.
double kept_size(double size) {
    const double step = size < 24 ? 0.25 : size < 64 ? 0.5 : 1;
    return std::clamp(step * std::round(size / step), 1.0, largest);
}

}  // namespace

struct Font::Data {
    stbtt_fontinfo info{};
};

Font::Font(std::string file) : file_(std::move(file)), data_(std::make_unique<Data>()) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(file_.data());
    const int offset = file_.size() < 12 ? -1 : stbtt_GetFontOffsetForIndex(bytes, 0);
    if (offset < 0 || stbtt_InitFont(&data_->info, bytes, offset) == 0)
        throw std::runtime_error("is no font (TTF or OTF)");
    // As in other programs, the size is that of the em square.
    unit_ = static_cast<double>(stbtt_ScaleForMappingEmToPixels(&data_->info, 1));
    int ascent = 0, descent = 0, gap = 0;
    stbtt_GetFontVMetrics(&data_->info, &ascent, &descent, &gap);
    ascent_ = unit_ * ascent;
    descent_ = -unit_ * descent;
}

Font::~Font() = default;

int Font::glyph(char32_t letter) const {
    const auto [at, added] = glyphs_.try_emplace(letter, 0);
    if (added) at->second = stbtt_FindGlyphIndex(&data_->info, static_cast<int>(letter));
    return at->second;
}

bool Font::has(char32_t letter) const {
    return glyph(letter) != 0;
}

double Font::advance(char32_t letter) const {
    int advance = 0;
    stbtt_GetGlyphHMetrics(&data_->info, glyph(letter), &advance, nullptr);
    return unit_ * advance;
}

double Font::kerning(char32_t first, char32_t second) const {
    return unit_ * stbtt_GetGlyphKernAdvance(&data_->info, glyph(first), glyph(second));
}

const Letter* Font::letter(char32_t letter, double size) {
    const double kept = kept_size(size);
    const std::uint64_t key =
        std::uint64_t{letter} << 32 | static_cast<std::uint64_t>(std::lround(4 * kept));
    if (const auto found = letters_.find(key); found != letters_.end()) return found->second.get();
    if (letters_.size() >= most_letters) letters_.clear();
    auto& made = letters_[key];
    const float scale = stbtt_ScaleForMappingEmToPixels(&data_->info, static_cast<float>(kept));
    int width = 0, height = 0, left = 0, top = 0;
    unsigned char* const drawn = stbtt_GetGlyphBitmap(&data_->info, scale, scale, glyph(letter),
                                                      &width, &height, &left, &top);
    if (drawn == nullptr || width <= 0 || height <= 0) {
        stbtt_FreeBitmap(drawn, nullptr);
        return nullptr;
    }
    // A transparent pixel on each side, so that the rim of a turned letter is smooth.
    const auto wide = static_cast<std::size_t>(width), high = static_cast<std::size_t>(height);
    std::vector<std::uint8_t> rgba((wide + 2) * (high + 2) * 4, 255);
    for (std::size_t y = 0; y < high + 2; ++y)
        for (std::size_t x = 0; x < wide + 2; ++x) {
            const bool inside = x >= 1 && y >= 1 && x <= wide && y <= high;
            rgba[4 * (y * (wide + 2) + x) + 3] =
                inside ? drawn[(y - 1) * wide + (x - 1)] : std::uint8_t{0};
        }
    stbtt_FreeBitmap(drawn, nullptr);
    made = std::make_unique<Letter>();
    made->picture.replace(static_cast<std::uint32_t>(wide + 2),
                          static_cast<std::uint32_t>(high + 2), std::move(rgba));
    made->picture.keep_on_pixels();
    made->size = kept;
    made->left = left - 1;
    made->top = top - 1;
    return made.get();
}

}  // namespace fettle::visuals
