#include <draw/shade.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace fettle::app {

using property::Color;
using property::Gradient;
using property::Vec2;

namespace {

constexpr unsigned strip = 256, side = 128;  // texels of linear and radial gradients

std::uint8_t byte_of(float share) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0f, 1.0f)));
}

/// `at`: 0 to 1.
void put_color(std::vector<std::uint8_t>& rgba, const std::vector<Color>& colors, double at) {
    const double place = std::clamp(at, 0.0, 1.0) * static_cast<double>(colors.size() - 1);
    const auto first = std::min(static_cast<std::size_t>(place), colors.size() - 2);
    const auto share = static_cast<float>(place - static_cast<double>(first));
    const Color &a = colors[first], &b = colors[first + 1];
    const auto mixed = [&](float from, float to) { return byte_of(from + share * (to - from)); };
    rgba.insert(rgba.end(), {mixed(a.r, b.r), mixed(a.g, b.g), mixed(a.b, b.b), mixed(a.a, b.a)});
}

/// The middle of the first texel is at 0, that of the last one at 1; radial from the center.
std::vector<std::uint8_t> texels(const Gradient& of) {
    std::vector<std::uint8_t> rgba;
    if (!of.radial)
        for (unsigned x = 0; x < strip; ++x)
            put_color(rgba, of.colors, static_cast<double>(x) / (strip - 1));
    else
        for (unsigned y = 0; y < side; ++y)
            for (unsigned x = 0; x < side; ++x) {
                const double radius = 0.5 * (side - 1);
                put_color(rgba, of.colors, std::hypot(x - radius, y - radius) / radius);
            }
    return rgba;
}

std::string key_of(const Gradient& of) {
    std::string key(of.radial ? "r" : "l");
    for (const Color& c : of.colors)
        for (const float channel : {c.r, c.g, c.b, c.a}) key += static_cast<char>(byte_of(channel));
    return key;
}

}  // namespace

bool Shade::begin(const Gradient& placed, const Vec2& across) {
    const Vec2 a = placed.to - placed.from, b = across - placed.from;
    const double determinant = a.x * b.y - a.y * b.x;
    if (!std::isfinite(determinant) || std::abs(determinant) < 1e-12 || placed.colors.size() < 2)
        return false;
    if (full()) known_.clear();
    const auto [at, added] = known_.try_emplace(key_of(placed));
    const unsigned width = placed.radial ? side : strip, height = placed.radial ? side : 1;
    if (added) {
        if (!sfml::create(at->second, width, height)) {
            known_.erase(at);
            return false;
        }
        at->second.setSmooth(true);
        sfml::update(at->second, texels(placed).data(), width, height, 0, 0);
    }
    // A pixel is `from` + s * a + t * b.
    const Vec2 s(b.y / determinant, -b.x / determinant);
    const Vec2 t(-a.y / determinant, a.x / determinant);
    const double s0 = -s.dot(placed.from), t0 = -t.dot(placed.from);
    if (placed.radial) {
        const double radius = 0.5 * (side - 1), middle = 0.5 * side;
        origin_ = {middle + radius * s0, middle + radius * t0};
        x_ = {radius * s.x, radius * t.x};
        y_ = {radius * s.y, radius * t.y};
    } else {
        origin_ = {0.5 + (strip - 1) * s0, 0.5};
        x_ = {(strip - 1) * s.x, 0};
        y_ = {(strip - 1) * s.y, 0};
    }
    texture_ = &at->second;
    return true;
}

sf::Vector2f Shade::texel(sf::Vector2f pixel) const {
    const Vec2 at = origin_ + static_cast<double>(pixel.x) * x_ + static_cast<double>(pixel.y) * y_;
    return {static_cast<float>(at.x), static_cast<float>(at.y)};
}

}  // namespace fettle::app
