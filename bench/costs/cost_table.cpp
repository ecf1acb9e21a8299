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
                times[run.run_name.function_name].push_back(run.GetAdjustedCPUTime());
        }
    }
    std::map<std::string, std::vector<double>> times;  // ns an iteration
};

}  // namespace

void CostTable::add(std::string name, std::string against, double operations, CostLoop loop) {
    entries_.push_back({std::move(name), std::move(against), operations, std::move(loop)});
}

void CostTable::keep(const std::string& text) {
    const auto meant = [&](const Entry& entry) {
        return entry.name.find(text) != std::string::npos;
    };
    std::vector<Entry> kept;
    for (const Entry& entry : entries_) {
        const bool is_base = std::ranges::any_of(entries_, [&](const Entry& other) {
            return meant(other) && other.against == entry.name;
        });
        if (meant(entry) || is_base) kept.push_back(entry);
    }
    if (kept.empty()) throw std::invalid_argument("no row has \"" + text + "\" in its name");
    entries_ = std::move(kept);
}

std::vector<Cost> CostTable::run(int repetitions) const {
    std::string program = "fettle-bench";
    std::string interleaved = "--benchmark_enable_random_interleaving=true";
    std::string own_words[2] = {program, interleaved};
    char* arguments[] = {own_words[0].data(), own_words[1].data(), nullptr};
    int count = 2;
    benchmark::Initialize(&count, arguments);
    for (const Entry& entry : entries_) {
        benchmark::RegisterBenchmark(entry.name.c_str(), entry.loop)
            ->Unit(benchmark::kNanosecond)
            ->Repetitions(repetitions)
            ->MinTime(0.03);
    }
    Collector collector;
    benchmark::RunSpecifiedBenchmarks(&collector);
    benchmark::Shutdown();

    std::vector<Cost> costs;
    for (const Entry& entry : entries_) {
        const auto found = collector.times.find(entry.name);
        if (found == collector.times.end())
            throw std::runtime_error("\"" + entry.name + "\" was not measured");
        costs.push_back({entry.name, median(found->second) / entry.operations, entry.against});
    }
    for (Cost& cost : costs) {
        const auto base = std::ranges::find(costs, cost.against, &Cost::name);
        if (base != costs.end()) cost.ratio = cost.ns / base->ns;
    }
    return costs;
}

}  // namespace fettle::bench
