#pragma once
// Triangles with one texture that are drawn in one go.

#include <cstddef>
#include <vector>

#include <draw/canvas_vertex.h>
#include <sfml/sfml.h>

namespace fettle::app {

struct Batch {
    const sf::Texture* texture = nullptr;
    std::vector<CanvasVertex> strip{};  // one strip; degenerate triangles join the figures
    std::vector<CanvasVertex> quads{};  // instead of a strip; four corners each, in a circle
    std::size_t last_quads = 0;         // at the end of `strip`, with nothing between them

    bool empty() const { return strip.empty() && quads.empty(); }
    void clear() {
        strip.clear();
        quads.clear();
        last_quads = 0;
        texture = nullptr;
    }
};

}  // namespace fettle::app
