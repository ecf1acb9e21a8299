#pragma once
// Figures that are parts of one thing: which stretches of their outlines are its border, and what
// is inside of it.

#include <cstdint>
#include <span>
#include <vector>

#include <draw/outline.h>

namespace fettle::app {

/// Bends of an outline, one after another. A ring of it has a corner for each.
struct Run {
    std::vector<Bend> bends{};
    bool closed = false;
};

class Joined {
  public:
    void clear();
    /// Closed, in pixels, either way round.
    void add(std::span<const sf::Vector2f> outline);
    std::size_t size() const { return parts_.size(); }
    std::span<const sf::Vector2f> part(std::size_t i) const { return parts_[i].corners; }
    /// Side of the square that holds them all, in pixels.
    float extent() const;

    /// To be called when all are there: finds what of each lies inside of others. False when that
    /// would take too long.
    bool find_seams();
    /// The outline of a part, moved inwards by `depth` where it is the border of the whole, and a
    /// little outwards where another part goes on.
    void contour(std::size_t part, float depth, std::vector<sf::Vector2f>& outline) const;
    /// The border of the whole. A run that ends at another part reaches `overlap` into it.
    std::vector<Run> border(float overlap) const;

  private:
    enum class Kind : std::uint8_t {
        border,  // of the whole
        seam,    // another part goes on beyond it
        shared   // border, and the same as another part's, which stands for both
    };
    struct Stretch {
        float from, to;  // px from the side's beginning
        Kind kind;
    };
    struct Part {
        std::vector<sf::Vector2f> corners{};
        std::vector<Side> sides{};  // each begins at the corner of its number
        std::vector<Stretch> stretches{};
        std::vector<std::size_t> first{};  // stretch of each side, and the end
        sf::Vector2f lower{}, upper{};

        std::size_t size() const { return corners.size(); }
        Kind begin_of(std::size_t side) const { return stretches[first[side]].kind; }
        Kind end_of(std::size_t side) const { return stretches[first[side + 1] - 1].kind; }
    };
    /// Shares of a side that lie in another part.
    struct Covered {
        float from, to;
        Kind kind;
    };
    void find_seams_of(Part& part);
    void cover(const Part& other, sf::Vector2f from, sf::Vector2f to, Kind kind);
    void add_stretches(Part& part, float length);
    void add_runs(const Part& part, float overlap, std::vector<Run>& runs) const;
    void add_end(const Part& part, std::size_t side, float where, float overlap,
                 std::vector<Bend>& bends) const;
    bool sticks_out(const Part& part, sf::Vector2f point) const;

    std::vector<Part> parts_;
    std::size_t work_ = 0;
    std::vector<float> crossings_;
    std::vector<Covered> covered_;
};

}  // namespace fettle::app
