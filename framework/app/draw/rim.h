#pragma once
// How the rim of a figure that is not convex is drawn: rings at depths inside of its outline, each
// of one color, and what lies between two of them goes from one color to the other.

#include <array>
#include <cstddef>

#include <fettle/property/painter.h>

#include <draw/outline.h>
#include <sfml/sfml.h>

namespace fettle::app {

/// As the graphics system has it.
sf::Color native(property::Color color, float opacity = 1);

inline sf::Color clear(sf::Color color) {
    color.a = 0;
    return color;
}
inline bool opaque(sf::Color color) {
    return color.a == 255;
}
/// px; how much thinner than it is a border is drawn inside of an outline with a halo.
inline constexpr float thinner = 0.25f;

/// Whether one sees a border: not one that looks like what it surrounds.
bool bordered(const property::Paint& paint);

struct Rim {
    struct Ring {
        float depth;  // px
        sf::Color color;
        bool halo = false;  // where the halo ends instead
        sf::Vector2f at(const Bend& bend) const {
            return halo ? bend.corner + bend.halo : bend.at(depth);
        }
    };
    std::array<Ring, 4> rings{};  // the outermost first
    std::size_t count = 0;
    sf::Color fill{};
    float depth = 0;    // of the outline of what is filled
    float overlap = 0;  // px; how far a border reaches into another part of the same thing

    /// A rim that lies inside of the outline, as that of convex figures.
    static Rim inside(const property::Paint& paint);
    /// For an outline that crosses itself, where no side of a line is the inside.
    static Rim on_both_sides(const property::Paint& paint);

  private:
    void add(float at, sf::Color color) { rings[count++] = {at, color}; }
    void add_halo(sf::Color color) { rings[count++] = {0, clear(color), true}; }
};

}  // namespace fettle::app
