#pragma once
// What a property is, as text that outlives the tree: for the journal of tweaks.

#include <string>
#include <utility>

#include <fettle/property/edits.h>
#include <fettle/property/tree.h>

#include <scenes/instance_paths.h>

namespace fettle::property {

struct Image {
    enum class Kind : std::uint8_t { absent, by_default, value, formula };
    Kind kind = Kind::absent;
    std::string value{};      // as scene files write what has no declared type; references by path
    std::string source{};     // of a formula
    std::string not_saved{};  // why the source is not all of it
    std::string text{};       // for people
    std::string unit{};       // belongs behind it; "" for what is no value

    /// What a person would call the same: a formula may have another value by now.
    friend bool operator==(const Image& a, const Image& b) {
        return a.kind == b.kind && a.source == b.source &&
               (a.kind == Kind::formula || a.value == b.value);
    }
};

Image image_of(const Tree& tree, const Property& property, const CellState& state);
/// Of a property as it is now. `settle`: a formula is run first, if it is due.
Image image_now(const Tree& tree, Handle instance, Symbol property, bool settle);

/// A change as people read it: the unit is said once, behind the last value.
std::pair<std::string, std::string> change_text(const Image& was, const Image& now);

std::string image_json(const Image& image);
/// Throws Error for what `image_json` has not written. The text for people is not part of it.
Image read_image(const std::string& json);

/// Its value, a formula's included. Throws Error for a reference that leads nowhere now.
Value image_value(const Tree& tree, const Image& image);

/// As it stands in a file, for a property that the class declares, or for an ad-hoc one (null).
/// `written`: the path to write in the place of one from the root of the tree; none: all as they
/// are.
std::string image_in_file(const Tree& tree, const Property* declared, const Image& image,
                          const NewPath& written = {});

/// Makes the property be that. Throws Error.
void apply_image(Tree& tree, Handle instance, const std::string& property, const Image& image);

}  // namespace fettle::property
