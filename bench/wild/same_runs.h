#pragma once
// The same bits on one, two and three threads, after saving and restoring, and in a copy.

#include <optional>

#include "wild/checks/check.h"

namespace fettle::bench::wild {

std::optional<Finding> compare_runs(const WorldPlan& plan);

}  // namespace fettle::bench::wild
