#include "costs/cost_table.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "measure/timing.h"

namespace fettle::bench {
namespace {

class Collector : public benchmark::BenchmarkReporter {
  public:
    bool ReportContext(const Context&) override { return true; }
    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs) {
            if (run.run_type == Run::RT_Iteration)
                times[run.run_name.function_name].push_back(run.run_name.time_type == "manual_time"
                                                                ? run.GetAdjustedRealTime()
                                                                : run.GetAdjustedCPUTime());
        }
    }
    std::map<std::string, std::vector<double>> times;  // ns per iteration
};

}  // namespace

void CostTable::add(Row row) {
    rows_.push_back(std::move(row));
}

void CostTable::add(std::string name, std::string against, double operations, CostLoop loop) {
    Row row{.name = std::move(name), .operations = operations, .loop = std::move(loop)};
    if (!against.empty()) row.against.push_back({std::move(against)});
    add(std::move(row));
}

void CostTable::keep(const std::string& text) {
    const auto meant = [&](const Row& row) { return row.name.find(text) != std::string::npos; };
    const auto needs = [&](const Row& row, const std::string& name) {
        const auto same = [&](const Against& against) { return against.row == name; };
        return std::ranges::any_of(row.against, same) ||
               std::ranges::find(row.without, name) != row.without.end();
    };
    std::vector<bool> kept(rows_.size());
    for (std::size_t i = 0; i < rows_.size(); ++i) kept[i] = meant(rows_[i]);
    if (std::ranges::find(kept, true) == kept.end())
        throw std::invalid_argument("no row has \"" + text + "\" in its name");
    // Repeated, because a required row may require another one.
    for (bool more = true; more;) {
        more = false;
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            for (std::size_t k = 0; k < rows_.size() && !kept[i]; ++k)
                if (kept[k] && needs(rows_[k], rows_[i].name)) kept[i] = more = true;
        }
    }
    std::vector<Row> left;
    for (std::size_t i = 0; i < rows_.size(); ++i)
        if (kept[i]) left.push_back(std::move(rows_[i]));
    rows_ = std::move(left);
}

std::vector<Cost> CostTable::run(int repetitions) const {
    std::string program = "fettle-bench";
    std::string interleaved = "--benchmark_enable_random_interleaving=true";
    std::string own_words[2] = {program, interleaved};
    char* arguments[] = {own_words[0].data(), own_words[1].data(), nullptr};
    int count = 2;
    benchmark::Initialize(&count, arguments);
    for (const Row& row : rows_) {
        auto* registered = benchmark::RegisterBenchmark(row.name.c_str(), row.loop)
                               ->Unit(benchmark::kNanosecond)
                               ->Repetitions(repetitions)
                               ->MinTime(0.03);
        if (row.own_clock) registered->UseManualTime();
    }
    Collector collector;
    benchmark::RunSpecifiedBenchmarks(&collector);
    benchmark::Shutdown();

    std::map<std::string, double> ns;
    for (const Row& row : rows_) {
        const auto found = collector.times.find(row.name);
        if (found == collector.times.end())
            throw std::runtime_error("\"" + row.name + "\" was not measured");
        ns[row.name] = median(found->second) / row.operations;
        for (const std::string& other : row.without) ns[row.name] -= ns.at(other);
    }
    std::vector<Cost> costs;
    for (const Row& row : rows_) {
        if (!row.shown) continue;
        Cost cost{row.name, ns.at(row.name)};
        for (const Against& against : row.against)
            if (const auto base = ns.find(against.row); base != ns.end())
                cost.comparisons.push_back({against.row, cost.ns / base->second, against.bound});
        costs.push_back(std::move(cost));
    }
    return costs;
}

}  // namespace fettle::bench
