#pragma once
// Small costs: each a loop that Google Benchmark times, repeated with the others in random order so
// that a noisy moment hits no row alone.

#include <benchmark/benchmark.h>

#include <functional>
#include <string>
#include <vector>

namespace fettle::bench {

struct Cost {
    std::string name;
    double ns = 0;
    std::string against{};  // the row it is compared with; "" where there is none
    double ratio = 0;
};

using CostLoop = std::function<void(benchmark::State&)>;

class CostTable {
  public:
    /// `loop` does `operations` of what is measured in each of its iterations.
    void add(std::string name, std::string against, double operations, CostLoop loop);
    /// Leaves out every row that neither has `text` in its name nor is what such a row is compared
    /// with. Throws std::invalid_argument when no row is left.
    void keep(const std::string& text);
    /// Medians of processor time over the repetitions, in the order of `add`.
    std::vector<Cost> run(int repetitions) const;

  private:
    struct Entry {
        std::string name;
        std::string against;
        double operations;
        CostLoop loop;
    };
    std::vector<Entry> entries_;
};

/// Properties of instances, by every way there is in C++, and what watching them costs.
void add_tree_costs(CostTable& table);
/// Properties from Lua, beside the least that Lua can do.
void add_lua_costs(CostTable& table);

}  // namespace fettle::bench
