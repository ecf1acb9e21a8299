#pragma once
// The outline of a rounded convex polygon, and the rings that lie at a given depth inside it.
//
// Anti-aliasing needs no help from the graphics system: a figure is drawn as rings of triangles,
// and the ring across its rim, one pixel wide, fades from the color to nothing.

#include <span>
#include <vector>

#include <SFML/System/Vector2.hpp>

namespace fettle::app {

class Outline {
  public:
    /// `corners` in pixels, convex, either way round, at least one; `rounding` is a radius around
    /// them in pixels.
    void set(std::span<const sf::Vector2f> corners, float rounding);
    /// Appends `size()` points at `depth` pixels inside the rim (negative: outside).
    void ring(float depth, std::vector<sf::Vector2f>& points) const;
    /// How deep a ring can lie before it would turn inside out.
    float depth_limit() const { return depth_limit_; }
    std::size_t size() const { return points_.size(); }

  private:
    struct Point {
        sf::Vector2f corner;
        sf::Vector2f normal;  // outwards, unit
        sf::Vector2f miter;   // outwards; moves the corner by one pixel of each edge's depth
    };
    void add_corner(sf::Vector2f corner, sf::Vector2f before, sf::Vector2f after);

    float rounding_ = 0;
    float depth_limit_ = 0;
    std::vector<Point> points_;
    std::vector<sf::Vector2f> corners_, normals_;
};

/// Segments that make a circle of `radius` pixels look round.
int circle_segments(float radius);

}  // namespace fettle::app
