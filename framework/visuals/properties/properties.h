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

/// Each instance has a row of `rows` and is drawn by `draw`; both are members of `Owner`.
template <auto rows, auto draw, class Owner>
property::Lifecycle lifecycle_with_rows(Owner& owner) {
    property::Lifecycle made;
    made.context = &owner;
    made.create = [](void* context, property::Tree&, property::Handle self) {
        return (static_cast<Owner*>(context)->*rows).add(self);
    };
    made.destroy = [](void* context, property::Tree&, property::Handle, property::Row row) {
        (static_cast<Owner*>(context)->*rows).remove(row);
    };
    made.draw = [](void* context, const property::Tree&, property::Handle, property::Row row,
                   property::Painter& painter, double alpha) {
        auto& its = *static_cast<Owner*>(context);
        (its.*draw)((its.*rows)[row], painter, alpha);
    };
    return made;
}

property::Property position_property(const char* doc);
property::Property angle_property();
property::Property visible_property();
property::Property blend_property();
property::Blend blend_of(const property::Value& name);

}  // namespace fettle::visuals
