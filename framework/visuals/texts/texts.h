#pragma once
// The class Text.

#include <memory>
#include <vector>

#include <fettle/module/rows.h>
#include <fettle/property/painter.h>
#include <fettle/property/tree.h>

#include <letters/layout.h>

namespace fettle::visuals {

class Texts {
  public:
    explicit Texts(Fonts& fonts) : fonts_(fonts) {}
    void define(property::Tree& tree);
    /// To be called when a font has changed.
    void clear_layouts();
    /// Loads fonts that have not been loaded. So a missing file is reported also if nothing is
    /// drawn.
    void step();

  private:
    /// The layout that was used last, and the settings from which it was made.
    struct Row {
        property::Handle self{};
        property::Value text{}, font{}, align{};
        double wrap = -1;  // for a font of size 1
        Layout layout{};
        property::Value loaded_font{};
    };
    struct Properties {
        const property::Property *text, *font, *size, *align, *anchor, *wrap, *color, *outline,
            *outline_width, *blend, *visible;
    };
    std::vector<property::Property> properties();
    double size_of(const Row& row) const;
    const Layout& layout(Row& row);
    void draw(Row& row, property::Painter& painter, double alpha);

    Fonts& fonts_;
    property::Tree* tree_ = nullptr;
    Properties of_{};
    module::Rows<Row> rows_;
};

}  // namespace fettle::visuals
