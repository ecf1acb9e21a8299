#pragma once
// Outlines of figures, and rings at a given depth inside them.
//
// These rings give anti-aliasing without support of the graphics system: a figure is drawn as rings
// of triangles, and the color fades to transparent across the rim.

#include <span>
#include <vector>

#include <SFML/System/Vector2.hpp>

namespace fettle::app {

/// A side of an outline with positive area.
struct Side {
    sf::Vector2f normal;  // outwards, unit
    float length;         // px
    float halo;           // px; width of the fading outside of it, if figures may touch

    Side(sf::Vector2f from, sf::Vector2f to);
};

/// A corner of an outline, from which the corners of its rings are computed.
struct Bend {
    sf::Vector2f corner;
    // Movement of a ring's corner for each pixel of depth, outwards and inwards.
    sf::Vector2f out, in;
    sf::Vector2f halo;  // from the corner to the end of the halo
    float reach;        // px; a ring's corner does not move beyond this depth

    sf::Vector2f at(float depth) const {
        return depth < 0 ? corner + out * (-depth < reach ? -depth : reach)
                         : corner - in * (depth < reach ? depth : reach);
    }
};

/// Appends the bends at a corner between two sides: one bend, or two if the corner is so sharp that
/// one would extend too far.
void add_bends(sf::Vector2f corner, const Side& before, const Side& after, float reach,
               std::vector<Bend>& bends);

/// The largest depth of a ring at which its corner does not pass a neighboring corner.
float reach_between(const Side& before, const Side& after);

/// Two lines through the same point are moved by `distance` along their normals. Returns the vector
/// from that point to their new intersection; zero if they are almost parallel.
sf::Vector2f intersection_offset(sf::Vector2f normal, float distance, sf::Vector2f other_normal,
                                 float other_distance);

float area_of(std::span<const sf::Vector2f> corners);  // px²

/// Sets `corners` to `given` without repeated corners, in the order with positive area.
void set_positive_outline(std::vector<sf::Vector2f>& corners, std::span<const sf::Vector2f> given);

/// Whether an outline is convex, up to an invisible error, and winds around only once.
bool is_convex(std::span<const sf::Vector2f> corners);

/// Removes corners that are closer to the one before than is visible.
void remove_close_corners(std::vector<sf::Vector2f>& corners);

class Outline {
  public:
    /// `corners`: pixels, convex, in either direction, at least one. `rounding`: radius around the
    /// corners in pixels.
    void set(std::span<const sf::Vector2f> corners, float rounding);
    /// Sets any closed outline, in either direction.
    void set_any(std::span<const sf::Vector2f> corners);

    /// Appends `size()` points at the end of the halo.
    void halo(std::vector<sf::Vector2f>& points) const;
    /// Appends `size()` points at `depth` pixels inside the rim (negative: outside).
    void ring(float depth, std::vector<sf::Vector2f>& points) const;
    /// The largest depth at which a ring is not turned inside out.
    float depth_limit() const { return depth_limit_; }
    std::size_t size() const { return bends_.size(); }
    std::span<const Bend> bends() const { return bends_; }
    std::span<const sf::Vector2f> corners() const { return corners_; }
    /// Side i begins at corner i.
    std::span<const Side> sides() const { return sides_; }
    bool rounded() const { return rounding_ > 0; }
    /// False if the outline certainly crosses itself.
    bool goes_round_once() const { return goes_round_once_; }

  private:
    void begin(std::span<const sf::Vector2f> corners);
    void add_arc(sf::Vector2f corner, const Side& before, const Side& after);
    void add_circle();

    float rounding_ = 0;
    float depth_limit_ = 0;
    bool goes_round_once_ = true;
    std::vector<Bend> bends_;
    std::vector<sf::Vector2f> corners_;
    std::vector<Side> sides_;
};

/// Number of segments with which a circle of `radius` pixels looks round.
int circle_segments(float radius);

/// Largest distance between a chord and its arc, in pixels; above it corners are visible.
inline constexpr float chord_tolerance = 0.05f;

}  // namespace fettle::app
