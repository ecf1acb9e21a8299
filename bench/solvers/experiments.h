#pragma once
// Differences between the three solvers of the library, as curves.

#include <span>
#include <string_view>
#include <vector>

#include "engines/fettle_engine.h"
#include "report/plot.h"

namespace fettle::bench {

struct SolverKind {
    std::string_view name;
    physics::Solver solver;
};
std::span<const SolverKind> solver_kinds();
/// The bare library with one solver.
EngineKind engine_of(const SolverKind& kind, int substeps = 4);

/// Milliseconds per step: the median of several steps after the first ten.
double step_time(Engine& engine, int steps);

struct Experiment {
    std::string_view name;  // also the name of its file
    Plot (*run)();
};
std::span<const Experiment> experiments();

Plot jitter_plot();
Plot load_plot();
Plot chain_plot();
Plot energy_plot();
Plot cost_plot();

}  // namespace fettle::bench
