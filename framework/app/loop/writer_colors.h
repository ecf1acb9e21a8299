#pragma once
// `view.show.blame`: draws each instance in the color of its last writer.

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fettle/app/surface.h>
#include <fettle/property/painter.h>
#include <fettle/property/tree.h>

namespace fettle::app {

struct InstanceWriter {
    property::Handle instance;
    std::string writer;  // "main.lua:30", "console", "inspector", "physics", "unknown"
};

/// The topmost instances with a position. The writer of each is the last one that changed a value
/// of the instance or of an instance below it. The simulation counts as the writer if it moves the
/// instance and no other writer wrote within the last second. `dt`: length of a step, s.
std::vector<InstanceWriter> instance_writers(const property::Tree& tree, double dt);

/// These instances with the colors of their writers.
class WriterColors {
  public:
    WriterColors(const property::Tree& tree, double dt);
    /// Draws all instances again, these in their colors and the others as they are.
    void draw(property::Painter& painter, double alpha) const;
    /// Draws how many instances each writer wrote, at the lower left of `room`; as many writers as
    /// have room, and the others together. `size`: height of the texts, px; 0: the usual one.
    void draw_legend(Surface& surface, const ClipRectangle& room, float size = 0) const;

  private:
    property::Color color_of(const std::string& writer) const;

    const property::Tree& tree_;
    std::vector<InstanceWriter> all_;
    std::vector<std::pair<std::string, std::size_t>> legend_;  // writers, by number of instances
    std::map<std::string, property::Color> color_;             // of each writer but the others
};

}  // namespace fettle::app
