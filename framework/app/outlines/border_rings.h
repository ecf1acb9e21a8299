#pragma once
// The border of a figure that is not convex: rings at given depths inside its outline. Each ring
// has one color; between two rings the color changes linearly.

#include <array>
#include <cstddef>

#include <fettle/property/painter.h>

#include <outlines/outline.h>
#include <sfml/sfml.h>

namespace fettle::app {

/// Converts a color to SFML's type.
sf::Color native(property::Color color, float opacity = 1);

inline sf::Color clear(sf::Color color) {
    color.a = 0;
    return color;
}
inline bool opaque(sf::Color color) {
    return color.a == 255;
}
/// px; a border with a halo is drawn thinner by this amount, since the halo makes it look wider
inline constexpr float halo_correction = 0.25f;

/// Whether the paint has a visible border: its color differs from that of the fill.
bool bordered(const property::Paint& paint);

struct BorderRings {
    struct Ring {
        float depth;  // px
        sf::Color color;
        bool halo = false;  // the ring lies at the end of the halo; `depth` is not used
        sf::Vector2f at(const Bend& bend) const {
            return halo ? bend.corner + bend.halo : bend.at(depth);
        }
    };
    std::array<Ring, 4> rings{};  // outermost first
    std::size_t count = 0;
    sf::Color fill{};
    float depth = 0;    // px; depth of the outline of the filled area
    float overlap = 0;  // px; overlap of a border with another part of the same whole

    /// A rim inside the outline, as for convex figures.
    static BorderRings inside(const property::Paint& paint);
    /// For an outline that crosses itself: its lines have no inner side, so the rim is centered.
    static BorderRings on_both_sides(const property::Paint& paint);

  private:
    void add(float at, sf::Color color) { rings[count++] = {at, color}; }
    void add_halo(sf::Color color) { rings[count++] = {0, clear(color), true}; }
};

}  // namespace fettle::app
