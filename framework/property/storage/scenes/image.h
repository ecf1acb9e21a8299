#pragma once
// State of a property as text that outlives the tree. Used by the journal of tweaks.

#include <string>
#include <utility>

#include <fettle/property/edits.h>
#include <fettle/property/tree.h>

#include <values/instance_paths.h>

namespace fettle::property {

struct Image {
    enum class Kind : std::uint8_t { absent, by_default, value, formula };
    Kind kind = Kind::absent;
    std::string value{};      // in the form of undeclared values in scene files; references by path
    std::string source{};     // text of a formula
    std::string not_saved{};  // why the text is not the whole formula
    std::string text{};       // for people
    std::string unit{};       // to be shown after the text; "" if there is no value

    /// Equal for a person: the current values of equal formulas may differ, and defaults may change
    /// when a script is loaded again.
    friend bool operator==(const Image& a, const Image& b) {
        return a.kind == b.kind && a.source == b.source &&
               (a.kind == Kind::formula || a.kind == Kind::by_default || a.value == b.value);
    }
};

Image image_of(const Tree& tree, const Property& property, const CellState& state);
/// The current state of a property. `settle`: a formula that is due runs first.
Image image_now(const Tree& tree, Handle instance, Symbol property, bool settle);

/// A change for people: the unit is written once, after the last value.
std::pair<std::string, std::string> change_text(const Image& was, const Image& now);

std::string image_json(const Image& image);
/// Throws Error for text that `image_json` did not write. The text for people is not included.
Image read_image(const std::string& json);

/// The value, also that of a formula. Throws Error for a reference to an instance that does not
/// exist.
Value image_value(const Tree& tree, const Image& image);

/// The value as it is written in a file. `declared`: the property of the class; null for an ad-hoc
/// property. `written`: replaces paths that begin at the root; none: all paths stay.
std::string image_in_file(const Tree& tree, const Property* declared, const Image& image,
                          const NewPath& written);

/// Sets the property to that state. Throws Error.
void apply_image(Tree& tree, Handle instance, const std::string& property, const Image& image);

}  // namespace fettle::property
