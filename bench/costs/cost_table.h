#pragma once
// Small costs: each a loop that Google Benchmark times, repeated with the others in random order so
// that a noisy moment hits no row alone.

#include <benchmark/benchmark.h>

#include <functional>
#include <string>
#include <vector>

#include "report/bounds.h"

namespace fettle::bench {

/// A row beside another.
struct Comparison {
    std::string against;
    double ratio = 0;
    Bound bound{};  // of the ratio
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
        double operations = 1;  // of what is measured, in an iteration of the loop
        CostLoop loop;
        std::vector<Against> against{};      // rows it is compared with, where there are such
        std::vector<std::string> without{};  // rows whose time is taken off
        bool own_clock = false;              // the loop says itself how long an iteration took
        bool shown = true;
    };
    void add(Row row);
    void add(std::string name, std::string against, double operations, CostLoop loop);
    /// Leaves out every row that neither has `text` in its name nor is what such a row needs.
    /// Throws std::invalid_argument when no row is left.
    void keep(const std::string& text);
    /// Medians of processor time over the repetitions, in the order of `add`.
    std::vector<Cost> run(int repetitions) const;

  private:
    std::vector<Row> rows_;
};

/// Properties of instances, by every way there is in C++, and what watching them costs.
void add_tree_costs(CostTable& table);
/// Properties from Lua, beside the least that Lua can do and beside LÖVE where it is installed.
void add_lua_costs(CostTable& table);
/// Formulas, beside the functions they are made of.
void add_formula_costs(CostTable& table);
/// Watchers of many instances at once.
void add_pattern_costs(CostTable& table);

}  // namespace fettle::bench
