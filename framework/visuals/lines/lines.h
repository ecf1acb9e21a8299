#pragma once
// The class Line: a line through several points.

#include <fettle/property/painter.h>
#include <fettle/property/tree.h>

namespace fettle::visuals {

class Lines {
  public:
    void define(property::Tree& tree);

  private:
    struct Properties {
        const property::Property *points, *width, *color, *closed, *dashed, *blend, *visible;
    };
    void draw(const property::Tree& tree, property::Handle self, property::Painter& painter,
              double alpha) const;

    Properties of_{};
};

}  // namespace fettle::visuals
