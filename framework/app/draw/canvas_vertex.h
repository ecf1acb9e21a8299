#pragma once

#include <cstdint>

namespace fettle::app {

/// Has the memory layout of SFML's vertex. Constructors of SFML's own type are library calls, which
/// cost too much: a bordered box has forty vertices.
struct CanvasVertex {
    CanvasVertex() {}  // leaves all as it is: what a batch is enlarged by is written at once
    CanvasVertex(float left, float top, std::uint8_t red, std::uint8_t green, std::uint8_t blue,
                 std::uint8_t opacity, float texel_x, float texel_y)
        : x(left), y(top), r(red), g(green), b(blue), a(opacity), u(texel_x), v(texel_y) {}
    float x, y;
    std::uint8_t r, g, b, a;
    float u, v;  // texels
};

}  // namespace fettle::app
