#pragma once
// A table of small costs. Each cost is a loop that Google Benchmark times. The repetitions of all
// loops run in random order, so that a disturbance does not affect one row alone.

#include <benchmark/benchmark.h>

#include <functional>
#include <string>
#include <vector>

#include "report/bounds.h"

namespace fettle::bench {

/// Comparison of a row with another one.
struct Comparison {
    std::string against;
    double ratio = 0;
    Bound bound{};  // bound of the ratio
};

struct Cost {
    std::string name;
    double ns = 0;
    std::vector<Comparison> comparisons{};
};

using CostLoop = std::function<void(benchmark::State&)>;

class CostTable {
  public:
    struct Against {
        std::string row;
        Bound bound{};
    };
    struct Row {
        std::string name;
        double operations = 1;  // measured operations in one iteration of the loop
        CostLoop loop;
        std::vector<Against> against{};      // rows it is compared with, if they exist
        std::vector<std::string> without{};  // rows whose time is subtracted
        bool own_clock = false;              // the loop measures the time of an iteration itself
        bool shown = true;
    };
    void add(Row row);
    void add(std::string name, std::string against, double operations, CostLoop loop);
    /// Keeps only the rows whose names contain `text`, and the rows they require. Throws
    /// std::invalid_argument if no row is left.
    void keep(const std::string& text);
    /// Median over the repetitions, in the order of `add`: of the processor time, or of the time
    /// that the loop measures (`own_clock`).
    std::vector<Cost> run(int repetitions) const;

  private:
    std::vector<Row> rows_;
};

/// Adds accesses to properties through each C++ function of the tree, the cost of watching, and
/// that of creating instances.
void add_tree_costs(CostTable& table);
/// Adds accesses to properties from Lua, with bare Lua and, if it is installed, LÖVE for
/// comparison.
void add_lua_costs(CostTable& table);
/// Adds formulas, with their plain functions for comparison.
void add_formula_costs(CostTable& table);
/// Adds watchers of many instances.
void add_pattern_costs(CostTable& table);

}  // namespace fettle::bench
