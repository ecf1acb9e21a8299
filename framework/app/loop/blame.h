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

/// The topmost instances with a position, each with the last writer of a value of it or of an
/// instance below it. The simulation counts as the writer if it moves the instance and no other
/// writer wrote within the last second (`dt`: s, a step).
std::vector<Blamed> blamed(const property::Tree& tree, double dt);

/// Draws them again in the colors of their writers, and the legend at the lower left.
void draw_blame(property::Painter& painter, const property::Tree& tree, double dt, double alpha);

}  // namespace fettle::app
