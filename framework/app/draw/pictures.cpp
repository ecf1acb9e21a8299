#include <draw/pictures.h>

#include <algorithm>
#include <cmath>

#include <draw/canvas.h>

namespace fettle::app {

using property::Color;
using property::Picture;
using property::PictureArea;
using property::Vec2;

namespace {

constexpr unsigned page_side = 2048;  // texels
// Between rows of the copy of a page. Without it, texels above one another are 8192 bytes apart,
// and the processor's cache can keep only a few of them: particles then take a seventh longer.
constexpr unsigned gap = 16;
constexpr std::size_t row_of_copy = std::size_t{page_side + gap} * 4;  // bytes
constexpr std::size_t most_pages = 8;
constexpr unsigned largest_on_page = 256;     // px; larger pictures have textures of their own
constexpr std::uint64_t unused_frames = 600;  // after which a texture is freed

bool is_smooth(Pictures::Kind kind) {
    return kind == Pictures::Kind::smooth || kind == Pictures::Kind::smooth_multiplied;
}

bool is_multiplied(Pictures::Kind kind) {
    return kind == Pictures::Kind::sharp_multiplied || kind == Pictures::Kind::smooth_multiplied;
}

std::vector<std::uint8_t> multiplied(std::vector<std::uint8_t> rgba) {
    for (std::size_t i = 0; i + 3 < rgba.size(); i += 4)
        for (std::size_t c = 0; c < 3; ++c)
            rgba[i + c] = static_cast<std::uint8_t>((rgba[i + c] * rgba[i + 3] + 127) / 255);
    return rgba;
}

/// The pixels with a copy of the outermost ones around them, so that filtering at the edge does not
/// mix in the neighbors on a page.
std::vector<std::uint8_t> with_edge(const Picture& picture, const std::vector<std::uint8_t>& rgba) {
    const std::size_t width = picture.width(), height = picture.height();
    std::vector<std::uint8_t> out((width + 2) * (height + 2) * 4);
    for (std::size_t y = 0; y < height + 2; ++y) {
        const std::size_t from_y = std::clamp<std::size_t>(y, 1, height) - 1;
        for (std::size_t x = 0; x < width + 2; ++x) {
            const std::size_t from_x = std::clamp<std::size_t>(x, 1, width) - 1;
            std::copy_n(rgba.begin() + static_cast<std::ptrdiff_t>(4 * (from_y * width + from_x)),
                        4, out.begin() + static_cast<std::ptrdiff_t>(4 * (y * (width + 2) + x)));
        }
    }
    return out;
}

/// Whether the area is drawn upright and in its own size. `corners`: top left, top right, bottom
/// left, bottom right, in pixels.
bool is_upright(const Vec2 (&corners)[4], const PictureArea& area) {
    constexpr double same = 0.02;  // px
    const Vec2 across = corners[1] - corners[0], down = corners[2] - corners[0];
    return std::abs(across.y) < same && std::abs(down.x) < same &&
           std::abs(across.x - area.width) < 0.5 && std::abs(down.y - area.height) < 0.5;
}

/// From where to where the texels of an area are drawn, along one side of it.
struct Texels {
    float begin = 0, end = 0;
};

/// Texels beside the area must not be mixed in.
Texels texels(double begin, double size, std::uint32_t whole, bool smooth) {
    // A whole picture has copies of its outermost texels around it.
    const bool all = begin <= 0 && begin + size >= static_cast<double>(whole);
    const double margin = all ? 0 : std::min(smooth ? 0.5 : 1.0 / 2048, 0.5 * size);
    return {static_cast<float>(begin + margin), static_cast<float>(begin + size - margin)};
}

}  // namespace

Pictures::Entry& Pictures::entry_of(const Key& key) {
    if (last_ == nullptr || key != last_key_) {
        last_key_ = key;
        last_ = &entries_[key];
    }
    return *last_;
}

void Pictures::begin_frame() {
    ++frame_;
    last_ = nullptr;
    if (pages_are_full_) {  // removes unused pictures; those in use are copied again
        std::erase_if(entries_, [](const auto& entry) { return entry.second.own == nullptr; });
        pages_.clear();
        pages_are_full_ = false;
    }
    if (frame_ % unused_frames == 0)
        std::erase_if(entries_, [this](const auto& entry) {
            return entry.second.own != nullptr && entry.second.used + unused_frames < frame_;
        });
}

bool Pictures::has_white(const sf::Texture* texture) const {
    return texture != nullptr && std::any_of(pages_.begin(), pages_.end(), [&](const auto& page) {
               return page->texture.get() == texture;
           });
}

Pictures::Place Pictures::place(const Picture& picture, bool smooth, bool is_premultiplied) {
    const Kind kind = is_premultiplied ? smooth ? Kind::smooth_multiplied : Kind::sharp_multiplied
                      : smooth         ? Kind::smooth
                                       : Kind::sharp;
    Entry& entry = entry_of({&picture, kind});
    entry.used = frame_;
    if (entry.version == picture.version()) return entry.place;
    entry.version = picture.version();
    entry.own = nullptr;
    entry.place = {};
    if (picture.width() == 0 || picture.height() == 0) return entry.place;
    if (std::max(picture.width(), picture.height()) <= largest_on_page)
        if (const auto on_page = put_on_page(picture, kind)) return entry.place = *on_page;
    const unsigned most = sf::Texture::getMaximumSize();
    if (picture.width() > most || picture.height() > most) return entry.place;
    auto texture = std::make_unique<sf::Texture>();
    if (!sfml::create(*texture, picture.width(), picture.height())) return entry.place;
    texture->setSmooth(smooth);
    if (is_premultiplied)
        sfml::update(*texture, multiplied(picture.rgba()).data(), picture.width(), picture.height(),
                     0, 0);
    else
        sfml::update(*texture, picture.rgba().data(), picture.width(), picture.height(), 0, 0);
    entry.place.texture = texture.get();
    entry.own = std::move(texture);
    return entry.place;
}

std::optional<Pictures::Place> Pictures::put_on_page(const Picture& picture, Kind kind) {
    for (const auto& page : pages_)
        if (page->kind == kind)
            if (const auto place = put(*page, picture)) return place;
    if (pages_.size() >= most_pages) {
        pages_are_full_ = true;
        return std::nullopt;
    }
    Page* const page = add_page(kind);
    return page == nullptr ? std::nullopt : put(*page, picture);
}

Pictures::Page* Pictures::add_page(Kind kind) {
    auto page = std::make_unique<Page>();
    page->kind = kind;
    page->texture = std::make_unique<sf::Texture>();
    if (!sfml::create(*page->texture, page_side, page_side)) return nullptr;
    page->texture->setSmooth(is_smooth(kind));
    constexpr unsigned side = 4;  // as in the atlas
    const std::vector<std::uint8_t> white(std::size_t{side} * side * 4, 255);
    write(*page, white, side, side, 0, 0);
    page->x = side + 1;
    page->height = side + 1;
    return pages_.emplace_back(std::move(page)).get();
}

std::optional<Pictures::Place> Pictures::put(Page& page, const Picture& picture) const {
    const unsigned width = picture.width() + 2, height = picture.height() + 2;
    if (page.x + width > page_side) {
        page.y += page.height;
        page.x = page.height = 0;
    }
    if (page.y + height > page_side) return std::nullopt;
    const std::vector<std::uint8_t> pixels =
        with_edge(picture, is_multiplied(page.kind) ? multiplied(picture.rgba()) : picture.rgba());
    write(page, pixels, width, height, page.x, page.y);
    const Place place{page.texture.get(), static_cast<float>(page.x + 1),
                      static_cast<float>(page.y + 1)};
    page.x += width;
    page.height = std::max(page.height, height);
    return place;
}

void Pictures::write(Page& page, const std::vector<std::uint8_t>& rgba, unsigned width,
                     unsigned height, unsigned x, unsigned y) const {
    sfml::update(*page.texture, rgba.data(), width, height, x, y);
    if (!keeps_texels_) return;
    if (page.texels.size() < (y + height) * row_of_copy)
        page.texels.resize((y + height) * row_of_copy);
    for (std::size_t i = 0; i < height; ++i)
        std::copy_n(
            rgba.begin() + static_cast<std::ptrdiff_t>(i * width * 4), width * 4,
            page.texels.begin() + static_cast<std::ptrdiff_t>((y + i) * row_of_copy + x * 4));
}

TexelRows Pictures::texels(const sf::Texture& texture) const {
    for (const auto& page : pages_)
        if (page->texture.get() == &texture && !page->texels.empty())
            return {page->texels.data(), page_side,
                    static_cast<int>(page->texels.size() / row_of_copy), is_smooth(page->kind),
                    gap};
    return {};
}

// --- Drawing -------------------------------------------------------------------------------------

void Canvas::picture(const Picture& picture, const PictureArea& area, const Vec2& lower,
                     const Vec2& upper, Color tint, bool smooth) {
    draw_collected();
    // On the screen, y points down.
    const double top = state().on_screen ? lower.y : upper.y;
    const double bottom = state().on_screen ? upper.y : lower.y;
    const property::Transform& place_of = to_pixels();
    Vec2 corners[] = {place_of({lower.x, top}), place_of({upper.x, top}),
                      place_of({lower.x, bottom}), place_of({upper.x, bottom})};
    if (picture.on_pixels() && is_upright(corners, area)) {
        const Vec2 to_pixels =
            Vec2(std::round(corners[0].x), std::round(corners[0].y)) - corners[0];
        for (Vec2& corner : corners) corner += to_pixels;
    }
    // With round numbers, the middle of a pixel of the screen is often exactly between two texels,
    // or two tiles. Without this, rounding errors decide which it shows, and rows of pixels are
    // uneven.
    constexpr double off_the_middle = 1.0 / 64;  // px
    if (!smooth)
        for (Vec2& corner : corners) corner += Vec2(off_the_middle, off_the_middle);
    Vec2 from = corners[0], to = from;
    for (const Vec2& corner : corners) {
        if (!is_finite(corner)) return;
        from = from.min(corner);
        to = to.max(corner);
    }
    if (outside(from, to)) return;
    const bool multiplies = state().blend == property::Blend::multiply;
    const Pictures::Place place = pictures_.place(picture, smooth, multiplies);
    if (place.texture == nullptr) return;
    const sf::Color color = native(faded(tint));
    const Texels across = texels(area.left, area.width, picture.width(), smooth);
    const Texels down = texels(area.top, area.height, picture.height(), smooth);
    const float left = place.left + across.begin, right = place.left + across.end;
    const float high = place.top + down.begin, low = place.top + down.end;
    const auto vertex = [&](const Vec2& p, float u, float v) {
        return CanvasVertex{static_cast<float>(p.x),
                            static_cast<float>(p.y),
                            color.r,
                            color.g,
                            color.b,
                            color.a,
                            u,
                            v};
    };
    add_quad({vertex(corners[0], left, high), vertex(corners[1], right, high),
              vertex(corners[2], left, low), vertex(corners[3], right, low)},
             *place.texture);
}

}  // namespace fettle::app
