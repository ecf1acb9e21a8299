#pragma once
// Where the name and the value of a property are in its row. It depends on the property and on the
// room only, not on its value, so that rows stay where they are while values change.

#include <unordered_map>
#include <vector>

#include <fettle/property/tree.h>

namespace fettle::console {

class RowLayout {
  public:
    /// A row in pixels. The value has `width`, beginning at `value`, which is one column of all
    /// rows; the name has what is before it, or a line of its own if there is no room for both.
    struct Row {
        float name = 0, value = 0, width = 0;
        bool name_above = false;
        float height = 0;
    };

    /// Must be called before the rows of an instance, with all of its properties.
    void fit(const std::vector<const property::Property*>& properties);
    Row row_of(const property::Property& property, float available);

    /// The width of a field with a number of four significant digits, of a label before it, and of
    /// a unit behind it.
    static float number_width(std::string_view label, std::string_view unit);
    /// The least width of a field of a vector.
    static float component_width() { return number_width("x", {}); }
    /// Whether both fields of a vector have room side by side.
    static bool fits_two(float width);
    /// Width of the place of a mark before each name.
    static float mark_width();
    /// Width of a small button after a value.
    static float button_width();
    /// The fields of a vector have no room for the unit.
    static bool unit_is_beside_name(const property::Property& property);

  private:
    struct Needs {
        float name = 0, value = 0;
    };
    const Needs& needs(const property::Property& property);
    float column(float available);
    float usual_column(float available) const;

    std::vector<const property::Property*> fitted_;  // whose names `widest_name_` is for
    float size_ = 0, widest_name_ = 0;
    float column_ = 0, column_for_ = -1;  // the column of values in a row of that width
    std::unordered_map<const property::Property*, Needs> needs_;
};

}  // namespace fettle::console
