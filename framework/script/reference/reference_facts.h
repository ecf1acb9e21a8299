#pragma once
// What descriptors say, in the words of the reference.

#include <string>
#include <vector>

#include <fettle/property/tree.h>

namespace fettle::script {

/// "2 kg", "vec(0, -10) m/s²"
std::string with_unit(const property::Tree& tree, const property::Value& value,
                      const property::Property& property);
/// "kg", "–" where there is none.
std::string unit_text(const std::string& unit);
/// "0 to 1", "at least 0". A bound of infinity is one where infinity itself is a value.
std::string bounds_text(const property::Property& property);
/// "0 to 1", "any number", "true or false", "\"a\", \"b\"": what values there can be. Never
/// empty.
std::string range_text(const property::Property& property);
/// Whether values of the property lie between a minimum and a maximum, be they infinite.
bool has_range(const property::Property& property);
/// "1", "computed" for what is read only, "nil".
/// Whether its value follows from others, so that it has no default.
bool is_computed(const property::Property& property);
std::string default_text(const property::Tree& tree, const property::Property& property);
/// "number · kg · 0 to inf · default 1 · read-only"
std::string property_facts(const property::Tree& tree, const property::Property& property);
/// "raycast(from, to [, filter])"
std::string signature(const property::Method& method);
/// "read-only, simulated, not saved"; "" where nothing is special.
std::string flags_text(const property::Property& property);

/// The type as editors' annotations have it: `number`, `vec`, `Body?`, `"a"|"b"`, `Shape[]`.
/// Whether all of them can stand in a page; the text of a property with more tells where they are.
bool few_enumerators(const property::Property& property);
std::string annotated_type(const property::Property& property);
std::string annotated_type(const property::Field& field);
/// What a method returns: `nil`, a type, or a record named `World.raycast.result`.
std::string annotated_result(const property::Method& method);
bool returns_record(const property::Method& method);
std::string result_name(const property::Method& method);

// What the class declares itself, sorted by name; what it inherits is told where it is declared.
std::vector<const property::Property*> own_properties(const property::Class& of);
std::vector<const property::Method*> own_methods(const property::Class& of);
std::vector<const property::Event*> own_events(const property::Class& of);

/// Instances that are there from the beginning below one of the class, by name: `world.step`.
std::vector<std::pair<std::string, const property::Class*>> fixed_children(
    const property::Tree& tree, const property::Class& of);

}  // namespace fettle::script
