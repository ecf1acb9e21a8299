#pragma once
// Common code of the classes of this part: reading of stored values, and some properties.

#include <fettle/property/painter.h>
#include <fettle/property/stored_values.h>
#include <fettle/property/tree.h>

namespace fettle::visuals {

/// Reads values of one instance. All must exist; values in error give their last valid value.
class Reader {
  public:
    Reader(const property::Tree& tree, property::Handle self) : stored_(tree, self) {}
    double number(const property::Property* of) const { return stored_.number(*of); }
    std::int64_t integer(const property::Property* of) const { return stored_.integer(*of); }
    property::Vec2 vec2(const property::Property* of) const { return stored_.vec2(*of); }
    bool flag(const property::Property* of) const { return stored_.boolean(*of); }
    property::Color color(const property::Property* of) const { return stored_.color(*of); }
    property::Value value(const property::Property* of) const { return stored_.peek(*of); }
    /// Without a copy, valid until the next edit. For texts, and values that may be nil.
    const property::Value& in_place(const property::Property* of) const {
        return stored_.value(*of);
    }

  private:
    property::StoredValues stored_;
};

property::Property position_property(const char* doc);
property::Property angle_property();
property::Property visible_property();
property::Property blend_property();
property::Blend blend_of(const property::Value& name);

}  // namespace fettle::visuals
