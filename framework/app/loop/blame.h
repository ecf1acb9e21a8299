#pragma once
// `view.show.blame`: draws each instance in the color of its last writer.

#include <string>
#include <vector>

#include <fettle/property/painter.h>
#include <fettle/property/tree.h>

namespace fettle::app {

struct Blamed {
    property::Handle instance;
    std::string writer;  // "main.lua:30", "console", "inspector", "physics", "unknown"
};

/// The topmost instances with a position. The writer of each is the last one that changed a value
/// of the instance or of an instance below it. The simulation counts as the writer if it moves the
/// instance and no other writer wrote within the last second. `dt`: length of a step, s.
std::vector<Blamed> blamed(const property::Tree& tree, double dt);

/// Draws these instances again in the colors of their writers, and the legend at the lower left.
void draw_blame(property::Painter& painter, const property::Tree& tree, double dt, double alpha);

}  // namespace fettle::app
