#pragma once
// Notes about formulas of persons that a script replaces.

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <fettle/property/tree.h>

namespace fettle::script {

struct Machine;

/// The properties to which a person has given a formula in this run, in the console or in the
/// inspector; some may have lost it since.
struct TypedFormulas {
    std::set<std::pair<std::uint64_t, std::string>> all{};  // keys of instances, names
};

/// To be called when a formula is set.
void note_typed_formula(Machine& machine, property::Handle instance, std::string_view name);

/// To be called before a script writes a plain value or another formula. If the property has a
/// formula that a person has typed, gives one note with the place in the script. Without it, the
/// formula would be lost unnoticed.
void note_replaced_formula(Machine& machine, property::Handle instance, std::string_view name);

}  // namespace fettle::script
