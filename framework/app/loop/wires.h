#pragma once
// `view.show.wires`: arrows from the properties that formulas read to those that they write.

#include <optional>
#include <string>
#include <vector>

#include <fettle/property/painter.h>
#include <fettle/property/tree.h>

namespace fettle::app {

struct Wire {
    std::optional<property::Vec2> from;  // m; none if the read instance has no place
    property::Vec2 to{0, 0};             // m
    std::string label;                   // "ball.mass → crate.mass"
};

/// One wire for each value that a formula reads. At most `most` formulas.
std::vector<Wire> wires(const property::Tree& tree, std::size_t most = 500);

void draw_wires(property::Painter& painter, const property::Tree& tree);

}  // namespace fettle::app
