#pragma once
// Facts from the descriptors as texts of the reference.

#include <string>
#include <vector>

#include <fettle/property/tree.h>
#include <fettle/script/reference.h>

namespace fettle::script {

/// "2 kg", "vec(0, -10) m/s²"
std::string with_unit(const property::Tree& tree, const property::Value& value,
                      const property::Property& property);
/// "kg"; "–" if there is no unit.
std::string unit_text(const std::string& unit);
/// "0 to 1", "at least 0". An infinite bound is shown only if infinity is a valid value.
std::string bounds_text(const property::Property& property);
/// The valid values: "0 to 1", "any number", "true or false", "\"a\", \"b\"". Never empty.
std::string range_text(const property::Property& property);
/// Whether the property has a minimum and a maximum, which may be infinite.
bool has_range(const property::Property& property);
/// Whether the value is computed from other values, so that it has no default.
bool is_computed(const property::Property& property);
/// "1"; "computed" for a read-only property; "nil".
std::string default_text(const property::Tree& tree, const property::Property& property);
/// "Box { width, height, radius, … }": the properties that a constructor sets, those of the class
/// itself first.
std::string constructor_text(const property::Class& of);
/// "raycast(from, to [, filter])"
std::string signature(const property::Method& method);
/// "read-only, simulated, not saved"; "" if there are no flags.
std::string flags_text(const property::Property& property);

/// Whether all enumerators are shown on a page; a property with more has a description that names
/// their source.
bool few_enumerators(const property::Property& property);
/// The type in annotations: `number`, `vec`, `Body?`, `"a"|"b"`, `Shape[]`.
std::string annotated_type(const property::Property& property);
std::string annotated_type(const property::Field& field);
/// The return type of a method: `nil`, a type, or a record named `World.raycast.result`.
std::string annotated_result(const property::Method& method);
bool returns_record(const property::Method& method);
std::string result_name(const property::Method& method);

// Members that the class declares itself, sorted by name. Inherited members are on the page of the
// base.
std::vector<const property::Property*> own_properties(const property::Class& of);
std::vector<const property::Method*> own_methods(const property::Class& of);
std::vector<const property::Event*> own_events(const property::Class& of);

/// Children that every instance of the class has from the beginning, by name: `world.step`.
std::vector<std::pair<std::string, const property::Class*>> fixed_children(
    const property::Tree& tree, const property::Class& of);

}  // namespace fettle::script
