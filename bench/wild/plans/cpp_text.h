#pragma once
// A plan as C++ that makes and steps the same world, to read it and to make a test of it.

#include <string>

#include "wild/plans/plan.h"

namespace fettle::bench::wild {

/// Statements for a function with `using namespace fettle::physics`. Equal plans have equal
/// texts, and different plans different ones.
std::string cpp_text(const WorldPlan& plan);

}  // namespace fettle::bench::wild
