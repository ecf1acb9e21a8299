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

/// At barriers, `sink` receives each formula with a new error: once, and again when the text of the
/// error changes, except for its numbers. A formula that fails only because it reads a failing
/// formula is not reported. Of a cycle of formulas one is reported. A tree has one sink; an empty
/// function ends the reports.
void on_formula_problem(Tree& tree, std::function<void(const FormulaProblem&)> sink);

/// To be called after the current error of the formula was reported elsewhere: it is not reported
/// again.
void formula_problem_reported(Tree& tree, Handle instance, const Property& property);

}  // namespace fettle::property

FETTLE_PROPERTY_END
