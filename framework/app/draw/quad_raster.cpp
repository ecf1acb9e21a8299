#include <draw/quad_raster.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace fettle::app {

namespace {

// Two pixels with four channels of 16 bits each: red, green, blue, opacity.
using Channels = std::uint16_t __attribute__((vector_size(16)));
using SignedChannels = std::int16_t __attribute__((vector_size(16)));
using Bytes = std::uint8_t __attribute__((vector_size(16)));
using TwoPixels = std::uint8_t __attribute__((vector_size(8)));

// Parts of a texel. With more, a difference of two channels times a part would not fit in 16 bits.
constexpr int parts = 128;
constexpr int half = parts / 2;
constexpr int part_bits = 7;

SignedChannels widened(std::uint64_t two_pixels) {
    using Words = std::uint64_t __attribute__((vector_size(16)));
    const auto bytes = reinterpret_cast<Bytes>(Words{two_pixels, 0});
    static_assert(std::endian::native == std::endian::little);
    return reinterpret_cast<SignedChannels>(__builtin_shufflevector(
        bytes, Bytes{}, 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23));
}

/// Two pixels that follow one another in memory.
SignedChannels load(const std::uint8_t* from) {
    std::uint64_t two_pixels;
    std::memcpy(&two_pixels, from, 8);
    return widened(two_pixels);
}

/// The lower byte of each channel, which is one instruction. (With GCC, a shuffle of these bytes
/// moves each through memory.)
TwoPixels narrowed(Channels channels) {
    return __builtin_convertvector(channels, TwoPixels);
}

SignedChannels mixed(SignedChannels a, SignedChannels b, SignedChannels weight) {
    return a + (((b - a) * weight) >> part_bits);
}

SignedChannels all(std::int16_t value) {
    return SignedChannels{} + value;
}

/// A byte as a part of 256, so that products are divided by 256: 0 stays 0, 255 becomes 256. The
/// other ones become wrong by less than a half.
Channels part_of_256(Channels byte) {
    return byte + (byte >> 7);
}

/// Puts two pixels of the texture, multiplied by the tint, over those of the picture.
template <bool adds>
Channels put_over(Channels below, SignedChannels texture, Channels tint) {
    const Channels color = (reinterpret_cast<Channels>(texture) * tint + 128) >> 8;
    const Channels opacity =
        part_of_256(__builtin_shufflevector(color, color, 3, 3, 3, 3, 7, 7, 7, 7));
    constexpr Channels whole{0, 0, 0, 255, 0, 0, 0, 255};
    const Channels above = (color | whole) * opacity;
    if constexpr (!adds) return (above + below * (256 - opacity) + 128) >> 8;
    const Channels sum = below + ((above + 128) >> 8);
    return (sum | reinterpret_cast<Channels>(sum > 255)) & 255;
}

template <bool adds>
void put_two(std::uint8_t* to, SignedChannels texture, Channels tint) {
    const auto below = reinterpret_cast<Channels>(load(to));
    const TwoPixels bytes = narrowed(put_over<adds>(below, texture, tint));
    std::memcpy(to, &bytes, 8);
}

template <bool adds>
void put_one(std::uint8_t* to, SignedChannels texture, Channels tint) {
    std::uint32_t one;
    std::memcpy(&one, to, 4);
    const auto below = reinterpret_cast<Channels>(widened(one));
    const TwoPixels bytes = narrowed(put_over<adds>(below, texture, tint));
    std::memcpy(to, &bytes, 4);
}

SignedChannels first_of(SignedChannels a, SignedChannels b) {
    return __builtin_shufflevector(a, b, 0, 1, 2, 3, 8, 9, 10, 11);
}
SignedChannels second_of(SignedChannels a, SignedChannels b) {
    return __builtin_shufflevector(a, b, 4, 5, 6, 7, 12, 13, 14, 15);
}

/// A place along one side of a texture: between the texels `before` and `before + 1`.
struct Place {
    int before;
    std::int16_t weight;
};

Place place(float texel, int size, bool smooth) {
    const auto most = static_cast<float>((size - 1) * parts);
    const float wanted =
        smooth ? texel * parts - half : std::floor(texel) * static_cast<float>(parts);
    const int at = static_cast<int>(std::clamp(wanted, 0.0f, most));
    const int before = std::min(at >> part_bits, size - 2);
    return {before, static_cast<std::int16_t>(at - before * parts)};
}

using Four = float __attribute__((vector_size(16)));
using FourInts = std::int32_t __attribute__((vector_size(16)));

struct FourPlaces {
    FourInts before, weight;
};

/// The same for four texels.
FourPlaces places(Four texel, int size, bool smooth) {
    const Four most = Four{} + static_cast<float>((size - 1) * parts);
    Four wanted = texel * parts - half;
    if (!smooth) {
        const Four cut = __builtin_convertvector(__builtin_convertvector(texel, FourInts), Four);
        wanted = (cut > texel ? cut - 1 : cut) * parts;
    }
    wanted = wanted < 0 ? Four{} : wanted;
    wanted = wanted > most ? most : wanted;
    const FourInts at = __builtin_convertvector(wanted, FourInts);
    const FourInts last = FourInts{} + (size - 2);
    const FourInts part = at >> part_bits;
    const FourInts before = part > last ? last : part;
    return {before, at - before * parts};
}

/// The first pixel whose middle is not before `x`.
int first_from(float x, int lower, int upper) {
    const float inside = std::clamp(x - 0.5f, static_cast<float>(lower), static_cast<float>(upper));
    const int before = static_cast<int>(inside);
    return before + (static_cast<float>(before) < inside ? 1 : 0);
}

bool is_upright(const CanvasVertex* c) {
    return c[0].y == c[1].y && c[1].x == c[2].x && c[2].y == c[3].y && c[3].x == c[0].x;
}

/// Pixels of a row, from the first one to that after the last.
struct Row {
    int from, to;
};

int floor_of(float x) {
    const int cut = static_cast<int>(x);
    return cut - (static_cast<float>(cut) > x ? 1 : 0);
}

/// Leaves out pixels at which (x + 0.5 - origin) * slope + rest is not from 0 to 1, but none at
/// which rounding decides. `per_slope`: 1 / slope.
void narrow(Row& row, float per_slope, float rest, float origin) {
    constexpr float rounding = 0.01f, largest = 1e4f;
    if (!(std::abs(per_slope) < largest)) return;
    const float one = origin - 0.5f - rest * per_slope, other = one + per_slope;
    if (!(std::abs(one) < 1e5f && std::abs(other) < 1e5f)) return;
    row.from = std::max(row.from, floor_of(std::min(one, other) - rounding));
    row.to = std::min(row.to, floor_of(std::max(one, other) + rounding) + 1);
}

Channels tint_of(const CanvasVertex& c) {
    return part_of_256(Channels{c.r, c.g, c.b, c.a, c.r, c.g, c.b, c.a});
}

}  // namespace

void QuadRaster::measure(std::span<const CanvasVertex> corners, const PixelBox& clip) {
    float left = static_cast<float>(clip.right), right = static_cast<float>(clip.left);
    float top = static_cast<float>(clip.bottom), bottom = static_cast<float>(clip.top);
    area_ = 0;
    count_ = corners.size() / 4;
    for (std::size_t i = 0; i + 4 <= corners.size(); i += 4) {
        const CanvasVertex* const c = &corners[i];
        const float l = std::min(std::min(c[0].x, c[1].x), std::min(c[2].x, c[3].x));
        const float r = std::max(std::max(c[0].x, c[1].x), std::max(c[2].x, c[3].x));
        const float t = std::min(std::min(c[0].y, c[1].y), std::min(c[2].y, c[3].y));
        const float b = std::max(std::max(c[0].y, c[1].y), std::max(c[2].y, c[3].y));
        left = std::min(left, l);
        right = std::max(right, r);
        top = std::min(top, t);
        bottom = std::max(bottom, b);
        area_ += static_cast<double>((r - l) * (b - t));
    }
    box_.left = first_from(left, clip.left, clip.right);
    box_.right = std::max(box_.left, first_from(right, clip.left, clip.right));
    box_.top = first_from(top, clip.top, clip.bottom);
    box_.bottom = std::max(box_.top, first_from(bottom, clip.top, clip.bottom));
}

bool QuadRaster::is_faster() const {
    // ns
    constexpr double quad_there = 600, pixel_here = 4, pixel_of_box = 5;
    return static_cast<double>(count_) * quad_there >
           area_ * pixel_here + pixel_of_box * box_.width() * box_.height();
}

void QuadRaster::draw(std::span<const CanvasVertex> corners, const TexelRows& texels, bool adds) {
    texels_ = texels;
    const std::size_t wide = static_cast<std::size_t>(box_.width());
    pixels_.assign(wide * static_cast<std::size_t>(box_.height()) * 4, 0);
    columns_.resize(wide + 1);
    spots_.resize(wide + 4);
    adds ? draw_all<true>(corners) : draw_all<false>(corners);
}

template <bool adds>
void QuadRaster::draw_all(std::span<const CanvasVertex> corners) {
    for (std::size_t i = 0; i + 4 <= corners.size(); i += 4)
        is_upright(&corners[i]) ? draw_upright<adds>(&corners[i]) : draw_turned<adds>(&corners[i]);
}

template <bool adds>
void QuadRaster::draw_upright(const CanvasVertex* c) {
    const CanvasVertex& a = c[0];
    const CanvasVertex& b = c[2];
    const int left = first_from(std::min(a.x, b.x), box_.left, box_.right);
    const int right = first_from(std::max(a.x, b.x), box_.left, box_.right);
    const int top = first_from(std::min(a.y, b.y), box_.top, box_.bottom);
    const int bottom = first_from(std::max(a.y, b.y), box_.top, box_.bottom);
    const int count = right - left;
    if (count <= 0 || bottom <= top) return;
    const float across = (b.u - a.u) / (b.x - a.x), down = (b.v - a.v) / (b.y - a.y);
    for (int i = 0; i < count; ++i) {
        const float u = a.u + (static_cast<float>(left + i) + 0.5f - a.x) * across;
        const Place at = place(u, texels_.width, texels_.smooth);
        columns_[static_cast<std::size_t>(i)] = {4 * at.before, at.weight};
    }
    const Channels tint = tint_of(a);
    const auto stride = static_cast<std::ptrdiff_t>(box_.width()) * 4;
    std::uint8_t* to = pixels_.data() + (top - box_.top) * stride + 4 * (left - box_.left);
    for (int y = top; y < bottom; ++y, to += stride) {
        const float v = a.v + (static_cast<float>(y) + 0.5f - a.y) * down;
        const Place at = place(v, texels_.height, texels_.smooth);
        const std::ptrdiff_t length = texels_.row_length();
        const std::uint8_t* const upper = texels_.rgba + at.before * length;
        const std::uint8_t* const lower = upper + length;
        const SignedChannels weight = all(at.weight);
        const auto texture = [&](const Column& column) {
            return mixed(load(upper + column.offset), load(lower + column.offset), weight);
        };
        int i = 0;
        for (; i + 1 < count; i += 2) {
            const Column& one = columns_[static_cast<std::size_t>(i)];
            const Column& two = columns_[static_cast<std::size_t>(i) + 1];
            const SignedChannels first = texture(one), second = texture(two);
            const SignedChannels weights = first_of(all(one.weight), all(two.weight));
            put_two<adds>(to + 4 * i,
                          mixed(first_of(first, second), second_of(first, second), weights), tint);
        }
        if (i < count) {
            const Column& last = columns_[static_cast<std::size_t>(i)];
            const SignedChannels found = texture(last);
            put_one<adds>(to + 4 * i, mixed(found, second_of(found, found), all(last.weight)),
                          tint);
        }
    }
}

template <bool adds>
void QuadRaster::draw_turned(const CanvasVertex* c) {
    // A point of the quad is c[0] + s * across + t * down.
    const float across_x = c[1].x - c[0].x, across_y = c[1].y - c[0].y;
    const float down_x = c[3].x - c[0].x, down_y = c[3].y - c[0].y;
    const float area = across_x * down_y - across_y * down_x;
    if (!(std::abs(area) > 1e-6f)) return;
    const auto [left_x, right_x] = std::minmax({c[0].x, c[1].x, c[2].x, c[3].x});
    const auto [top_y, bottom_y] = std::minmax({c[0].y, c[1].y, c[2].y, c[3].y});
    const int left = first_from(left_x, box_.left, box_.right);
    const int right = first_from(right_x, box_.left, box_.right);
    const int top = first_from(top_y, box_.top, box_.bottom);
    const int bottom = first_from(bottom_y, box_.top, box_.bottom);
    const float s_x = down_y / area, s_y = -down_x / area;
    const float t_x = -across_y / area, t_y = across_x / area;
    const float per_s = 1 / s_x, per_t = 1 / t_x;
    const float wide = c[1].u - c[0].u, high = c[3].v - c[0].v;
    const Channels tint = tint_of(c[0]);
    const auto stride = static_cast<std::ptrdiff_t>(box_.width()) * 4;
    const std::ptrdiff_t length = texels_.row_length();
    for (int y = top; y < bottom; ++y) {
        const float below = static_cast<float>(y) + 0.5f - c[0].y;
        const auto s_at = [&](int x) {
            return (static_cast<float>(x) + 0.5f - c[0].x) * s_x + below * s_y;
        };
        const auto t_at = [&](int x) {
            return (static_cast<float>(x) + 0.5f - c[0].x) * t_x + below * t_y;
        };
        const auto is_inside = [&](int x) {
            const float s = s_at(x), t = t_at(x);
            return s >= 0 && s < 1 && t >= 0 && t < 1;
        };
        // s and t rise or fall along a row, so the pixels inside are neighbors.
        Row inside{left, right};
        narrow(inside, per_s, below * s_y, c[0].x);
        narrow(inside, per_t, below * t_y, c[0].x);
        while (inside.from < inside.to && !is_inside(inside.from)) ++inside.from;
        while (inside.from < inside.to && !is_inside(inside.to - 1)) --inside.to;
        if (inside.from >= inside.to) continue;
        for (int x = inside.from; x < inside.to; x += 4) {
            const Four beside = Four{0, 1, 2, 3} + (static_cast<float>(x) + 0.5f) - c[0].x;
            const FourPlaces u =
                places(c[0].u + (beside * s_x + below * s_y) * wide, texels_.width, texels_.smooth);
            const FourPlaces v = places(c[0].v + (beside * t_x + below * t_y) * high,
                                        texels_.height, texels_.smooth);
            const FourInts offsets = v.before * static_cast<int>(length) + u.before * 4;
            for (int k = 0; k < 4; ++k)
                spots_[static_cast<std::size_t>(x - inside.from) + static_cast<std::size_t>(k)] = {
                    offsets[k], static_cast<std::int16_t>(u.weight[k]),
                    static_cast<std::int16_t>(v.weight[k])};
        }
        std::uint8_t* to = pixels_.data() + (y - box_.top) * stride + 4 * (inside.from - box_.left);
        const auto texture = [&](const Spot& spot) {
            const std::uint8_t* const upper = texels_.rgba + spot.offset;
            return mixed(load(upper), load(upper + length), all(spot.down));
        };
        const Spot* spot = spots_.data();
        int left_over = inside.to - inside.from;
        for (; left_over > 1; left_over -= 2, spot += 2, to += 8) {
            const SignedChannels first = texture(spot[0]), second = texture(spot[1]);
            put_two<adds>(to,
                          mixed(first_of(first, second), second_of(first, second),
                                first_of(all(spot[0].across), all(spot[1].across))),
                          tint);
        }
        if (left_over > 0) {
            const SignedChannels found = texture(*spot);
            put_one<adds>(to, mixed(found, second_of(found, found), all(spot->across)), tint);
        }
    }
}

}  // namespace fettle::app
