#pragma once
// What the classes of this part have in common: reading of stored values, and some properties.

#include <fettle/property/painter.h>
#include <fettle/property/tree.h>

namespace fettle::visuals {

/// Reads values of one instance. All must exist; values in error give their last valid value.
class Reader {
  public:
    Reader(const property::Tree& tree, property::Handle self) : tree_(tree), self_(self) {}
    double number(const property::Property* of) const {
        double value = 0;
        return tree_.read(self_, *of, value) ? value : tree_.peek(self_, *of).as_double();
    }
    property::Vec2 vec2(const property::Property* of) const {
        property::Vec2 value;
        return tree_.read(self_, *of, value) ? value : tree_.peek(self_, *of).vec2();
    }
    property::Value value(const property::Property* of) const { return tree_.peek(self_, *of); }
    bool flag(const property::Property* of) const { return value(of).boolean(); }
    property::Color color(const property::Property* of) const { return value(of).color(); }

  private:
    const property::Tree& tree_;
    property::Handle self_;
};

property::Property position_property(const char* doc);
property::Property angle_property();
property::Property visible_property();
property::Property blend_property();
property::Blend blend_of(const property::Value& name);

}  // namespace fettle::visuals
