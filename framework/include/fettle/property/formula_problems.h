#pragma once
// Who is told of formulas that get into error.

#include <functional>
#include <string>

#include <fettle/property/export.h>
#include <fettle/property/tree.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

struct FormulaProblem {
    Handle instance;
    std::string path;     // of the property that has the formula
    std::string message;  // what the formula raised, or why its result is no value of the property
};

/// Tells at barriers which formulas have got into error: each once, and once more when the text of
/// its error is another, but for its numbers. A formula that is in error only because it reads one
/// that is, is not told; of a circle of formulas one is told. There is one such function for a
/// tree; an empty one ends it.
void on_formula_problem(Tree& tree, std::function<void(const FormulaProblem&)> sink);

/// What is wrong with the formula now has been told elsewhere.
void formula_problem_told(Tree& tree, Handle instance, const Property& property);

}  // namespace fettle::property

FETTLE_PROPERTY_END
