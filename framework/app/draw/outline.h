#pragma once
// Outlines of figures, and the rings that lie at a given depth inside them.
//
// Anti-aliasing needs no help from the graphics system: a figure is drawn as rings of triangles,
// and the ring across its rim fades from the color to nothing.

#include <span>
#include <vector>

#include <SFML/System/Vector2.hpp>

namespace fettle::app {

/// An edge of an outline with a positive area.
struct Side {
    sf::Vector2f normal;  // outwards, unit
    float length;         // px
    float halo;           // px; how far outside of it its color ends, where it may touch others

    Side(sf::Vector2f from, sf::Vector2f to);
};

/// A corner of an outline, and where the corners of its rings are.
struct Bend {
    sf::Vector2f corner;
    sf::Vector2f out, in;  // where a pixel of depth takes it, outwards and inwards
    sf::Vector2f halo;     // from it to the end of the halo
    float reach;           // px; from that depth on a ring's corner stays where it is

    sf::Vector2f at(float depth) const {
        return depth < 0 ? corner + out * (-depth < reach ? -depth : reach)
                         : corner - in * (depth < reach ? depth : reach);
    }
};

/// Appends what an outline has where two of its sides meet: one bend, or two where the corner is so
/// sharp that one would stick out far.
void add_bends(sf::Vector2f corner, const Side& before, const Side& after, float reach,
               std::vector<Bend>& bends);

/// How deep a ring may be before its corner between two sides passes a next one.
float reach_between(const Side& before, const Side& after);

/// The way to where two lines meet that are moved from one point by `distance` along their normals;
/// zero where they hardly differ.
sf::Vector2f meeting(sf::Vector2f normal, float distance, sf::Vector2f other_normal,
                     float other_distance);

float area_of(std::span<const sf::Vector2f> corners);  // px²

/// Makes `corners` those of `given` that differ, in the order that has a positive area.
void set_round(std::vector<sf::Vector2f>& corners, std::span<const sf::Vector2f> given);

/// Whether an outline bulges everywhere, as far as one can see, and goes round once.
bool is_convex(std::span<const sf::Vector2f> corners);

/// Leaves out corners that are too near to the one before to be seen.
void thin(std::vector<sf::Vector2f>& corners);

class Outline {
  public:
    /// `corners` in pixels, convex, either way round, at least one; `rounding` is a radius around
    /// them in pixels.
    void set(std::span<const sf::Vector2f> corners, float rounding);
    /// Corners of any closed outline, either way round.
    void set_any(std::span<const sf::Vector2f> corners);

    /// Appends `size()` points where its halo ends.
    void halo(std::vector<sf::Vector2f>& points) const;
    /// Appends `size()` points at `depth` pixels inside the rim (negative: outside).
    void ring(float depth, std::vector<sf::Vector2f>& points) const;
    /// How deep a ring can lie before it would turn inside out.
    float depth_limit() const { return depth_limit_; }
    std::size_t size() const { return bends_.size(); }
    std::span<const Bend> bends() const { return bends_; }
    std::span<const sf::Vector2f> corners() const { return corners_; }
    /// Each begins at the corner of its number.
    std::span<const Side> sides() const { return sides_; }
    bool rounded() const { return rounding_ > 0; }
    /// False when it certainly crosses itself: it does not go round just once.
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

/// Segments that make a circle of `radius` pixels look round.
int circle_segments(float radius);

/// How far a chord may miss its arc, in pixels: of more one sees the corners.
inline constexpr float unseen = 0.05f;

}  // namespace fettle::app
