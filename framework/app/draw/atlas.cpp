#include <draw/atlas.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <fettle/property/storage/font_files.h>

namespace fettle::app {

namespace {

constexpr std::size_t channels = 4;
constexpr std::size_t border = 1;  // texels around a patch

/// Pixels of a patch with its border, all of them transparent white, so that filtering does not
/// darken the rim.
struct PatchPixels {
    std::size_t width, height;  // without the border
    std::vector<std::uint8_t> all;

    PatchPixels(std::size_t w, std::size_t h)
        : width(w), height(h), all((w + 2 * border) * (h + 2 * border) * channels) {
        for (std::size_t i = 0; i < all.size(); i += channels) std::fill_n(&all[i], 3, 255);
    }
    std::uint8_t* at(std::size_t x, std::size_t y) {
        return &all[((y + border) * (width + 2 * border) + x + border) * channels];
    }
};

}  // namespace

Atlas::Atlas() {
    if (!sfml::create(texture_, side, side))
        throw std::runtime_error("the graphics system has no textures of 1024 x 1024");
    texture_.setSmooth(true);
    const std::vector<std::uint8_t> opaque(white_side * white_side * channels, 255);
    sfml::update(texture_, opaque.data(), white_side, white_side, 0, 0);
    shelf_ = {white_side, 0, white_side};
    draw_discs();
    glyphs_from_ = shelf_.y + shelf_.height;
    clear_glyphs();
    load_fonts();
}

void Atlas::draw_discs() {
    // Radii grow by 6 %, so a disc is scaled down by less than that and its rim stays sharp.
    std::vector<float> radii;
    for (float radius = 0.75f; radius < largest_disc; radius *= 1.06f) radii.push_back(radius);
    radii.push_back(largest_disc);
    for (const float radius : radii) {
        const unsigned width = 2 * static_cast<unsigned>(std::ceil(radius + 1));
        PatchPixels pixels(width, width);
        const float middle = 0.5f * static_cast<float>(width);
        for (unsigned y = 0; y < width; ++y) {
            for (unsigned x = 0; x < width; ++x) {
                const float distance = std::hypot(static_cast<float>(x) + 0.5f - middle,
                                                  static_cast<float>(y) + 0.5f - middle);
                const float opacity = std::clamp(radius + 0.5f - distance, 0.0f, 1.0f);
                pixels.at(x, y)[3] = static_cast<std::uint8_t>(std::lround(255 * opacity));
            }
        }
        const Patch patch = place(width, width).value();
        write(patch, pixels.all);
        discs_.push_back({radius, patch});
    }
}

/// `pixels`: those of the patch and of its border.
void Atlas::write(const Patch& patch, const std::vector<std::uint8_t>& pixels) {
    const auto texels = [](float length) { return static_cast<unsigned>(length); };
    sfml::update(texture_, pixels.data(), texels(patch.width) + 2 * border,
                 texels(patch.height) + 2 * border, texels(patch.left) - border,
                 texels(patch.top) - border);
}

const Disc& Atlas::disc(float radius) const {
    const auto found =
        std::lower_bound(discs_.begin(), discs_.end(), radius,
                         [](const Disc& disc, float wanted) { return disc.radius < wanted; });
    return found == discs_.end() ? discs_.back() : *found;
}

std::optional<Patch> Atlas::place(unsigned width, unsigned height) {
    const unsigned wide = width + 2 * border, high = height + 2 * border;
    if (shelf_.x + wide > side) {
        shelf_.y += shelf_.height;
        shelf_.x = shelf_.height = 0;
    }
    if (wide > side || shelf_.y + high > side) return std::nullopt;
    const Patch patch{static_cast<float>(shelf_.x + border), static_cast<float>(shelf_.y + border),
                      static_cast<float>(width), static_cast<float>(height)};
    shelf_.x += wide;
    shelf_.height = std::max(shelf_.height, high);
    return patch;
}

void Atlas::load_fonts() {
    static constexpr std::array<const char*, 3> files{"DejaVuSans.ttf", "DejaVuSans-Bold.ttf",
                                                      "DejaVuSansMono.ttf"};
    for (std::size_t i = 0; i < files.size(); ++i) {
        auto font = std::make_unique<sf::Font>();
        const std::string file = property::font_file(files[i]);
        if (!file.empty() && sfml::load(*font, file)) fonts_[i] = std::move(font);
    }
}

const sf::Font* Atlas::font(Face face) const {
    const sf::Font* wanted = fonts_[static_cast<std::size_t>(face)].get();
    if (wanted != nullptr) return wanted;
    for (const auto& any : fonts_)
        if (any) return any.get();
    return nullptr;
}

namespace {

/// Whether the font has a glyph of its own for the character, and not that of all missing ones.
bool has_glyph(const sf::Font& font, char32_t character, unsigned size) {
    constexpr char32_t never = 0xffff;  // no character
    const sf::Glyph& missing = font.getGlyph(never, size, false);
    const sf::Glyph& found = font.getGlyph(character, size, false);
    return found.advance != missing.advance || found.bounds != missing.bounds;
}

}  // namespace

const sf::Font& Atlas::font_with(char32_t character, unsigned size, Face face) {
    const sf::Font& usual = *font(face);
    if (character < 0x80 || has_glyph(usual, character, size)) return usual;
    if (!fallbacks_) {
        fallbacks_.emplace();
        for (const char* const name : property::fallback_fonts) {
            auto other = std::make_unique<sf::Font>();
            const std::string file = property::font_file(name);
            if (!file.empty() && sfml::load(*other, file)) fallbacks_->push_back(std::move(other));
        }
    }
    for (const auto& other : *fallbacks_)
        if (has_glyph(*other, character, size)) return *other;
    return usual;
}

bool Atlas::has_font(Face face) const {
    return font(face) != nullptr;
}

std::uint64_t Atlas::key(char32_t character, unsigned size, Face face) {
    return std::uint64_t{character} | std::uint64_t{size} << 32 |
           static_cast<std::uint64_t>(face) << 48;
}

bool Atlas::prepare(const std::u32string& line, unsigned size, Face face) {
    std::map<char32_t, const sf::Font*> missing;
    for (const char32_t c : line)
        if (!glyphs_.contains(key(c, size, face))) missing.emplace(c, &font_with(c, size, face));
    // A font draws into its own texture for each size; each glyph is copied from there once.
    std::map<const sf::Font*, sf::Image> images;
    for (const auto& [c, source] : missing) {
        (void)source->getGlyph(c, size, false);
        images.try_emplace(source);
    }
    for (auto& [source, image] : images) image = source->getTexture(size).copyToImage();
    for (const auto& [c, source] : missing) {
        const sf::Image& image = images.at(source);
        const std::uint8_t* from = image.getPixelsPtr();
        const sf::Glyph& drawn = source->getGlyph(c, size, false);
        Glyph glyph{sfml::left(drawn.bounds), sfml::top(drawn.bounds), drawn.advance};
        const auto width = static_cast<unsigned>(sfml::width(drawn.textureRect));
        const auto height = static_cast<unsigned>(sfml::height(drawn.textureRect));
        if (width > 0 && height > 0) {
            const std::optional<Patch> patch = place(width, height);
            if (!patch) return false;
            PatchPixels pixels(width, height);
            for (unsigned y = 0; y < height; ++y) {
                const std::size_t row =
                    (static_cast<std::size_t>(sfml::top(drawn.textureRect)) + y) *
                        image.getSize().x +
                    static_cast<std::size_t>(sfml::left(drawn.textureRect));
                std::copy_n(from + channels * row, channels * width, pixels.at(0, y));
            }
            write(*patch, pixels.all);
            glyph.patch = *patch;
        }
        glyphs_.emplace(key(c, size, face), glyph);
    }
    return true;
}

const Glyph& Atlas::glyph(char32_t character, unsigned size, Face face) const {
    return glyphs_.at(key(character, size, face));
}

float Atlas::kerning(char32_t first, char32_t second, unsigned size, Face face) const {
    return face == Face::monospace ? 0 : font(face)->getKerning(first, second, size);
}

float Atlas::ascent(unsigned size, Face face) const {
    // DejaVu's capitals are 0.73 em high and its descenders 0.24 em deep; SFML provides neither.
    (void)face;
    return std::round(0.93f * static_cast<float>(size));
}

void Atlas::clear_glyphs() {
    glyphs_.clear();
    shelf_ = {0, glyphs_from_, 0};
}

}  // namespace fettle::app
