// Thin translucent lines with corners: the pieces meet in the corners and do not overlap there,
// since the color would be drawn twice.

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <draw/canvas.h>
#include <outlines/vectors.h>

namespace fettle::app {

namespace {

constexpr float same_point = 0.05f;      // px
constexpr float closing_gap = 0.5f;      // px; points this near close a line
constexpr float shortest_piece = 0.75f;  // px; shorter pieces are joined with the next one
constexpr float sharpest = -0.7f;        // cosine of the turn; a sharper corner ends the line

float length_of(sf::Vector2f v) {
    return std::hypot(v.x, v.y);
}

/// The vector to the left of the way from one point to another, of length 1.
sf::Vector2f side_of(sf::Vector2f from, sf::Vector2f to) {
    const sf::Vector2f along = to - from;
    const float length = length_of(along);
    return length > 0 ? sf::Vector2f(along.y, -along.x) / length : sf::Vector2f(0, -1);
}

}  // namespace

void Canvas::add_to_polyline(sf::Vector2f from, sf::Vector2f to, sf::Color color, float width) {
    Polyline& line = polyline_;
    const bool goes_on = !line.points.empty() && line.whole == whole_ && line.color == color &&
                         line.width == width && length_of(line.points.back() - from) < same_point;
    bool turns_back = false;
    if (goes_on && line.points.size() > 1) {
        const sf::Vector2f before = side_of(line.points[line.points.size() - 2], from);
        turns_back = dot(before, side_of(from, to)) < sharpest;
    }
    if (!goes_on || turns_back) {
        draw_collected();
        line.points.assign(1, from);
        line.color = color;
        line.width = width;
        line.whole = whole_;
    }
    if (line.points.size() > 1 && length_of(to - line.points.back()) < shortest_piece)
        line.points.back() = to;
    else
        line.points.push_back(to);
}

/// Across the line, the color is clear, full, full, clear; these strips lie side by side.
void Canvas::draw_polyline() {
    Polyline& line = polyline_;
    if (line.points.size() < 2) return line.points.clear();
    const std::vector<sf::Vector2f> points = std::exchange(line.points, {});
    const std::size_t n = points.size();
    struct Cut {
        sf::Vector2f at, side;  // side: as long as the line is wide there, for a width of 2
        bool visible;
    };
    std::vector<Cut> cuts;
    const auto corner = [&](sf::Vector2f at, sf::Vector2f before, sf::Vector2f after) {
        cuts.push_back({at, (before + after) / (1 + dot(before, after)), true});
    };
    const sf::Vector2f first = side_of(points[0], points[1]);
    const sf::Vector2f last = side_of(points[n - 2], points[n - 1]);
    const bool closed = n > 3 && length_of(points.front() - points.back()) < closing_gap &&
                        dot(last, first) > sharpest;
    const auto along = [](sf::Vector2f side) { return sf::Vector2f(-side.y, side.x); };
    if (closed) {
        corner(points[0], last, first);
    } else {
        cuts.push_back({points[0] - 0.5f * along(first), first, false});
        cuts.push_back({points[0] + 0.5f * along(first), first, true});
    }
    for (std::size_t i = 1; i + 1 < n; ++i)
        corner(points[i], side_of(points[i - 1], points[i]), side_of(points[i], points[i + 1]));
    if (closed) {
        corner(points[n - 1], last, first);
    } else {
        cuts.push_back({points[n - 1] - 0.5f * along(last), last, true});
        cuts.push_back({points[n - 1] + 0.5f * along(last), last, false});
    }
    const float half = 0.5f * line.width;
    const std::array<float, 4> across{half + 0.5f, half - 0.5f, 0.5f - half, -half - 0.5f};
    const sf::Color none = clear(line.color);
    for (std::size_t k = 0; k + 1 < across.size(); ++k) {
        if (across[k] == across[k + 1]) continue;
        const bool outer = k == 0, inner = k == 2;
        CanvasVertex* out = start_strip(2 * cuts.size(), cuts[0].at + across[k] * cuts[0].side);
        for (const Cut& cut : cuts) {
            *out++ =
                plain(cut.at + across[k] * cut.side, cut.visible && !outer ? line.color : none);
            *out++ =
                plain(cut.at + across[k + 1] * cut.side, cut.visible && !inner ? line.color : none);
        }
    }
}

}  // namespace fettle::app
