#pragma once
// Spelling: finds the name that the user probably meant.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/export.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// Edits (insert, delete, replace, swap of neighbors) that turn `a` into `b`, letter case ignored;
/// stops counting beyond `limit` and returns limit + 1. Source: Damerau 1964, optimal string
/// alignment.
std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit);

/// Whether `part` is somewhere in `text`, letter case ignored. Only letters in ASCII have a case.
bool contains_ignoring_case(std::string_view text, std::string_view part);

/// True if `name` is so similar to `declared` that it is probably a typing error: other case, one
/// edit or one transposition. Names with fewer than four letters are compared by case only, because
/// they are similar to many others. Names with different numbers or letters at the end (wheel1 and
/// wheel2, item_a and item_b) are different names.
bool near_miss(std::string_view name, std::string_view declared);

/// Whether `name` with a value of type `given` is probably a typing error for a declared property
/// of the type `type`: a near miss. A plural with a value of another kind is a name of its own,
/// such as `names` for a list, or `bullets` for a number.
bool misspells(std::string_view name, Type given, std::string_view declared, Type type);

/// Names that differ only in a number or a letter at the end: wheel1 and wheel2, item_a and item_b,
/// pointA and pointB. They are not typing errors.
bool of_one_series(std::string_view a, std::string_view b);

/// The candidate nearest to `name`, or "" if none is near enough.
std::string nearest(std::string_view name, std::span<const std::string> candidates);

/// ` (did you mean "mass"?)` or "".
std::string suggestion(std::string_view name, std::span<const std::string> candidates);

/// The noun with its indefinite article: "a Body", "an Action".
std::string with_article(std::string_view noun);

}  // namespace fettle::property

FETTLE_PROPERTY_END
