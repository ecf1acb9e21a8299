#pragma once
// Lines through several points, with round corners and ends.

#include <array>
#include <cstdint>
#include <span>

#include <fettle/property/export.h>
#include <fettle/property/painter.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// A straight part of a line.
struct LinePiece {
    Vec2 from, to;
    double rounding = 0;  ///< radius of its round ends, m
};

/// Thinner lines have no round ends, px.
inline constexpr double thinnest_round_line = 2;

/// Draws the pieces as parts of the figure with the number `whole` (`Painter::part_of`): where they
/// overlap, a translucent color is drawn once. `width`: px.
inline void draw_thick_line(Painter& painter, std::uint64_t whole,
                            std::span<const LinePiece> pieces, double width, Color color) {
    // The painter draws thinner lines of one whole without an overlap at their corners.
    constexpr double thinnest_translucent = 4;
    const bool thin = width < (color.a >= 1 ? thinnest_round_line : thinnest_translucent);
    painter.part_of(whole);
    for (const LinePiece& piece : pieces)
        if (thin)
            painter.line(piece.from, piece.to, color, static_cast<float>(width));
        else
            painter.polygon(std::array{piece.from, piece.to}, piece.rounding,
                            {.fill = color, .border = {0, 0, 0, 0}});
    painter.part_of(0);
}

}  // namespace fettle::property

FETTLE_PROPERTY_END
