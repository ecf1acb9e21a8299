#pragma once
// `view.show.blame`: what is drawn gets the color of who wrote it last.

#include <string>
#include <vector>

#include <fettle/property/painter.h>
#include <fettle/property/tree.h>

namespace fettle::app {

struct Blamed {
    property::Handle instance;
    std::string writer;  // "main.lua:30", "console", "inspector", "physics", "unknown"
};

/// The instances with a position that are below no other such instance, each with who wrote last
/// one of its values or of those below it. The simulation counts if it moves the instance and
/// nobody else wrote within the last second of `dt` steps.
std::vector<Blamed> blamed(const property::Tree& tree, double dt);

/// Draws them again in the colors of their writers, and the legend at the lower left.
void draw_blame(property::Painter& painter, const property::Tree& tree, double dt, double alpha);

}  // namespace fettle::app
