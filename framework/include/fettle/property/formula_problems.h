#pragma once
// Reports of errors in formulas.

#include <functional>
#include <string>

#include <fettle/property/export.h>
#include <fettle/property/tree.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

struct FormulaProblem {
    Handle instance;
    std::string path;     // path of the property with the formula
    std::string message;  // error of the formula, or why its result does not fit the property
};

/// `sink` gets, at barriers, each formula with a new error: once, and again when the text of its
/// error changes, numbers aside. A formula with an error only because it reads a formula with an
/// error is not reported; of a cycle of formulas one is reported. A tree has one such function; an
/// empty one ends the reports.
void on_formula_problem(Tree& tree, std::function<void(const FormulaProblem&)> sink);

/// The current error of the formula was reported elsewhere.
void formula_problem_told(Tree& tree, Handle instance, const Property& property);

}  // namespace fettle::property

FETTLE_PROPERTY_END
