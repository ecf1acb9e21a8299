#pragma once
// Figures that are parts of one whole. Finds the stretches of their outlines that belong to the
// border of the whole, and the area inside it.

#include <cstdint>
#include <span>
#include <vector>

#include <outlines/outline.h>

namespace fettle::app {

/// Consecutive bends of an outline. Each ring has a corner for each bend.
struct Run {
    std::vector<Bend> bends{};
    bool closed = false;
};

class JoinedFigures {
  public:
    void clear();
    /// Adds a closed outline in pixels, in either direction.
    void add(std::span<const sf::Vector2f> outline);
    std::size_t size() const { return parts_.size(); }
    std::span<const sf::Vector2f> part(std::size_t i) const { return parts_[i].corners; }
    /// Side of the square that contains all parts, in pixels.
    float extent() const;

    /// Finds which stretches of each part lie inside other parts. Call it after all parts were
    /// added. Returns false if the cost is too high.
    bool find_seams();
    /// Appends the outline of a part, moved inwards by `depth` along the border of the whole, and
    /// slightly outwards where another part continues.
    void contour(std::size_t part, float depth, std::vector<sf::Vector2f>& outline) const;
    /// The border of the whole. A run that ends at another part continues by `overlap` into it.
    std::vector<Run> border(float overlap) const;

  private:
    enum class Kind : std::uint8_t {
        border,  // border of the whole
        seam,    // another part continues beyond it
        shared   // a border that coincides with that of an earlier part, which draws it
    };
    struct Stretch {
        float from, to;  // px from the beginning of the side
        Kind kind;
    };
    struct Part {
        std::vector<sf::Vector2f> corners{};
        std::vector<Side> sides{};  // side i begins at corner i
        std::vector<Stretch> stretches{};
        std::vector<std::size_t> first{};  // first stretch of each side; the last is their number
        sf::Vector2f lower{}, upper{};

        std::size_t size() const { return corners.size(); }
        Kind begin_of(std::size_t side) const { return stretches[first[side]].kind; }
        Kind end_of(std::size_t side) const { return stretches[first[side + 1] - 1].kind; }
    };
    /// A share of a side that lies in another part.
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
    bool in_other_part(const Part& part, sf::Vector2f point) const;

    std::vector<Part> parts_;
    std::size_t work_ = 0;
    std::vector<float> crossings_;
    std::vector<Covered> covered_;
};

}  // namespace fettle::app
