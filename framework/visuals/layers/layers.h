#pragma once
// The class Layer: instances below a layer scroll at the rate of the layer, repeat, or stay on the
// screen.

#include <vector>

#include <fettle/property/painter.h>
#include <fettle/property/tree.h>

namespace fettle::visuals {

class Layers {
  public:
    void define(property::Tree& tree);

  private:
    struct Properties {
        const property::Property *space, *anchor, *scale, *parallax, *repeat_x, *repeat_y, *opacity,
            *blend, *visible;
    };
    bool begin(const property::Tree& tree, property::Handle self, property::Painter& painter,
               int pass);
    void end(property::Painter& painter);

    Properties of_{};
    std::vector<bool> on_screen_;  // of the layers that are begun
};

}  // namespace fettle::visuals
