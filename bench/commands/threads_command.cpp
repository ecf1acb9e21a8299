// `fettle-bench threads`: the speedup of a step, and of its stages, on several threads.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <numeric>
#include <stdexcept>

#include "commands/commands.h"
#include "engines/fettle_engine.h"
#include "measure/round_trip.h"
#include "measure/simulation.h"
#include "measure/timing.h"
#include "report/bounds.h"
#include "report/json_lines.h"
#include "report/progress.h"
#include "report/table.h"
#include "scenes/catalogue.h"

namespace fettle::bench {
namespace {

const Bound min_speedup = at_least(1.7);  // on two threads
constexpr int steps_a_turn = 100;  // in shorter turns, the waking of sleeping threads would count

constexpr std::array<const char*, 5> stage_names = {"pairs", "narrow", "solve", "finish", "other"};
using Stages = std::array<double, stage_names.size()>;  // ms

Stages stages_of(const physics::StepStatistics& s) {
    const float other = s.total_ms - s.pairs_ms - s.narrow_ms - s.solve_ms - s.finish_ms;
    return {static_cast<double>(s.pairs_ms), static_cast<double>(s.narrow_ms),
            static_cast<double>(s.solve_ms), static_cast<double>(s.finish_ms),
            static_cast<double>(other)};
}

/// A run of a scene on a number of threads, with the times of its steps and stages.
class TimedRun {
  public:
    TimedRun(const Scene& scene, int threads) : simulation_(scene, "fettle", make_fettle(scene)) {
        simulation_.engine().set_threads(threads);
        simulation_.advance(1);  // not counted, because the first step finds every pair
    }

    void advance(int steps) {
        for (int i = 0; i < steps; ++i) {
            ms_.push_back(simulation_.advance(1).wall_ms);
            const Stages now = stages_of(fettle_world(simulation_.engine()).statistics());
            for (std::size_t k = 0; k < now.size(); ++k) stages_[k] += now[k];
        }
    }

    int steps() const { return simulation_.steps(); }
    std::uint64_t hash() const { return simulation_.hash(); }
    double mean_ms() const {
        return std::accumulate(ms_.begin(), ms_.end(), 0.0) / static_cast<double>(ms_.size());
    }
    double median_ms() const { return median(ms_); }
    Stages stages() const {
        Stages mean = stages_;
        for (double& ms : mean) ms /= static_cast<double>(ms_.size());
        return mean;
    }

  private:
    Simulation simulation_;
    std::vector<double> ms_;
    Stages stages_ = {};
};

/// Result of one run, or the median of several.
struct ThreadsResult {
    double one_ms = 0, several_ms = 0;  // mean step
    double speedup = 0;                 // for the mean step
    double median_speedup = 0;          // less sensitive to other load
    double round_trip_ns = 0;           // the larger of the values before and after
    Stages one = {}, several = {};
};

ThreadsResult run_once(const Scene& scene, int threads, int run, Progress& progress) {
    TimedRun one(scene, 1), several(scene, threads);
    const double before = round_trip_ns();
    while (one.steps() < scene.steps) {
        const int steps = std::min(steps_a_turn, scene.steps - one.steps());
        const bool one_first = (one.steps() / steps_a_turn + run) % 2 == 0;
        (one_first ? one : several).advance(steps);
        (one_first ? several : one).advance(steps);
        progress.add(static_cast<double>(steps) / scene.steps);
    }
    if (one.hash() != several.hash())
        throw std::runtime_error(scene.name + ": ended in another state on " +
                                 std::to_string(threads) + " threads than on one");
    return {.one_ms = one.mean_ms(),
            .several_ms = several.mean_ms(),
            .speedup = one.mean_ms() / several.mean_ms(),
            .median_speedup = one.median_ms() / several.median_ms(),
            .round_trip_ns = std::max(before, round_trip_ns()),
            .one = one.stages(),
            .several = several.stages()};
}

/// The median of each figure by itself.
ThreadsResult median_of(const std::vector<ThreadsResult>& runs) {
    const auto of = [&](auto&& figure_of) {
        std::vector<double> values;
        for (const ThreadsResult& run : runs) values.push_back(figure_of(run));
        return median(values);
    };
    ThreadsResult result;
    for (double ThreadsResult::*figure :
         {&ThreadsResult::one_ms, &ThreadsResult::several_ms, &ThreadsResult::speedup,
          &ThreadsResult::median_speedup, &ThreadsResult::round_trip_ns})
        result.*figure = of([&](const ThreadsResult& run) { return run.*figure; });
    for (std::size_t k = 0; k < stage_names.size(); ++k) {
        result.one[k] = of([&](const ThreadsResult& run) { return run.one[k]; });
        result.several[k] = of([&](const ThreadsResult& run) { return run.several[k]; });
    }
    return result;
}

void print_json(const std::string& scene, int threads, int steps, const ThreadsResult& result) {
    std::cout << json_line({{"scene", scene},
                            {"threads", static_cast<long long>(threads)},
                            {"steps", static_cast<long long>(steps)},
                            {"one_ms", result.one_ms},
                            {"several_ms", result.several_ms},
                            {"speedup", result.speedup},
                            {"median_speedup", result.median_speedup},
                            {"round_trip_ns", result.round_trip_ns}})
              << "\n";
    for (std::size_t k = 0; k < stage_names.size(); ++k)
        std::cout << json_line({{"scene", scene},
                                {"threads", static_cast<long long>(threads)},
                                {"stage", std::string(stage_names[k])},
                                {"one_ms", result.one[k]},
                                {"several_ms", result.several[k]}})
                  << "\n";
    std::cout.flush();  // a long run may be interrupted
}

}  // namespace

int run_threads(const ThreadsOptions& options) {
    std::vector<const CatalogueEntry*> scenes;
    for (const std::string& name : options.scenes) scenes.push_back(&scene_named(name));
    for (const CatalogueEntry& entry : catalogue())
        if (options.scenes.empty()) scenes.push_back(&entry);

    const std::string several = "on " + std::to_string(options.threads);
    Verdict verdict("threads");
    Table speed({"ms a step", "on one", several, "times as fast", "bound", "median step",
                 "ns there and back"});
    std::vector<std::string> stage_headers = {"ms a stage"};
    for (const char* name : stage_names) {
        stage_headers.emplace_back(name);
        stage_headers.push_back(several);
    }
    Table stages(stage_headers);
    {
        Progress progress(static_cast<double>(scenes.size()) * options.runs);
        for (const CatalogueEntry* entry : scenes) {
            Scene scene = entry->make();
            if (options.steps > 0) scene.steps = options.steps;
            std::vector<ThreadsResult> runs;
            for (int run = 0; run < options.runs; ++run) {
                progress.begin(scene.name + ", run " + std::to_string(run + 1) + " of " +
                               std::to_string(options.runs));
                runs.push_back(run_once(scene, options.threads, run, progress));
            }
            const ThreadsResult result = median_of(runs);
            if (options.json) print_json(scene.name, options.threads, scene.steps, result);
            const Bound bound = options.threads == 2 ? min_speedup : Bound{};
            speed.add({scene.name, figure(result.one_ms), figure(result.several_ms),
                       verdict.mark(
                           scene.name, result.speedup, bound, figure(result.speedup),
                           "times as fast, " + figure(result.round_trip_ns) + " ns there and back"),
                       bound.text(), figure(result.median_speedup), figure(result.round_trip_ns)});
            std::vector<std::string> line = {scene.name};
            for (std::size_t k = 0; k < stage_names.size(); ++k) {
                line.push_back(figure(result.one[k]));
                line.push_back(figure(result.several[k]));
            }
            stages.add(std::move(line));
        }
    }
    if (!options.json) std::cout << speed.text() << "\n" << stages.text();
    verdict.print(options.json ? std::cerr : std::cout);
    return 0;
}

}  // namespace fettle::bench
